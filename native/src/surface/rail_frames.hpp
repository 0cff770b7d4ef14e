#pragma once

#include <span>
#include <vector>

#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/surface/sweep.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where a section is put on its rail.
struct RailPlace {
  glm::dvec3 point;
  MovingFrame frame;
};

/// The places of a rail, about 1 large, at parameters of it; those at the end of the interval are from before it.
/// @throws InvalidShape as sweep()
std::vector<RailPlace> rail_places(const NurbsCurve& rail, std::span<const double> at, const Interval& stretch,
                                   const SweepOptions& options);

/// In the directions of a frame, from its place.
inline glm::dvec3 in_frame(const MovingFrame& frame, const glm::dvec3& q) {
  return q.x * frame.normal + q.y * frame.binormal + q.z * frame.tangent;
}

}  // namespace splinecore
#pragma GCC visibility pop
