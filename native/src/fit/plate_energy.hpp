#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "plate_direction.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

// Of nets of control points, those along `columns` one after the other.

/// The product of a net with the means of products of derivatives of these orders, each half of it by differences of
/// control points.
std::vector<glm::dvec3> plate_product(const PlateDirection& rows, const PlateDirection& columns,
                                      std::array<std::size_t, 2> orders, std::span<const glm::dvec3> net);

/// Half the slope of the mean of S_uu² + 2 S_uv² + S_vv². Of a plane at an even pace it is zero, up to rounding of the
/// differences.
std::vector<glm::dvec3> plate_bending(const PlateDirection& rows, const PlateDirection& columns,
                                      std::span<const glm::dvec3> net);

}  // namespace splinecore
#pragma GCC visibility pop
