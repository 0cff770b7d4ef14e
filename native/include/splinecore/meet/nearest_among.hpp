#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "splinecore/meet/nearest.hpp"

namespace splinecore {

/// The nearest place of several shapes: on which of them it is, counted from 0, and where there.
template <class Place>
struct NearestAmong {
  std::size_t shape;
  Place place;
};

/// For each point the nearest one of several curves, as nearest() finds it on one: of curves that are as near, up to
/// rounding of the size of them all, on the first. A tree of their boxes leaves few of them to be searched, and each of
/// these only for places that are nearer than those known. Curves that lie wholly at infinity do not count.
/// @param out  as many as points
/// @throws InvalidShape if there are no curves; PointAtInfinity if all lie there; and as nearest().
void nearest_among(std::span<const NurbsCurve* const> curves, std::span<const glm::dvec3> points,
                   std::span<NearestAmong<NearestOnCurve>> out, int threads = 0);

/// The same of several patches.
void nearest_among(std::span<const NurbsPatch* const> patches, std::span<const glm::dvec3> points,
                   std::span<NearestAmong<NearestOnPatch>> out, int threads = 0);

}  // namespace splinecore
