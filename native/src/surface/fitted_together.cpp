#include "fitted_together.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "build/fit_options.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/continuity.hpp"

namespace splinecore {

namespace {

/// About `spans` of them, even between corners, which are knots as often as the degree.
KnotVector knots_between(const FitTogether& what, int spans) {
  const auto& [count, degree, domain, is_periodic, corners, tolerance] = what;
  std::vector<double> breaks{domain.start};
  bool has_corner_at_seam = false;
  for (const double corner : corners) {
    const bool is_inside = corner > domain.start && corner < domain.end;
    if (is_inside) breaks.push_back(corner);
    has_corner_at_seam = has_corner_at_seam || !is_inside;
  }
  breaks.push_back(domain.end);
  std::vector<double> knots(is_periodic ? has_corner_at_seam ? degree : 1 : degree + 1, domain.start);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double length = breaks[i + 1] - breaks[i];
    const int pieces = std::max(1, static_cast<int>(std::round(spans * (length / domain.length()))));
    for (int k = 1; k < pieces; ++k) knots.push_back(breaks[i] + length * k / pieces);
    const bool is_end = i + 2 == breaks.size();
    knots.insert(knots.end(), !is_end ? degree : is_periodic ? 1 : degree + 1, breaks[i + 1]);
  }
  return KnotVector::make(degree, std::move(knots), is_periodic);
}

Approximation<std::vector<NurbsCurve>> with_spans(int spans, const FitTogether& what, const FitOne& fit) {
  const KnotVector knots = knots_between(what, spans);
  Approximation<std::vector<NurbsCurve>> made{{}, 0.0};
  for (std::size_t i = 0; i < what.count && made.error <= what.tolerance; ++i) {
    Approximation<NurbsCurve> one = fit(i, knots);
    made.value.push_back(std::move(one.value));
    made.error = std::max(made.error, one.error);
  }
  return made;
}

}  // namespace

std::vector<double> corners_of(std::span<const NurbsCurve> curves) {
  constexpr double kSame = 0x1p-30;
  std::vector<double> found;
  for (const NurbsCurve& curve : curves) {
    for (const Joint& joint : joints(curve)) {
      if (joint.continuity.g <= 0) found.push_back(joint.u);
    }
  }
  std::ranges::sort(found);
  const double same = kSame * curves[0].domain().length();
  const auto repeated = std::ranges::unique(found, [&](double a, double b) { return b - a <= same; });
  found.erase(repeated.begin(), repeated.end());
  return found;
}

Approximation<std::vector<NurbsCurve>> fitted_together(const FitTogether& what, const FitOne& fit) {
  constexpr int kMostSpans = 4096;
  require_tolerance(what.tolerance);
  int low = 0;
  int high = what.is_periodic ? what.degree : 1;
  auto best = with_spans(high, what, fit);
  while (best.error > what.tolerance) {
    if (high >= kMostSpans) {
      throw ToleranceNotReached("the curves cannot be had with " + std::to_string(high) + " spans", what.tolerance, best.error);
    }
    low = high;
    high *= 2;
    best = with_spans(high, what, fit);
  }
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    if (what.is_periodic && middle < what.degree) break;
    auto made = with_spans(middle, what, fit);
    if (made.error <= what.tolerance) {
      high = middle;
      best = std::move(made);
    } else {
      low = middle;
    }
  }
  return best;
}

}  // namespace splinecore
