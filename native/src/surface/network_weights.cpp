#include "network_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/positive_weights.hpp"
#include "base/quotient.hpp"
#include "fit/project_smooth.hpp"
#include "fit/row_spline.hpp"
#include "fitted_together.hpp"
#include "greville.hpp"
#include "homogeneous_places.hpp"
#include "pacing.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

double share_of(const Interval& domain, double at) { return (at - domain.start) / domain.length(); }

/// A curve of a family as the others meet it, and by what its weights are multiplied at both ends, in between linearly. One that is
/// run through at another pace has none of its own.
struct PacedCurve {
  const NurbsCurve* own;
  std::optional<Pacing> pacing;  ///< none where it keeps its own
  std::array<double, 2> factors{1.0, 1.0};

  PacedCurve(const PacedFamily& family, std::size_t i) : own(&family.own[i]) {
    if (!family.there[i]) pacing.emplace(family.wanted, family.given[i], family.is_closed);
  }
  std::vector<double> parameters(std::span<const double> at) const {
    std::vector<double> found(at.begin(), at.end());
    if (!pacing) return found;
    for (double& u : found) u = pacing->at(u);
    return found;
  }
  std::vector<double> weights(std::span<const double> at) const {
    std::vector<double> found;
    for (const double u : at) found.push_back(std::lerp(factors[0], factors[1], share_of(own->domain(), u)));
    if (pacing) return found;
    const std::vector<glm::dvec4> points = homogeneous_places(*own, at);
    for (std::size_t k = 0; k < at.size(); ++k) found[k] *= points[k].w;
    return found;
  }
  std::array<double, 2> end_weights() const {
    const Interval domain = own->domain();
    const double ends[] = {domain.start, domain.end};
    const std::vector<double> found = weights(ends);
    return {found[0], found[1]};
  }
  bool has_weights() const { return (own->rational() && !pacing) || factors != std::array{1.0, 1.0}; }
};

using PacedBorders = std::array<PacedCurve, 2>;

std::optional<PacedBorders> borders_of(const PacedFamily& family, const PacedFamily& others) {
  if (others.is_closed) return {};
  return PacedBorders{PacedCurve(family, 0), PacedCurve(family, family.curves.size() - 1)};
}

/// So that the four borders have the same weights in each corner: by constants where that can be, else all have 1 there.
void agree_in_corners(PacedBorders& along_u, PacedBorders& along_v) {
  constexpr double kSame = 0x1p-40;
  std::array<std::array<double, 2>, 2> ratios{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::array<double, 2> of_u = along_u[i].end_weights();
    for (std::size_t e = 0; e < 2; ++e) ratios[i][e] = of_u[e] / along_v[e].end_weights()[i];
  }
  const double one = ratios[0][0] * ratios[1][1];
  if (std::abs(one - ratios[0][1] * ratios[1][0]) <= kSame * one) {
    const double of_second = ratios[0][0] / ratios[1][0];
    along_u[1].factors = {of_second, of_second};
    for (std::size_t e = 0; e < 2; ++e) along_v[e].factors = {ratios[0][e], ratios[0][e]};
    return;
  }
  for (PacedBorders* const pair : {&along_u, &along_v}) {
    for (PacedCurve& border : *pair) {
      const std::array<double, 2> ends = border.end_weights();
      border.factors = {1.0 / ends[0], 1.0 / ends[1]};
    }
  }
}

/// With weights times a function that is linear over the domain: exact, on a degree more unless it is constant.
NurbsCurve with_factors(const PacedCurve& border) {
  const auto& [from, to] = border.factors;
  const NurbsCurve& own = *border.own;
  std::vector<glm::dvec4> points = homogeneous(own.points());
  if (from == to) {
    if (from == 1.0) return own;
    for (glm::dvec4& p : points) p = as_given(from * p);
    return own.with_points(std::move(points));
  }
  const NurbsCurve raised = elevated(own);
  const std::vector<double> places = greville_places(raised.knot_vector());
  points = homogeneous_places(own, places);
  for (std::size_t k = 0; k < places.size(); ++k) points[k] *= std::lerp(from, to, share_of(own.domain(), places[k]));
  solve_rows(raised.knot_vector(), places, std::span(&points.front().x, 4 * points.size()));
  for (glm::dvec4& p : points) p = as_given(p);
  return raised.with_points(std::move(points));
}

/// Positive weights between those of the borders.
class WeightsBetween {
 public:
  WeightsBetween(const std::optional<PacedBorders>& along_u, const std::optional<PacedBorders>& along_v)
      : along_u_(along_u), along_v_(along_v) {}

  /// Along a curve of one family.
  /// @param is_u  whether of the first
  /// @param at    of the other family, where it meets these
  std::vector<double> along(bool is_u, double at, std::span<const double> places, const Interval& domain,
                            const Interval& others) const {
    const std::optional<PacedBorders>& beside = is_u ? along_u_ : along_v_;
    const std::optional<PacedBorders>& across = is_u ? along_v_ : along_u_;
    const double b = share_of(others, at);
    std::vector<double> logarithms(places.size(), 0.0);
    const auto add = [&](std::size_t k, double share, double weight) { logarithms[k] += share * std::log(weight); };
    if (beside) {
      const std::array both{(*beside)[0].weights(places), (*beside)[1].weights(places)};
      for (std::size_t k = 0; k < places.size(); ++k) {
        add(k, 1.0 - b, both[0][k]);
        add(k, b, both[1][k]);
      }
    }
    if (across) {
      const std::array ends{(*across)[0].weights({&at, 1})[0], (*across)[1].weights({&at, 1})[0]};
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double a = share_of(domain, places[k]);
        add(k, 1.0 - a, ends[0]);
        add(k, a, ends[1]);
      }
    }
    if (beside && across) take_corners(places, domain, b, *beside, logarithms);
    for (double& w : logarithms) w = std::exp(w);
    return logarithms;
  }

  /// Parameters of one family at which weights may have a kink.
  std::vector<double> kinks(bool is_u) const {
    std::vector<double> found;
    const std::optional<PacedBorders>& beside = is_u ? along_u_ : along_v_;
    if (!beside) return found;
    for (const PacedCurve& border : *beside) {
      const KnotVector& knots = border.own->knot_vector();
      for (const double knot : knots.knots()) {
        const bool is_start = knots.periodic() && knot == knots.domain().start;
        const bool is_inside = knot > knots.domain().start && knot < knots.domain().end;
        if (!border.pacing && (is_inside || is_start) && multiplicity(knots, knot) >= knots.degree()) found.push_back(knot);
      }
    }
    return found;
  }

 private:
  static void take_corners(std::span<const double> places, const Interval& domain, double b, const PacedBorders& beside,
                           std::vector<double>& logarithms) {
    const std::array corners{beside[0].end_weights(), beside[1].end_weights()};
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double a = share_of(domain, places[k]);
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t e = 0; e < 2; ++e) {
          logarithms[k] -= (i == 0 ? 1.0 - b : b) * (e == 0 ? 1.0 - a : a) * std::log(corners[i][e]);
        }
      }
    }
  }

  const std::optional<PacedBorders>& along_u_;
  const std::optional<PacedBorders>& along_v_;
};

/// The curve on these knots whose points are those of a curve and whose weights are these.
Approximation<NurbsCurve> projected(const PacedCurve& curve, const KnotVector& knots,
                                    const std::function<std::vector<double>(std::span<const double>)>& weights) {
  const auto numerators = [&](std::span<const double> at, std::span<glm::dvec3> points) {
    evaluate(*curve.own, curve.parameters(at), {&points.front().x, 3 * points.size()});
    const std::vector<double> by = weights(at);
    for (std::size_t k = 0; k < at.size(); ++k) points[k] *= by[k];
  };
  const auto denominators = [&](std::span<const double> at, std::span<glm::dvec3> points) {
    const std::vector<double> by = weights(at);
    for (std::size_t k = 0; k < at.size(); ++k) points[k] = glm::dvec3(by[k], 0.0, 0.0);
  };
  const auto above = project_smooth(numerators, knots, true);
  const auto below = project_smooth(denominators, knots, true);
  std::vector<glm::dvec4> points;
  double least = below.value.points()[0].x;
  double largest = 0.0;
  for (std::size_t i = 0; i < above.value.points().size(); ++i) {
    const double w = below.value.points()[i].x;
    least = std::min(least, w);
    points.push_back(as_given(glm::dvec4(glm::dvec3(above.value.points()[i]), w)));
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(above.value.points()[i][c] / w));
  }
  if (!(least > 0.0)) return {above.value, std::numeric_limits<double>::infinity()};
  return {NurbsCurve::make(knots, std::move(points)), (above.error + largest * below.error) / least};
}

/// Gives the curves of a family these weights: exactly where borders keep their pace.
void give_weights(PacedFamily& family, const PacedFamily& others, const std::optional<PacedBorders>& borders,
                  const WeightsBetween& between, bool is_u, double tolerance) {
  std::vector<std::size_t> which;
  std::vector<PacedCurve> curves;
  std::vector<double> corners = between.kinks(is_u);
  std::vector<Crease> creases;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    std::ranges::copy(paced_creases(family, i), std::back_inserter(creases));
    const bool is_border = borders && (i == 0 || i + 1 == family.curves.size());
    if (is_border && family.there[i]) {
      family.curves[i] = with_factors((*borders)[i == 0 ? 0 : 1]);
      continue;
    }
    which.push_back(i);
    curves.emplace_back(family, i);
    std::ranges::copy(paced_corners(family, i), std::back_inserter(corners));
  }
  if (which.empty()) return;
  std::ranges::sort(corners);
  const auto repeated = std::ranges::unique(corners);
  corners.erase(repeated.begin(), repeated.end());
  const Interval domain = family.curves[0].domain();
  const Interval across = others.curves[0].domain();
  const FitTogether what{which.size(), 3, domain, family.is_closed, corners, tolerance, creases};
  const auto fitted = fitted_together(what, [&](std::size_t k, const KnotVector& knots) {
    return projected(curves[k], knots, [&](std::span<const double> at) {
      return between.along(is_u, others.wanted[which[k]], at, domain, across);
    });
  }).value;
  for (std::size_t k = 0; k < which.size(); ++k) family.curves[which[k]] = fitted[k];
}

bool have_positive_weights_all(const PacedFamily& family) {
  return std::ranges::all_of(family.own, [](const NurbsCurve& curve) { return have_positive_weights(curve.points()); });
}

}  // namespace

bool let_meet_with_weights(PacedFamily& u, PacedFamily& v, double tolerance) {
  if (!have_positive_weights_all(u) || !have_positive_weights_all(v)) return false;
  std::optional<PacedBorders> along_u = borders_of(u, v);
  std::optional<PacedBorders> along_v = borders_of(v, u);
  if (!along_u && !along_v) return false;
  if (along_u && along_v) agree_in_corners(*along_u, *along_v);
  const auto have_weights = [](const std::optional<PacedBorders>& pair) {
    return pair && std::ranges::any_of(*pair, &PacedCurve::has_weights);
  };
  if (!have_weights(along_u) && !have_weights(along_v)) return false;
  const WeightsBetween between(along_u, along_v);
  give_weights(u, v, along_u, between, true, tolerance);
  give_weights(v, u, along_v, between, false, tolerance);
  return true;
}

}  // namespace splinecore
