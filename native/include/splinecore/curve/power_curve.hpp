#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// A polynomial or rational curve by its coefficients: Q(t) = sum c_k (t - origin)^k (lecture row S2).
///
/// A coefficient is homogeneous: (x, y, z, w) where the w are those of the denominator, 1, 0, 0, … for a
/// polynomial. The curve is evaluated through its Bernstein form, whose points are right to an ulp of the
/// largest one. Powers of a far origin are ill-conditioned: coefficients that were rounded when they were
/// made leave an error of sum |c_k| |t - origin|^k ulp, which no later computation can mend.
class PowerCurve {
 public:
  /// @throws InvalidShape if there are fewer than 2 or more than kMaxDegree + 1 coefficients, a number is
  ///         not finite, every w is zero, the domain has no length, or the control points overflow.
  static PowerCurve make(std::vector<glm::dvec4> coefficients, double origin = 0.0, Interval domain = {});

  int degree() const noexcept { return form_.degree(); }
  double origin() const noexcept { return origin_; }
  Interval domain() const noexcept { return domain_; }

  /// Homogeneous, lowest power first.
  std::span<const glm::dvec4> coefficients() const noexcept { return coefficients_; }

  /// True where the denominator is 1.
  bool polynomial() const noexcept;

  /// The same curve as NURBS: one clamped span on the domain.
  const NurbsCurve& nurbs() const noexcept { return form_; }

  friend bool operator==(const PowerCurve& a, const PowerCurve& b) noexcept {
    return a.coefficients_ == b.coefficients_ && a.origin_ == b.origin_ && a.domain_ == b.domain_;
  }

 private:
  PowerCurve(std::vector<glm::dvec4> coefficients, double origin, Interval domain, NurbsCurve form)
      : coefficients_(std::move(coefficients)), origin_(origin), domain_(domain), form_(std::move(form)) {}

  std::vector<glm::dvec4> coefficients_;
  double origin_;
  Interval domain_;
  NurbsCurve form_;
};

/// The same curve in powers of t - origin. @throws InvalidShape if the origin is not finite or they overflow.
PowerCurve with_origin(const PowerCurve& curve, double origin);

/// The same coefficients on another domain.
PowerCurve with_domain(const PowerCurve& curve, Interval domain);

/// The curve Q'(t), by differentiating the monomials; of a rational curve (X'W - XW') / W^2, of twice the
/// degree. The derivative of a line keeps degree 1, with a second coefficient of zero.
/// @throws InvalidShape if the degree would pass kMaxDegree.
PowerCurve derivative(const PowerCurve& curve);

/// The parts before and after u: the same coefficients, each on its part of the domain.
/// @throws InvalidShape unless u lies strictly inside the domain.
std::pair<PowerCurve, PowerCurve> split(const PowerCurve& curve, double u);

/// The same points in the opposite direction, over the same domain; about the mirrored origin.
PowerCurve reversed(const PowerCurve& curve);

}  // namespace splinecore
