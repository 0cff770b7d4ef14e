#include <algorithm>
#include <cmath>
#include <optional>

#include "chebyshev_sites.hpp"
#include "grid.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "splinecore/fit/interpolate_patch.hpp"
#include "swing.hpp"

namespace splinecore {

namespace {

/// Of patches: sums of two directions, and their product.
constexpr double kCalmGrid = 3.0;

/// Whether knots and parameters may be chosen together.
bool are_knots_free(const InterpolationOptions& options) {
  return options.degree > 1 && options.ends == FitEnds::averaged && options.start.empty() && options.end.empty() &&
         options.tangents.empty() && options.knots.empty();
}

std::vector<double> even_parameters(std::size_t count, double length) {
  std::vector<double> parameters(count + 1);
  for (std::size_t i = 0; i <= count; ++i) parameters[i] = length * (static_cast<double>(i) / static_cast<double>(count));
  return parameters;
}

/// By steps and knots that are even but for the ends: no points make such a curve swing.
Approximation<NurbsCurve> evenly(std::span<const glm::dvec3> points, InterpolationOptions options, double length) {
  if (options.closing == Closing::closed) {
    return interpolate(points, even_parameters(points.size(), length), options);
  }
  ChebyshevSites sites = chebyshev_sites(options.degree, points.size(), length);
  options.knots = std::move(sites.knots);
  return interpolate(points, sites.parameters, options);
}

/// The same of a direction of a grid, where its parameters, knots and ends were left to choose.
FitDirection evenly(FitDirection given, std::size_t count) {
  if (given.closing == Closing::closed) {
    given.parameters = even_parameters(count, given.parameters.back());
    return given;
  }
  ChebyshevSites sites = chebyshev_sites(given.degree, count, given.parameters.back());
  given.knots = std::move(sites.knots);
  given.parameters = std::move(sites.parameters);
  return given;
}

bool are_knots_free(const FitDirection& given) {
  return given.degree > 1 && given.ends == FitEnds::averaged && given.knots.empty() && given.parameters.empty();
}

}  // namespace

Approximation<NurbsPatch> interpolate_calmly(const PointGrid& grid, FitDirection u, FitDirection v) {
  require_grid(grid);
  const bool is_free_u = are_knots_free(u);
  const bool is_free_v = are_knots_free(v);
  if (u.parameters.empty()) u.parameters = calm_parameters(grid, Axis::u, u.degree, u.closing);
  if (v.parameters.empty()) v.parameters = calm_parameters(grid, Axis::v, v.degree, v.closing);
  if (!is_free_u && !is_free_v) return interpolate(grid, u, v);
  std::optional<Approximation<NurbsPatch>> made;
  try {
    made = interpolate(grid, u, v);
  } catch (const InvalidShape&) {
    // As of curves: what rounding hides is asked of other parameters.
    const auto needs = [](const FitDirection& given) { return static_cast<std::size_t>(given.degree); };
    if (grid.count_u <= needs(u) || grid.count_v <= needs(v)) throw;
  }
  if (made && swing_of(made->value, grid, u.parameters, v.parameters) <= kCalmGrid) return *std::move(made);
  return interpolate(grid, is_free_u ? evenly(u, grid.count_u) : u, is_free_v ? evenly(v, grid.count_v) : v);
}

Approximation<NurbsCurve> interpolate_calmly(std::span<const glm::dvec3> points, const InterpolationOptions& options) {
  const std::vector<double> parameters = calm_parameters(points, options.degree, options.closing);
  if (!are_knots_free(options)) return interpolate(points, parameters, options);
  // By their roots cubics came to 0.6 of a chord at most, of 3,000 wild sets; of those nothing is measured.
  constexpr int kCalmDegree = 3;
  std::optional<Approximation<NurbsCurve>> made;
  try {
    made = interpolate(points, parameters, options);
    if (options.degree <= kCalmDegree) return *std::move(made);
  } catch (const InvalidShape&) {
    // What rounding hides at these parameters is asked of others. Points that no curve can pass are refused there, too.
    if (points.size() <= static_cast<std::size_t>(options.degree)) throw;
  }
  if (made && swing_of(made->value, points, parameters) <= kCalm) return *std::move(made);
  return evenly(points, options, parameters.back());
}

}  // namespace splinecore
