#include <algorithm>
#include <cmath>
#include <optional>

#include "chebyshev_sites.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "swing.hpp"

namespace splinecore {

namespace {

/// Whether knots and parameters may be chosen together.
bool are_knots_free(const InterpolationOptions& options) {
  return options.degree > 1 && options.ends == FitEnds::averaged && options.start.empty() && options.end.empty() &&
         options.tangents.empty() && options.knots.empty();
}

/// By steps and knots that are even but for the ends: no points make such a curve swing.
Approximation<NurbsCurve> evenly(std::span<const glm::dvec3> points, InterpolationOptions options, double length) {
  if (options.closing == Closing::closed) {
    std::vector<double> parameters(points.size() + 1);
    const auto steps = static_cast<double>(points.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i] = length * (static_cast<double>(i) / steps);
    return interpolate(points, parameters, options);
  }
  ChebyshevSites sites = chebyshev_sites(options.degree, points.size(), length);
  options.knots = std::move(sites.knots);
  return interpolate(points, sites.parameters, options);
}

}  // namespace

Approximation<NurbsCurve> interpolate(std::span<const glm::dvec3> points, const InterpolationOptions& options) {
  const std::vector<double> parameters = calm_parameters(points, options.degree, options.closing);
  if (!are_knots_free(options)) return interpolate(points, parameters, options);
  std::optional<Approximation<NurbsCurve>> made;
  try {
    made = interpolate(points, parameters, options);
  } catch (const InvalidShape&) {
    // What rounding hides at these parameters is asked of others. Points that no curve can pass are refused there, too.
    if (points.size() <= static_cast<std::size_t>(options.degree)) throw;
  }
  if (made && swing_of(made->value, points, parameters) <= kCalm) return *std::move(made);
  return evenly(points, options, parameters.back());
}

}  // namespace splinecore
