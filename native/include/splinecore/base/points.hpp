#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace splinecore {

// Rows of points are handed over as plain doubles, four to a point.
static_assert(sizeof(glm::dvec4) == 4 * sizeof(double) && alignof(glm::dvec4) == alignof(double));

/// (wx, wy, wz, w) of a point given as (x, y, z, w); a direction (w = 0) stays as it is.
inline glm::dvec4 homogeneous(const glm::dvec4& given) noexcept {
  const double w = given.w;
  return w == 0.0 || w == 1.0 ? given : glm::dvec4(given.x * w, given.y * w, given.z * w, w);
}

/// (x, y, z, w) of a homogeneous point; the inverse of homogeneous() up to rounding.
inline glm::dvec4 as_given(const glm::dvec4& point) noexcept {
  const double w = point.w;
  return w == 0.0 || w == 1.0 ? point : glm::dvec4(point.x / w, point.y / w, point.z / w, w);
}

std::vector<glm::dvec4> homogeneous(std::span<const glm::dvec4> given);
std::vector<glm::dvec4> as_given(std::span<const glm::dvec4> points);

/// What weights are divided by in the homogeneous form of a shape, as an exponent of two: then the largest is about 1,
/// so that products stay in the range of numbers, and where it can be none is so small that it loses digits.
int weight_exponent(std::span<const glm::dvec4> given) noexcept;

/// homogeneous() of the points with weights, or directions, divided by that power of two: the same points.
std::vector<glm::dvec4> homogeneous(std::span<const glm::dvec4> given, int exponent);

/// homogeneous() of all. @throws InvalidShape naming a point that its weight makes too large for a number.
/// @param row_length  0 for a row of points, otherwise the length of a net's rows
std::vector<glm::dvec4> finite_homogeneous(std::span<const glm::dvec4> given, std::size_t row_length = 0);

/// True unless every w is 1.
bool is_rational(std::span<const glm::dvec4> points) noexcept;

/// Largest distance between two opposite corners of the box of the finite points (w != 0).
double extent(std::span<const glm::dvec4> points) noexcept;

/// Largest |x|, |y| or |z| of the finite points: what rounding is relative to.
double largest_coordinate(std::span<const glm::dvec4> points) noexcept;

/// @throws InvalidShape if a number is not finite, or every w is zero.
/// @param row_length  0 for a row of points, otherwise the length of a net's rows
void require_points(std::span<const glm::dvec4> points, std::size_t row_length = 0);

}  // namespace splinecore
