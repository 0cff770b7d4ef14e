#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "along.hpp"
#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "control_counts.hpp"
#include "least_squares_options.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/approximate_patch.hpp"
#include "splinecore/meet/nearest.hpp"
#include "swing.hpp"
#include "thin_plate_fit.hpp"
#include "unit_points.hpp"

namespace splinecore {

namespace {

/// A patch near points, and where they are nearest to it.
struct ScatteredFit {
  NurbsPatch patch;
  std::vector<glm::dvec2> parameters;
  double error;    ///< the largest distance
  double squares;  ///< the weighted sum of the squared distances
};

void require_scattered(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters, const KnotVector& u,
                       const KnotVector& v) {
  if (u.periodic() || v.periodic()) throw InvalidShape("a patch near scattered points is open in both directions");
  if (points.size() != parameters.size()) {
    throw InvalidShape("parameters has " + std::to_string(parameters.size()) + " rows, " +
                       std::to_string(points.size()) + " are needed");
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (const auto& [knots, axis] : {std::pair{&u, 0}, std::pair{&v, 1}}) {
      const double at = parameters[i][axis];
      if (at >= knots->domain().start && at <= knots->domain().end) continue;
      throw InvalidShape("parameters" + index_text(i) + "[" + std::to_string(axis) + "] = " + text_of(at) +
                         " is outside the domain from " + text_of(knots->domain().start) + " to " +
                         text_of(knots->domain().end));
    }
  }
}

void require_options(std::span<const glm::dvec3> points, const ScatteredOptions& options) {
  constexpr std::size_t kFewest = 3;
  if (points.size() < kFewest) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " rows, at least 3 are needed");
  }
  require_finite(points, "points");
  require_weights(options.weights, points.size());
  require_smoothing(options.smoothing);
  require_corrections(options.corrections);
}

/// Where the points are nearest to the patch, and how far.
/// @throws InvalidShape where too many places may be the nearest
void project(std::span<const glm::dvec3> points, std::span<const double> weights, ScatteredFit& fit) {
  std::vector<NearestOnPatch> nearest(points.size());
  try {
    splinecore::nearest(fit.patch, points, nearest);
  } catch (const InvalidShape&) {
    throw InvalidShape("the points hardly determine the patch, which swings too widely to tell where they are nearest to it: "
                       "fewer control points or more smoothing are needed");
  }
  fit.error = 0.0;
  fit.squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    fit.parameters[i] = {nearest[i].u, nearest[i].v};
    fit.error = std::max(fit.error, nearest[i].distance);
    fit.squares += (weights.empty() ? 1.0 : weights[i]) * nearest[i].distance * nearest[i].distance;
  }
}

/// The system is solved with the shorter side of the net as v.
NurbsPatch least_squares(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                         const KnotVector& u, const KnotVector& v, std::span<const double> weights, double energy,
                         bool is_turned = false) {
  if (v.count() > u.count()) {
    std::vector<glm::dvec2> turned;
    for (const glm::dvec2& place : parameters) turned.emplace_back(place.y, place.x);
    return swapped(least_squares(points, turned, v, u, weights, energy, true));
  }
  const ThinPlateFit fit(u, v, parameters, weights, energy, is_turned);
  std::vector<glm::dvec4> net;
  for (const glm::dvec3& point : fit.net(points)) net.emplace_back(point, 1.0);
  return NurbsPatch::make(u, v, std::move(net));
}

/// Of points near 1.
/// @throws InvalidShape where the patch leaves the points by more than their size `most_swing` times
ScatteredFit fitted_once(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                         const KnotVector& u, const KnotVector& v, std::span<const double> weights, double energy,
                         double most_swing) {
  ScatteredFit made{least_squares(points, parameters, u, v, weights, energy),
                    {parameters.begin(), parameters.end()}, 0.0, 0.0};
  if (!stays_near(made.patch, points, most_swing)) {
    throw InvalidShape("the points hardly determine the patch, which swings too widely between them or beside them: fewer "
                       "control points or more smoothing are needed");
  }
  project(points, weights, made);
  return made;
}

ScatteredFit fitted(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters, const KnotVector& u,
                    const KnotVector& v, const ScatteredOptions& options, double most_swing) {
  constexpr double kBetter = 0.999;
  const double mass = options.weights.empty() ? static_cast<double>(points.size())
                                              : std::accumulate(options.weights.begin(), options.weights.end(), 0.0);
  const double energy = options.smoothing * mass;
  ScatteredFit best = fitted_once(points, parameters, u, v, options.weights, energy, most_swing);
  for (int i = 0; i < options.corrections; ++i) {
    try {
      ScatteredFit next = fitted_once(points, best.parameters, u, v, options.weights, energy, most_swing);
      const bool is_better = next.squares < kBetter * best.squares;
      if (next.squares < best.squares) best = std::move(next);
      if (!is_better) break;
    } catch (const InvalidShape&) {
      break;  // the nearest points may leave a control point without any
    }
  }
  return best;
}

Approximation<NurbsPatch> in_place(const ScatteredFit& fit, const UnitPoints& unit) {
  std::vector<glm::dvec4> net;
  for (const glm::dvec4& point : fit.patch.points()) net.emplace_back(unit.back(glm::dvec3(point)), 1.0);
  return {fit.patch.with_points(std::move(net)), std::ldexp(fit.error, unit.exponent)};
}

/// Weights whose largest is near 1.
ScatteredOptions scaled(ScatteredOptions options) {
  if (options.weights.empty()) return options;
  const int exponent = std::ilogb(*std::ranges::max_element(options.weights));
  for (double& weight : options.weights) weight = std::ldexp(weight, -exponent);
  return options;
}

struct Domain {
  Interval u;
  Interval v;
};

Domain around(std::span<const glm::dvec2> parameters) {
  const auto [low_u, high_u] = std::ranges::minmax(parameters, {}, &glm::dvec2::x);
  const auto [low_v, high_v] = std::ranges::minmax(parameters, {}, &glm::dvec2::y);
  if (low_u.x < high_u.x && low_v.y < high_v.y) return {{low_u.x, high_u.x}, {low_v.y, high_v.y}};
  throw InvalidShape("parameters are the same along " + std::string(low_u.x < high_u.x ? "v" : "u"));
}

std::pair<KnotVector, KnotVector> even_knots_of(const NetSize& size, const Domain& domain) {
  return {along("u", [&] { return even_knots(size.degree_u, size.count_u, domain.u, false); }),
          along("v", [&] { return even_knots(size.degree_v, size.count_v, domain.v, false); })};
}

std::vector<glm::dvec2> parameters_of(std::span<const glm::dvec3> points, std::span<const glm::dvec2> given) {
  if (given.empty()) return plane_parameters(points);
  if (given.size() != points.size()) {
    throw InvalidShape("parameters has " + std::to_string(given.size()) + " rows, " + std::to_string(points.size()) +
                       " are needed");
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (std::isfinite(given[i].x) && std::isfinite(given[i].y)) continue;
    throw InvalidShape("parameters" + index_text(i) + " is not finite");
  }
  return {given.begin(), given.end()};
}

std::size_t larger(std::size_t count, std::size_t most) { return std::min(most, count + count / 3 + 1); }

/// Points near 1 and what is asked of a patch, on ever larger nets.
struct ScatteredTask {
  std::span<const glm::dvec3> points;
  std::vector<glm::dvec2> parameters;  ///< corrected as nets grow
  Domain domain;
  ScatteredOptions options;
  double tolerance;
};

ScatteredFit fit_of(const ScatteredTask& task, const NetSize& size, double smoothing, double most_swing) {
  const auto [u, v] = even_knots_of(size, task.domain);
  ScatteredOptions options = task.options;
  options.smoothing = smoothing;
  return fitted(task.points, task.parameters, u, v, options, most_swing);
}

/// Where the points do not decide alone: with as much energy of a thin plate as the tolerance leaves room for.
/// @returns the nearest patch, if there is one; none for nets with more control points than points
std::optional<ScatteredFit> stiffened(const ScatteredTask& task, const NetSize& size) {
  constexpr std::array kSmoothings{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
  std::optional<ScatteredFit> best;
  if (size.count_u * size.count_v > task.points.size()) return best;
  for (const double smoothing : kSmoothings) {
    if (smoothing <= task.options.smoothing) break;
    try {
      ScatteredFit made = fit_of(task, size, smoothing, kCalmAround);
      const bool is_within = made.error <= task.tolerance;
      if (!best || made.error < best->error) best = std::move(made);
      if (is_within) break;
    } catch (const InvalidShape&) {
      continue;  // the energy hides the points, or is too little for them; the caller has the reason of the plain patch
    }
  }
  return best;
}

/// @param reason  takes why the points do not decide alone
std::optional<ScatteredFit> plain(const ScatteredTask& task, const NetSize& size, double most_swing, std::string& reason) {
  try {
    reason.clear();
    return fit_of(task, size, task.options.smoothing, most_swing);
  } catch (const InvalidShape& refused) {
    reason = refused.what();
    return {};
  }
}

/// By the points alone, or with energy; where both swing by the points alone as far as is still taken.
std::optional<ScatteredFit> nearest_of(const ScatteredTask& task, const NetSize& size, std::string& reason) {
  auto made = plain(task, size, kCalmAround, reason);
  if (!made) made = stiffened(task, size);
  if (!made) made = plain(task, size, kWideAround, reason);
  return made;
}

}  // namespace

Approximation<NurbsPatch> approximate(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                                      const KnotVector& u, const KnotVector& v, const ScatteredOptions& options) {
  require_options(points, options);
  require_scattered(points, parameters, u, v);
  const UnitPoints unit = unit_points(points);
  return in_place(fitted(unit.points, parameters, u, v, scaled(options), kMostAround), unit);
}

Approximation<NurbsPatch> approximate(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                                      const NetSize& size, const ScatteredOptions& options) {
  require_options(points, options);
  const auto at = parameters_of(points, parameters);
  const Domain domain = around(at);
  const auto [u, v] = even_knots_of(size, domain);
  return approximate(points, at, u, v, options);
}

Approximation<NurbsPatch> approximate_within(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                                             const NetSize& size, double tolerance, const ScatteredOptions& options) {
  require_positive(tolerance);
  require_options(points, options);
  auto at = parameters_of(points, parameters);
  along("u", [&] { require_count(size.count_u, size.degree_u, false); });
  along("v", [&] { require_count(size.count_v, size.degree_v, false); });
  const Domain domain = around(at);
  const UnitPoints unit = unit_points(points);
  ScatteredTask task{unit.points, std::move(at), domain, scaled(options), std::ldexp(tolerance, -unit.exponent)};
  NetSize now = size;
  now.count_u = static_cast<std::size_t>(size.degree_u) + 1;
  now.count_v = static_cast<std::size_t>(size.degree_v) + 1;
  std::string reason;
  auto found = nearest_of(task, now, reason);
  if (!found) throw InvalidShape(reason);
  ScatteredFit fit = *std::move(found);
  double least = fit.error;
  while (fit.error > task.tolerance && (now.count_u < size.count_u || now.count_v < size.count_v)) {
    task.parameters = fit.parameters;
    NetSize next = now;
    next.count_u = larger(now.count_u, size.count_u);
    next.count_v = larger(now.count_v, size.count_v);
    found = nearest_of(task, next, reason);
    if (!reason.empty()) {
      reason = ", and of " + std::to_string(next.count_u) + " x " + std::to_string(next.count_v) + " " + reason;
    }
    if (!found) break;
    fit = *std::move(found);
    now = next;
    least = std::min(least, fit.error);
  }
  if (fit.error <= task.tolerance) return in_place(fit, unit);
  throw ToleranceNotReached("the points cannot be approximated by " + std::to_string(now.count_u) + " x " +
                                std::to_string(now.count_v) + " control points" + and_smoothing(options.smoothing > 0.0) + reason,
                            tolerance, std::ldexp(least, unit.exponent));
}

}  // namespace splinecore
