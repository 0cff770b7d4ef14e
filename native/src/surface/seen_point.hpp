#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point from which a closed border is seen whole, which runs round it once and to the left: the middle of all such points.
/// None if there is none. That of tangents at places is proved by Bernstein coefficients.
/// @param pieces  homogeneous Bezier pieces (wx, wy, w) about 1 large, end to end, with weights above 0
std::optional<glm::dvec2> point_seeing(const std::vector<std::vector<glm::dvec3>>& pieces);

/// The value of such a piece.
glm::dvec2 place_on(const std::vector<glm::dvec3>& piece, double t);

}  // namespace splinecore
#pragma GCC visibility pop
