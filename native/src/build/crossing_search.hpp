#pragma once

#include <array>
#include <exception>
#include <glm/vec3.hpp>
#include <vector>

#include "beside_both.hpp"
#include "offset_box.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Neither an arc was found, nor that there is none.
struct CrossingUndecided : std::exception {
  explicit CrossingUndecided(const glm::dvec3& place) : center(place) {}

  glm::dvec3 center;
};

/// Whether curves are touched by an arc about a place, by halving: pairs of parts whose offsets are seen to lie apart have none, in
/// others Newton's method finds one, or they are halved on to the last digits of their parameters. What has no tangent there is
/// touched by none.
class CrossingSearch {
 public:
  CrossingSearch(const NurbsCurve& a, const NurbsCurve& b, const glm::dvec3& normal, const std::array<double, 2>& sides);

  /// @throws CrossingUndecided after 2^14 pairs
  std::vector<Fillet> near(const glm::dvec3& center) const;

 private:
  PlaneView view_;
  BesideBoth both_;
  double radius_;
  double reach_;  ///< how far from a crossing of offsets that are not exact the right one may be
  std::vector<OffsetBox> beside_a_;
  std::vector<OffsetBox> beside_b_;
};

}  // namespace splinecore
#pragma GCC visibility pop
