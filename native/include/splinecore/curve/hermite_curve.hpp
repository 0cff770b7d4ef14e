#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The two derivatives of a chain at one of its points. Where they differ the chain has a corner.
struct Tangents {
  glm::dvec3 incoming;
  glm::dvec3 outgoing;
  friend bool operator==(const Tangents&, const Tangents&) = default;
};

/// A chain of cubic segments through points with given derivatives (lecture row S4).
///
/// Tangents are derivatives with respect to the chain's parameter. The first incoming and the
/// last outgoing one shape nothing, but are kept.
class HermiteCurve {
 public:
  /// @param parameters  one for each point, increasing; empty means 0, 1, 2, …
  /// @throws InvalidShape if there are fewer than 2 points, counts disagree, a number is not
  ///         finite, or the parameters do not increase.
  static HermiteCurve make(std::vector<glm::dvec3> points, std::vector<Tangents> tangents,
                           std::vector<double> parameters = {});

  std::span<const glm::dvec3> points() const noexcept { return points_; }
  std::span<const Tangents> tangents() const noexcept { return tangents_; }
  std::span<const double> parameters() const noexcept { return parameters_; }

  /// The same curve as a cubic NURBS with triple knots at the points.
  const NurbsCurve& nurbs() const noexcept { return form_; }

  friend bool operator==(const HermiteCurve& a, const HermiteCurve& b) noexcept {
    return a.points_ == b.points_ && a.tangents_ == b.tangents_ && a.parameters_ == b.parameters_;
  }

 private:
  HermiteCurve(std::vector<glm::dvec3> points, std::vector<Tangents> tangents,
               std::vector<double> parameters);

  std::vector<glm::dvec3> points_;
  std::vector<Tangents> tangents_;
  std::vector<double> parameters_;
  NurbsCurve form_;
};

/// The parts before and after u.
/// @throws InvalidShape unless u lies strictly inside the domain.
std::pair<HermiteCurve, HermiteCurve> split(const HermiteCurve& curve, double u);

HermiteCurve reversed(const HermiteCurve& curve);

}  // namespace splinecore
