#include "paced_family.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "fit/project_smooth.hpp"
#include "fitted_together.hpp"
#include "homogeneous_places.hpp"
#include "pacing.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// A parameter so near, as a part of the domain, to another one is the same.
constexpr double kSame = 0x1p-36;
constexpr double kSameWeight = 0x1p-32;

/// Means of where the curves of a family meet the others, over the domain of the first.
std::vector<double> mean_crossings(const NetworkFamily& family) {
  const Interval domain = family.curves[0].domain();
  std::vector<double> wanted(family.crossings[0].size(), 0.0);
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    const Interval own = family.curves[i].domain();
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      wanted[j] += (family.crossings[i][j] - own.start) / own.length() / static_cast<double>(family.curves.size());
    }
  }
  for (double& u : wanted) u = domain.start + u * domain.length();
  return wanted;
}

NurbsCurve with_weights_times(const NurbsCurve& curve, double factor) {
  if (factor == 1.0) return curve;
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& p : points) p = p.w == 0.0 ? factor * p : glm::dvec4(glm::dvec3(p), factor * p.w);
  return curve.with_points(std::move(points));
}

}  // namespace

PacedFamily paced(const NetworkFamily& family, bool has_outermost) {
  const std::size_t kept = family.order.front() < family.order.back() ? 0 : family.curves.size() - 1;
  const Interval domain = family.curves[has_outermost ? kept : 0].domain();
  PacedFamily made{{}, {}, {}, has_outermost ? family.crossings[kept] : mean_crossings(family), family.is_closed, {}};
  made.wanted.front() = domain.start;
  made.wanted.back() = domain.end;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    const NurbsCurve& curve = family.curves[i];
    const Interval own = curve.domain();
    made.curves.push_back(own == domain ? curve : with_domain(curve, domain));
    std::vector<double> at;
    bool is_there = true;
    for (std::size_t j = 0; j < made.wanted.size(); ++j) {
      at.push_back(domain.start + (family.crossings[i][j] - own.start) / own.length() * domain.length());
      is_there = is_there && std::abs(at[j] - made.wanted[j]) <= kSame * domain.length();
    }
    at.front() = domain.start;
    at.back() = domain.end;
    made.given.push_back(std::move(at));
    made.there.push_back(is_there);
  }
  made.own = made.curves;
  return made;
}

std::vector<glm::dvec3> given_points(const PacedFamily& family, std::size_t i, std::span<const double> at) {
  std::vector<double> paces(at.begin(), at.end());
  if (!family.there[i]) {
    const Pacing pacing(family.wanted, family.given[i], family.is_closed);
    for (double& u : paces) u = pacing.at(u);
  }
  std::vector<glm::dvec3> points(at.size());
  evaluate(family.own[i], paces, {&points.front().x, 3 * points.size()}, {.side = Side::left, .at_infinity = AtInfinity::nan});
  return points;
}

bool reconcile_weights(PacedFamily& u, PacedFamily& v) {
  const auto at_u = std::span(u.wanted).first(v.curves.size());
  const auto at_v = std::span(v.wanted).first(u.curves.size());
  std::vector<std::vector<glm::dvec4>> on_u;
  std::vector<std::vector<glm::dvec4>> on_v;
  for (const NurbsCurve& curve : u.curves) on_u.push_back(homogeneous_places(curve, at_u));
  for (const NurbsCurve& curve : v.curves) on_v.push_back(homogeneous_places(curve, at_v));
  std::vector<double> of_v;
  for (std::size_t j = 0; j < v.curves.size(); ++j) of_v.push_back(on_u[0][j].w / on_v[j][0].w);
  std::vector<double> of_u;
  for (std::size_t i = 0; i < u.curves.size(); ++i) of_u.push_back(of_v[0] * on_v[0][i].w / on_u[i][0].w);
  for (std::size_t i = 0; i < u.curves.size(); ++i) {
    for (std::size_t j = 0; j < v.curves.size(); ++j) {
      const double a = of_u[i] * on_u[i][j].w;
      const double b = of_v[j] * on_v[j][i].w;
      if (!(a != 0.0 && std::abs(a - b) <= kSameWeight * std::abs(a))) return false;
    }
  }
  for (std::size_t i = 0; i < u.curves.size(); ++i) u.curves[i] = with_weights_times(u.curves[i], of_u[i]);
  for (std::size_t j = 0; j < v.curves.size(); ++j) v.curves[j] = with_weights_times(v.curves[j], of_v[j]);
  return true;
}

namespace {

/// Among parameters at which the family meets the others those of places of a curve as it is given.
std::vector<double> where_paced(const PacedFamily& family, std::size_t i, std::vector<double> found) {
  if (family.there[i]) return found;
  const Pacing pacing(family.wanted, family.given[i], family.is_closed);
  for (double& corner : found) {
    const auto crossing = std::ranges::find(family.given[i], corner);
    if (crossing != family.given[i].end()) {
      corner = family.wanted[static_cast<std::size_t>(crossing - family.given[i].begin())];
      continue;
    }
    // Newton's method would need the derivative: halving finds the inverse.
    double low = family.wanted.front();
    double high = family.wanted.back();
    for (int round = 0; round < 60; ++round) {
      const double middle = 0.5 * (low + high);
      (pacing.at(middle) < corner ? low : high) = middle;
    }
    corner = 0.5 * (low + high);
  }
  return found;
}

}  // namespace

std::vector<double> paced_corners(const PacedFamily& family, std::size_t i) {
  return where_paced(family, i, corners_of({&family.own[i], 1}));
}

std::vector<Crease> paced_creases(const PacedFamily& family, std::size_t i) {
  std::vector<Crease> found = creases_of(family.own[i], 3);
  std::vector<double> places;
  for (const Crease& one : found) places.push_back(one.at);
  places = where_paced(family, i, places);
  for (std::size_t k = 0; k < found.size(); ++k) found[k].at = places[k];
  if (family.there[i]) return found;
  const int times = Pacing(family.wanted, family.given[i], family.is_closed).is_smooth() ? 1 : 2;
  for (const double u : family.wanted) found.push_back({u, times});
  return found;
}

void repace(PacedFamily& family, double tolerance) {
  std::vector<std::size_t> which;
  std::vector<Pacing> pacings;
  std::vector<double> corners;
  std::vector<Crease> creases;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    family.curves[i] = family.own[i];
    if (family.there[i] && !family.own[i].rational()) continue;
    which.push_back(i);
    pacings.emplace_back(family.wanted, family.given[i], family.is_closed);
    std::ranges::copy(paced_corners(family, i), std::back_inserter(corners));
    std::ranges::copy(paced_creases(family, i), std::back_inserter(creases));
  }
  if (which.empty()) return;
  std::ranges::sort(corners);
  const FitTogether what{which.size(), 3, family.curves[0].domain(), family.is_closed, corners, tolerance, creases};
  const auto fitted = fitted_together(what, [&](std::size_t k, const KnotVector& knots) {
    const auto function = [&](std::span<const double> at, std::span<glm::dvec3> points) {
      std::vector<double> paces;
      for (const double u : at) paces.push_back(pacings[k].at(u));
      evaluate(family.own[which[k]], paces, {&points.front().x, 3 * points.size()});
    };
    return project_smooth(function, knots, true);
  }).value;
  for (std::size_t k = 0; k < which.size(); ++k) family.curves[which[k]] = fitted[k];
}

}  // namespace splinecore
