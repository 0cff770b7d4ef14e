#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// What a Hermite patch knows at each of its corners, row after row of count_v.
struct HermiteNet {
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> tangents_u;
  std::vector<glm::dvec3> tangents_v;
  /// Mixed derivatives S_uv; all zero gives Ferguson's patch.
  std::vector<glm::dvec3> twists;
  friend bool operator==(const HermiteNet&, const HermiteNet&) = default;
};

/// A grid of bicubic patches with given points, tangents and twists (lecture row S20; Ferguson 1964).
///
/// Derivatives are with respect to the patch's parameters. C1 in both directions.
class HermitePatch {
 public:
  /// @param net  empty twists mean zero
  /// @param parameters_u, parameters_v  increasing; empty means 0, 1, 2, …
  /// @throws InvalidShape if a direction has fewer than 2 points, counts disagree, a number is
  ///         not finite, or parameters do not increase.
  static HermitePatch make(int count_u, int count_v, HermiteNet net,
                           std::vector<double> parameters_u = {},
                           std::vector<double> parameters_v = {});

  /// The patch with another net of the same size, on the knot vectors that this one has. @throws as make().
  HermitePatch with_net(HermiteNet net) const;

  int count(Axis axis) const noexcept { return static_cast<int>(parameters(axis).size()); }
  const HermiteNet& net() const noexcept { return net_; }
  std::span<const double> parameters(Axis axis) const noexcept {
    return axis == Axis::u ? parameters_u_ : parameters_v_;
  }

  /// The same patch as bicubic NURBS with triple knots at the corners.
  const NurbsPatch& nurbs() const noexcept { return form_; }

  friend bool operator==(const HermitePatch& a, const HermitePatch& b) noexcept {
    return a.net_ == b.net_ && a.parameters_u_ == b.parameters_u_ && a.parameters_v_ == b.parameters_v_;
  }

 private:
  HermitePatch(HermiteNet net, std::vector<double> parameters_u, std::vector<double> parameters_v, NurbsPatch form);

  HermiteNet net_;
  std::vector<double> parameters_u_;
  std::vector<double> parameters_v_;
  NurbsPatch form_;
};

/// The parts before and after a parameter of one direction.
std::pair<HermitePatch, HermitePatch> split(const HermitePatch& patch, Axis axis, double u);

HermitePatch reversed(const HermitePatch& patch, Axis axis);
HermitePatch swapped(const HermitePatch& patch);

}  // namespace splinecore
