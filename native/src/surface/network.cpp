#include "splinecore/surface/network.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "boolean_sum.hpp"
#include "build/fit_options.hpp"
#include "fit/row_spline.hpp"
#include "fitted_together.hpp"
#include "meet/near_space.hpp"
#include "network_curves.hpp"
#include "pacing.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/project.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// A parameter so near, as a part of the domain, to another one is the same.
constexpr double kSame = 0x1p-36;
constexpr double kSameWeight = 0x1p-32;

/// Where the curves of a family are to meet the others: means of where they do, over the domain of the first.
std::vector<double> wanted_crossings(const NetworkFamily& family) {
  const Interval domain = family.curves[0].domain();
  std::vector<double> wanted(family.crossings[0].size(), 0.0);
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    const Interval own = family.curves[i].domain();
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      wanted[j] += (family.crossings[i][j] - own.start) / own.length() / static_cast<double>(family.curves.size());
    }
  }
  for (double& u : wanted) u = domain.start + u * domain.length();
  wanted.front() = domain.start;
  wanted.back() = domain.end;
  return wanted;
}

/// A family over one domain, where it is to meet the others, and whether it does.
struct Paced {
  std::vector<NurbsCurve> curves;
  std::vector<std::vector<double>> given;  ///< crossings, in that domain
  std::vector<double> wanted;
  bool is_closed;
  bool is_there;  ///< all given are as wanted
};

Paced paced(const NetworkFamily& family) {
  Paced made{{}, {}, wanted_crossings(family), family.is_closed, true};
  const Interval domain = family.curves[0].domain();
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    const NurbsCurve& curve = family.curves[i];
    const Interval own = curve.domain();
    made.curves.push_back(own == domain ? curve : with_domain(curve, domain));
    std::vector<double> at;
    for (std::size_t j = 0; j < made.wanted.size(); ++j) {
      at.push_back(domain.start + (family.crossings[i][j] - own.start) / own.length() * domain.length());
      made.is_there = made.is_there && std::abs(at[j] - made.wanted[j]) <= kSame * domain.length();
    }
    at.front() = domain.start;
    at.back() = domain.end;
    made.given.push_back(std::move(at));
  }
  return made;
}

/// How many of the others a family meets.
std::size_t count_of_others(const Paced& family) { return family.wanted.size() - (family.is_closed ? 1 : 0); }

/// Homogeneous points of a curve.
std::vector<glm::dvec4> places_on(const NurbsCurve& curve, std::span<const double> at) {
  std::vector<glm::dvec4> found(at.size());
  evaluate_homogeneous(curve, at, found);
  for (glm::dvec4& p : found) p *= std::ldexp(1.0, curve.weight_exponent());
  return found;
}

NurbsCurve with_weights_times(const NurbsCurve& curve, double factor) {
  if (factor == 1.0) return curve;
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& p : points) p = p.w == 0.0 ? factor * p : glm::dvec4(glm::dvec3(p), factor * p.w);
  return curve.with_points(std::move(points));
}

/// Multiplies the weights of curves so that they are one where curves meet. @returns whether that can be done
bool reconcile_weights(Paced& u, Paced& v) {
  const auto at_u = std::span(u.wanted).first(v.curves.size());
  const auto at_v = std::span(v.wanted).first(u.curves.size());
  std::vector<std::vector<glm::dvec4>> on_u;
  std::vector<std::vector<glm::dvec4>> on_v;
  for (const NurbsCurve& curve : u.curves) on_u.push_back(places_on(curve, at_u));
  for (const NurbsCurve& curve : v.curves) on_v.push_back(places_on(curve, at_v));
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

/// The curves of a family as polynomials that meet the others where they are to.
void repace(Paced& family, double tolerance) {
  std::vector<Pacing> pacings;
  for (const auto& given : family.given) pacings.emplace_back(family.wanted, given, family.is_closed);
  std::vector<double> corners;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    const Pacing back(family.given[i], family.wanted, family.is_closed);
    for (const double corner : corners_of({&family.curves[i], 1})) {
      // Newton's method would need the derivative: the inverse pace is near, and halving finds the rest.
      double low = family.wanted.front();
      double high = family.wanted.back();
      for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        (pacings[i].at(middle) < corner ? low : high) = middle;
      }
      corners.push_back(0.5 * (low + high));
    }
  }
  std::ranges::sort(corners);
  const FitTogether what{family.curves.size(), 3, family.curves[0].domain(), family.is_closed, corners, tolerance};
  family.curves = fitted_together(what, [&](std::size_t i, const KnotVector& knots) {
    const auto function = [&](std::span<const double> at, std::span<glm::dvec3> points) {
      std::vector<double> paces;
      for (const double u : at) paces.push_back(pacings[i].at(u));
      evaluate(family.curves[i], paces, {&points.front().x, 3 * points.size()});
    };
    return project(function, knots, true);
  }).value;
}

std::vector<double> numbers_of(std::span<const glm::dvec4> row) {
  std::vector<double> numbers;
  for (const glm::dvec4& p : row) numbers.insert(numbers.end(), {p.x, p.y, p.z, p.w});
  return numbers;
}

/// How control points of one direction follow from places along it.
struct Across {
  std::vector<double> parameters;
  int degree;
  Closing closing;
  std::vector<double> knots;  ///< or none, for averages

  std::vector<glm::dvec4> rows(const std::vector<std::vector<double>>& places, KnotVector& found) const {
    RowConditions given{parameters, places, {}, {}};
    const RowSpline spline = spline_through(given, degree, closing, knots);
    found = spline.knots;
    std::vector<glm::dvec4> points(spline.controls.size() / 4);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* const p = &spline.controls[4 * i];
      points[i] = {p[0], p[1], p[2], p[3]};
    }
    return points;
  }
};

/// With the knots of the curves along it, if as many curves cross as these have control points.
Across across_by(const Paced& along, const KnotVector& knots) {
  const std::size_t count = count_of_others(along);
  Across across{along.wanted, 0, along.is_closed ? Closing::closed : Closing::open, {}};
  const int most = static_cast<int>(count) - 1;
  across.degree = std::min(std::max(3, knots.degree()), most);
  if (static_cast<std::size_t>(knots.count()) != count) return across;
  across.degree = knots.degree();
  across.knots.assign(knots.knots().begin(), knots.knots().end());
  return across;
}

/// Rows of control points along u, one behind the other along v.
NurbsPatch from_rows(const KnotVector& knots_u, const KnotVector& knots_v, const std::vector<glm::dvec4>& rows) {
  const auto count_u = static_cast<std::size_t>(knots_u.count());
  const auto count_v = static_cast<std::size_t>(knots_v.count());
  std::vector<glm::dvec4> net(rows.size());
  for (std::size_t j = 0; j < count_v; ++j) {
    for (std::size_t i = 0; i < count_u; ++i) net[i * count_v + j] = rows[j * count_u + i];
  }
  return NurbsPatch::from_homogeneous(knots_u, knots_v, net);
}

/// The patch through curves along u.
NurbsPatch through(std::span<const NurbsCurve> curves, const Across& across) {
  std::vector<std::vector<double>> rows;
  for (const NurbsCurve& curve : curves) rows.push_back(numbers_of(homogeneous(curve.points())));
  KnotVector knots = curves[0].knot_vector();
  const std::vector<glm::dvec4> points = across.rows(rows, knots);
  return from_rows(curves[0].knot_vector(), knots, points);
}

/// The patch through the crossings alone.
NurbsPatch through_crossings(const Paced& u, const Paced& v, const Across& along_u, const Across& along_v) {
  std::vector<std::vector<double>> rows;
  KnotVector knots_u = u.curves[0].knot_vector();
  for (std::size_t i = 0; i < u.curves.size(); ++i) {
    const auto on_u = places_on(u.curves[i], std::span(u.wanted).first(v.curves.size()));
    std::vector<std::vector<double>> places;
    for (std::size_t j = 0; j < v.curves.size(); ++j) {
      const glm::dvec4 on_v = places_on(v.curves[j], std::span(v.wanted).subspan(i, 1))[0];
      const glm::dvec4 middle = 0.5 * (on_u[j] + on_v);
      places.push_back({middle.x, middle.y, middle.z, middle.w});
    }
    rows.push_back(numbers_of(along_u.rows(places, knots_u)));
  }
  KnotVector knots_v = v.curves[0].knot_vector();
  const std::vector<glm::dvec4> points = along_v.rows(rows, knots_v);
  return from_rows(knots_u, knots_v, points);
}

NurbsPatch summed(const Paced& u, const Paced& v) {
  const Across along_u = across_by(u, u.curves[0].knot_vector());
  const Across along_v = across_by(v, v.curves[0].knot_vector());
  return boolean_sum(through(u.curves, along_v), swapped(through(v.curves, along_u)),
                     through_crossings(u, v, along_u, along_v));
}

/// Of a patch of polynomials, whose weights are 1 but for rounding.
NurbsPatch with_weights_one(const NurbsPatch& patch) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (glm::dvec4& p : points) p.w = 1.0;
  return patch.with_points(std::move(points));
}

/// The largest distance of curves from the lines of the patch on which they are to lie.
double distance_from(const NurbsPatch& patch, const Paced& family, std::span<const double> others, Axis axis) {
  constexpr int kPlaces = 129;
  const Interval domain = family.curves[0].domain();
  std::vector<double> at;
  for (int k = 0; k < kPlaces; ++k) at.push_back(k + 1 < kPlaces ? domain.start + domain.length() * k / (kPlaces - 1) : domain.end);
  double largest = 0.0;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    std::vector<glm::dvec3> wanted(kPlaces);
    std::vector<glm::dvec3> found(kPlaces);
    const EvaluateOptions options{.side = Side::left, .at_infinity = AtInfinity::nan};
    evaluate(family.curves[i], at, {&wanted.front().x, 3 * wanted.size()}, options);
    const NurbsCurve line = isocurve(patch, axis, others[i]);
    evaluate(line, at, {&found.front().x, 3 * found.size()}, options);
    for (int k = 0; k < kPlaces; ++k) {
      if (is_finite(wanted[k]) && is_finite(found[k])) largest = std::max(largest, distance_of(wanted[k], found[k]));
    }
  }
  return largest;
}

std::vector<glm::dvec4> points_of(std::span<const NurbsCurve> a, std::span<const NurbsCurve> b) {
  std::vector<glm::dvec4> all;
  for (const auto& curves : {a, b}) {
    for (const NurbsCurve& curve : curves) all.insert(all.end(), curve.points().begin(), curve.points().end());
  }
  return all;
}

}  // namespace

Approximation<NurbsPatch> network(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v,
                                  std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  const std::vector<glm::dvec4> all = points_of(along_u, along_v);
  const NearSpace space(all);
  const auto entered = [&](std::span<const NurbsCurve> curves) {
    std::vector<NurbsCurve> near;
    for (const NurbsCurve& curve : curves) near.push_back(curve.with_points(space.enter(curve.points())));
    return near;
  };
  const double within = tolerance ? *tolerance / space.length(1.0) : 0x1p-20;
  const NetworkCurves curves = network_curves(entered(along_u), entered(along_v), within);
  Paced u = paced(curves.u);
  Paced v = paced(curves.v);
  if (!(u.is_there && v.is_there && reconcile_weights(u, v))) {
    for (Paced* family : {&u, &v}) {
      const bool is_rational = std::ranges::any_of(family->curves, &NurbsCurve::rational);
      if (is_rational || !family->is_there) repace(*family, 0.5 * within);
    }
  }
  u.curves = compatible(u.curves);
  v.curves = compatible(v.curves);
  NurbsPatch patch = summed(u, v);
  if (!std::ranges::any_of(u.curves, &NurbsCurve::rational) && !std::ranges::any_of(v.curves, &NurbsCurve::rational)) {
    patch = with_weights_one(patch);
  }
  const double error = std::max(distance_from(patch, u, v.wanted, Axis::v), distance_from(patch, v, u.wanted, Axis::u));
  return {patch.with_points(space.leave(patch.points())), space.length(error)};
}

}  // namespace splinecore
