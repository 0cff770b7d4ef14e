#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws InvalidShape naming `argument` and its index if one of three coordinates is not finite.
/// @param row_length  0 for a row of points, otherwise the length of a net's rows
void require_coordinates(const double* xyz, const std::string& argument, std::size_t index, std::size_t row_length);

/// @throws InvalidShape naming `argument` if a number is not finite.
void require_finite(std::span<const double> values, const std::string& argument);

/// @throws InvalidShape naming `argument` if a coordinate is not finite.
void require_finite(std::span<const glm::dvec3> vectors, const std::string& argument,
                    std::size_t row_length = 0);

/// @throws InvalidShape naming `argument` if a number is not finite or not above the one before it, or if the last is too
///         far from the first.
void require_increasing(std::span<const double> values, const std::string& argument);

/// @throws InvalidShape unless it is 0 or more.
void require_tolerance(double tolerance);

/// @throws InvalidShape naming it unless it is a positive, finite length.
void require_positive(double length, const std::string& name = "tolerance");

}  // namespace splinecore
#pragma GCC visibility pop
