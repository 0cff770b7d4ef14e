#pragma once

#include <cstddef>
#include <vector>

#include "boxed_pieces.hpp"
#include "near_ray.hpp"
#include "plane_zeros.hpp"
#include "splinecore/meet/rays.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Looks for the places where rays meet a patch, one ray after the other, in memory of its own.
class RaySearch {
 public:
  explicit RaySearch(const NurbsPatch& patch, std::size_t number = 0);

  /// All places within limits, not in order. @param index  of the ray, for errors
  const std::vector<RayHit>& all(const Ray& ray, std::size_t index, const Interval& limits);

  /// The first one, or none if nothing is as near as the limits' end.
  const std::vector<RayHit>& first(const Ray& ray, std::size_t index, const Interval& limits);

 private:
  using Place = std::array<double, 2>;

  /// The parts that may be met within limits, the nearest first.
  void gather(const NearRay& ray, const Interval& limits);
  /// @returns false where zeros cannot be told apart
  bool look_into(const NearRay& ray, std::size_t part, const Interval& limits);
  void offer(const NearRay& ray, std::size_t part, Place at, const Interval& limits);
  /// Replaces what was found by what intersections() finds.
  void intersect(const Ray& ray, const NearRay& near, std::size_t index, const Interval& limits);
  void keep(const RayHit& hit, double slack, const Interval& limits);
  void keep_first();
  bool are_one(const RayHit& a, const RayHit& b, double slack) const;

  const NurbsPatch& patch_;
  const BoxedPieces& pieces_;
  std::size_t number_;
  const Kernels& kernels_ = kernels();
  std::vector<std::vector<BoxOnRay>> waiting_;
  std::vector<BoxOnRay> groups_;
  std::vector<BoxOnRay> parts_;
  SlopeForm a_;
  SlopeForm b_;
  std::vector<RayHit> hits_;
};

}  // namespace splinecore
#pragma GCC visibility pop
