#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "near_distance.hpp"
#include "near_space.hpp"
#include "slopes.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place in one of the pieces of a patch.
struct PiecePlace {
  std::array<std::size_t, 2> piece;  ///< spans along u and v
  std::array<double, 2> at;          ///< in [0, 1]²
};

/// The pieces of a patch in a space of their own, and a point there.
class NearPatch {
 public:
  /// @throws InvalidShape if the point is not finite.
  NearPatch(const NurbsPatch& patch, const glm::dvec3& point);

  const KnotVector& knots(Axis axis) const noexcept { return axis == Axis::u ? u_ : v_; }
  std::size_t spans(Axis axis) const noexcept { return knots(axis).spans().size(); }
  Interval span(Axis axis, std::size_t i) const noexcept { return knots(axis).span_interval(static_cast<int>(i)); }

  /// Whether it goes on at the end of an axis where it begins: it is periodic, or both borders are one, with weights in
  /// one proportion.
  bool is_closed(Axis axis) const noexcept { return is_closed_[static_cast<std::size_t>(axis)]; }

  /// Its weights are near 1, or all zero.
  const BernsteinNet<glm::dvec4>& net(const std::array<std::size_t, 2>& piece) const noexcept {
    return nets_[piece[0] * spans(Axis::v) + piece[1]];
  }

  const NearOrigin& origin() const noexcept { return from_; }
  const glm::dvec3& point() const noexcept { return from_.near().at; }

  /// How much of a coordinate may be rounding.
  double rounding() const noexcept { return space_.rounding(); }

  /// A length as the near space has it; infinite where it is no number.
  double near_length(double length) const noexcept;

  Slopes<2> slopes(const PiecePlace& place) const noexcept;
  std::array<double, 2> parameters(const PiecePlace& place) const noexcept;

 private:
  bool closes(Axis axis) const;

  NearSpace space_;
  KnotVector u_;
  KnotVector v_;
  std::vector<BernsteinNet<glm::dvec4>> nets_;
  NearOrigin from_;
  std::array<bool, 2> is_closed_;
};

}  // namespace splinecore
#pragma GCC visibility pop
