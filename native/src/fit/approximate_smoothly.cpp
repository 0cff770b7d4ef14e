#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/approximate.hpp"

namespace splinecore {

namespace {

/// Fits with ever other weights of smoothing.
class SmoothFits {
 public:
  SmoothFits(std::span<const glm::dvec3> points, std::span<const double> parameters, const KnotVector& knots,
             const ApproximationOptions& options)
      : points_(points), parameters_(parameters), knots_(knots), options_(options) {
    const double length = knots.domain().length();
    unit_ = length * length * length * static_cast<double>(points.size());
  }

  Approximation<NurbsCurve> rough() { return made(0.0); }

  /// @param exponent  of two, by which that of the smoothing differs from what goes with the points and the domain
  Approximation<NurbsCurve> smooth(double exponent) { return made(unit_ * std::exp2(exponent)); }

  /// A residual that is no more than rounding of the points.
  double rounding() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double off = kRoundingOfShape * std::max({std::abs(points_[i].x), std::abs(points_[i].y), std::abs(points_[i].z)});
      sum += (options_.weights.empty() ? 1.0 : options_.weights[i]) * off * off;
    }
    return sum;
  }

  double residual_of(const NurbsCurve& curve) const {
    std::vector<glm::dvec3> at(points_.size());
    evaluate(curve, parameters_.first(at.size()), std::span(&at[0].x, 3 * at.size()));
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const glm::dvec3 offset = at[i] - points_[i];
      const double weight = options_.weights.empty() ? 1.0 : options_.weights[i];
      sum += weight * (offset.x * offset.x + offset.y * offset.y + offset.z * offset.z);
    }
    return sum;
  }

 private:
  Approximation<NurbsCurve> made(double smoothing) {
    options_.smoothing = smoothing;
    return approximate(points_, parameters_, knots_, options_);
  }

  std::span<const glm::dvec3> points_;
  std::span<const double> parameters_;
  const KnotVector& knots_;
  ApproximationOptions options_;
  double unit_;
};

}  // namespace

Approximation<NurbsCurve> approximate_smoothly(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                               const KnotVector& knots, double residual,
                                               const ApproximationOptions& options) {
  if (!(residual >= 0.0) || !std::isfinite(residual)) {
    throw InvalidShape("residual = " + text_of(residual) + " is not 0 or more");
  }
  if (options.smoothing != 0.0 || options.corrections != 0) {
    throw InvalidShape("residual is given, and so neither smoothing nor corrections");
  }
  constexpr double kLeast = -100.0;
  constexpr double kMost = 10.0;
  constexpr double kNear = 0x1p-10;
  SmoothFits fits(points, parameters, knots, options);
  Approximation<NurbsCurve> best = fits.rough();
  const double least = fits.residual_of(best.value);
  if (least <= fits.rounding() && least > residual) return best;
  if (least > residual) {
    throw ToleranceNotReached("the points cannot be approximated by " + std::to_string(knots.count()) +
                                  " control points with this residual", residual, least);
  }
  double rough = kLeast;
  double smooth = kMost;
  while (smooth - rough > kNear) {
    const double middle = 0.5 * (rough + smooth);
    Approximation<NurbsCurve> found = fits.smooth(middle);
    if (fits.residual_of(found.value) <= residual) {
      best = std::move(found);
      rough = middle;
    } else {
      smooth = middle;
    }
  }
  return best;
}

}  // namespace splinecore
