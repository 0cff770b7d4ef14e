#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "patch_pieces.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What of parameters is outside of a range comes to its border.
std::array<double, 2> held(const std::array<double, 2>& at, const std::array<Interval, 2>& range);

/// The nearest place of a part of a piece whose normals hardly differ to a point, with its borders.
PatchSpot foot_in(const PatchPieces& patch, PatchSpot at, const std::array<Interval, 2>& range, const glm::dvec3& point);

/// Of a patch the place nearest to a point, in its piece and those beyond its sides, and over a pole.
PatchSpot patch_foot(const PatchPieces& patch, PatchSpot at, const glm::dvec3& point);

}  // namespace splinecore
#pragma GCC visibility pop
