#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Weights, or directions, divided by a power of two: the same points, if all of a shape are.
std::vector<glm::dvec4> with_weights_divided(std::span<const glm::dvec4> given, int exponent);

/// as_given() of homogeneous points whose w are 1 but for rounding: they come out 1.
std::vector<glm::dvec4> as_given_polynomial(std::span<const glm::dvec4> points);

/// The points of a shape and those that were made of its homogeneous ones, as given. Weights that were all 1 are 1
/// again: what is polynomial stays so. Weights have the size of the old ones, unless a new one would lose digits so: then
/// all stay divided by a power of two.
struct GivenPoints {
  std::vector<glm::dvec4> made;
  std::span<const glm::dvec4> old;  ///< of the shape itself, or of `divided`
  std::vector<glm::dvec4> divided;
};
GivenPoints as_given_from(std::span<const glm::dvec4> old, bool is_rational, int exponent,
                          std::span<const glm::dvec4> homogeneous_points);

/// The same of a curve or a patch.
template <class Shape>
GivenPoints as_given_from(const Shape& shape, std::span<const glm::dvec4> homogeneous_points) {
  return as_given_from(shape.points(), shape.rational(), shape.weight_exponent(), homogeneous_points);
}

/// @param before, after  homogeneous, up to one factor
/// @throws InvalidShape if a point that was made anew is not what it was: weights are so different that it was lost in the
///         rounding of the others.
void require_same(std::span<const glm::dvec4> before, std::span<const glm::dvec4> after);

}  // namespace splinecore
#pragma GCC visibility pop
