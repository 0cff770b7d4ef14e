#include "fitted_together.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "knot_density.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/continuity.hpp"

namespace splinecore {

namespace {

/// How near, as a part of the domain, knots all but coincide, and creases are one.
constexpr double kNear = 0x1p-30;

/// In order, each once; none of more than can be, where even spans do as well.
std::vector<Crease> told_apart(std::vector<Crease> creases, double near) {
  constexpr std::size_t kMost = 256;
  std::ranges::sort(creases, {}, &Crease::at);
  std::vector<Crease> found;
  for (const Crease& one : creases) {
    if (found.empty() || one.at - found.back().at > near) {
      found.push_back(one);
    } else {
      found.back().times = std::max(found.back().times, one.times);
    }
  }
  if (found.size() > kMost) std::erase_if(found, [](const Crease& one) { return one.times < 2; });
  if (found.size() > kMost) found.clear();
  return found;
}

/// Corners, and the creases that are near to none of them.
std::vector<Crease> breaks_of(const FitTogether& what) {
  const double near = kNear * what.domain.length();
  std::vector<Crease> found;
  for (const double corner : what.corners) found.push_back({corner, what.degree});
  for (const Crease& crease : told_apart(what.creases, near)) {
    const auto is_near = [&](double place) { return std::abs(place - crease.at) <= near; };
    const bool is_seam = is_near(what.domain.start) || is_near(what.domain.end);
    if (std::ranges::none_of(what.corners, is_near)) found.push_back({is_seam ? what.domain.start : crease.at, crease.times});
  }
  std::ranges::sort(found, {}, &Crease::at);
  return found;
}

/// About `spans` of them between corners, which are knots as often as the degree, and creases: even, or as dense as is wanted.
KnotVector knots_between(const FitTogether& what, const KnotDensity& density, int spans) {
  constexpr int kLeastUneven = 4;
  const int degree = what.degree;
  const Interval domain = what.domain;
  std::vector<Crease> breaks{{domain.start, what.is_periodic ? 1 : degree + 1}};
  for (const Crease& one : breaks_of(what)) {
    const bool is_inside = one.at > domain.start && one.at < domain.end;
    if (is_inside) breaks.push_back(one);
    if (!is_inside) breaks.front().times = std::max(breaks.front().times, one.times);
  }
  breaks.push_back({domain.end, what.is_periodic ? 1 : degree + 1});
  std::vector<double> knots(breaks.front().times, domain.start);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double from = breaks[i].at;
    const double to = breaks[i + 1].at;
    const double part = density.is_even() ? (to - from) / domain.length() : density.share(from, to);
    const int pieces = std::max(density.is_even() ? 1 : kLeastUneven, static_cast<int>(std::round(spans * part)));
    std::ranges::copy(density.parted(from, to, pieces), std::back_inserter(knots));
    knots.insert(knots.end(), breaks[i + 1].times, breaks[i + 1].at);
  }
  return KnotVector::make(degree, std::move(knots), what.is_periodic);
}

/// Looks for the fewest spans on which one curve after the other comes within the tolerance. Of many curves the few that
/// need more than all before them are looked for alone.
class Together {
 public:
  Together(const FitTogether& what, const FitOne& fit) : what_(what), fit_(fit), settled_(what.domain), density_(what.domain) {
    breaks_ = {what.domain.start, what.domain.end};
    for (const Crease& one : breaks_of(what)) breaks_.push_back(one.at);
    std::ranges::sort(breaks_);
  }

  Approximation<std::vector<NurbsCurve>> found() {
    std::size_t hardest = 0;
    for (;;) {
      enlarge_for(hardest);
      const std::optional<std::size_t> missed = first_missed(hardest);
      if (!missed) break;
      hardest = *missed;
    }
    Approximation<std::vector<NurbsCurve>> made{{}, 0.0};
    for (Approximation<NurbsCurve>& one : made_) {
      made.error = std::max(made.error, one.error);
      made.value.push_back(std::move(one.value));
    }
    return made;
  }

 private:
  static constexpr int kMostSpans = 4096;
  static constexpr int kMostEven = 32;

  Approximation<NurbsCurve> with_spans(std::size_t i, int spans) const {
    return fit_(i, knots_between(what_, density_, spans));
  }
  bool is_within(const Approximation<NurbsCurve>& one) const { return one.error <= what_.tolerance; }

  /// Of many spans those that follow are as dense as the curve wants them, and those before it.
  void densify(const NurbsCurve& curve) {
    density_ = settled_;
    density_.take(curve, breaks_);
  }

  /// Until curve i comes within the tolerance: by steps that double, then by halving. At `missed_` spans one curve does not.
  void enlarge_for(std::size_t i) {
    const int least = what_.is_periodic ? what_.degree : 1;
    int high = std::max(missed_ + 1, least);
    int step = 1;
    auto best = with_spans(i, high);
    while (!is_within(best)) {
      if (high >= kMostSpans) {
        throw ToleranceNotReached("the curves cannot be fitted with " + std::to_string(high) + " spans", what_.tolerance, best.error);
      }
      step = missed_ == 0 ? high : 2 * step;
      missed_ = high;
      if (high >= kMostEven) densify(best.value);
      high = std::min(kMostSpans, high + step);
      best = with_spans(i, high);
    }
    while (high - missed_ > 1) {
      const int middle = missed_ + (high - missed_) / 2;
      if (middle < least) break;
      auto made = with_spans(i, middle);
      if (is_within(made)) {
        high = middle;
        best = std::move(made);
      } else {
        missed_ = middle;
      }
    }
    spans_ = high;
    settled_ = density_;
    made_.assign(what_.count, best);
  }

  /// Makes all others on as many spans. @returns the first that does not come within the tolerance
  std::optional<std::size_t> first_missed(std::size_t made) {
    const KnotVector knots = knots_between(what_, density_, spans_);
    for (std::size_t i = 0; i < what_.count; ++i) {
      if (i == made) continue;
      made_[i] = fit_(i, knots);
      if (is_within(made_[i])) continue;
      missed_ = spans_;
      return i;
    }
    return {};
  }

  const FitTogether& what_;
  const FitOne& fit_;
  KnotDensity settled_;          ///< that of the hardest curves so far
  KnotDensity density_;
  std::vector<double> breaks_;   ///< in order
  int missed_ = 0;
  int spans_ = 0;
  std::vector<Approximation<NurbsCurve>> made_;
};

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

std::vector<Crease> creases_of(const NurbsCurve& curve, int degree) {
  const Interval domain = curve.domain();
  const auto knots = curve.knot_vector().knots();
  std::vector<Crease> found;
  for (std::size_t i = 0; i < knots.size();) {
    std::size_t end = i + 1;
    while (end < knots.size() && knots[end] - knots[i] <= kNear * domain.length()) ++end;
    const int times = degree - curve.degree() + static_cast<int>(end - i);
    const double at = 0.5 * (knots[i] + knots[end - 1]);
    const bool is_inside = at < domain.end && (curve.periodic() ? at >= domain.start : at > domain.start);
    const bool is_one_knot = knots[end - 1] == knots[i];
    if (times > 0 && is_inside) found.push_back({at, std::min(times, is_one_knot ? degree - 1 : degree)});
    i = end;
  }
  return found;
}

Approximation<std::vector<NurbsCurve>> fitted_together(const FitTogether& what, const FitOne& fit) {
  require_positive(what.tolerance);
  return Together(what, fit).found();
}

}  // namespace splinecore
