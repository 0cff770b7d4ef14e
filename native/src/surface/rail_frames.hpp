#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "measure/carried_frames.hpp"
#include "meet/near_space.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/surface/sweep.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where a section is put on its rail.
struct RailPlace {
  glm::dvec3 point;
  MovingFrame frame;
};

/// The places of a rail, about 1 large; what it is made of must stay.
class RailPlaces {
 public:
  /// @throws InvalidShape as sweep()
  RailPlaces(const NurbsCurve& rail, const SweepOptions& options)
      : rail_(rail), options_(options), frames_(rail, {options.start, rail.periodic()}) {}

  /// At parameters; those at the end of the interval are from before it. @throws InvalidShape as sweep()
  std::vector<RailPlace> at(std::span<const double> parameters, const Interval& stretch);

 private:
  void write_frames(std::span<const double> parameters, Side side, std::span<MovingFrame> out);

  const NurbsCurve& rail_;
  const SweepOptions& options_;
  CarriedFrames frames_;
};

/// In the directions of a frame, from its place.
inline glm::dvec3 in_frame(const MovingFrame& frame, const glm::dvec3& q) {
  return q.x * frame.normal + q.y * frame.binormal + q.z * frame.tangent;
}

/// What puts a section there, whose place is seen in a space of its own: x, y, z and the point as columns.
inline glm::dmat4 matrix_of(const RailPlace& place, const NearSpace& space) {
  const auto& [tangent, normal, binormal] = place.frame;
  return {glm::dvec4(normal, 0.0), glm::dvec4(binormal, 0.0), glm::dvec4(tangent, 0.0), glm::dvec4(space.leave(place.point), 1.0)};
}

}  // namespace splinecore
#pragma GCC visibility pop
