#include "conditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "base/require.hpp"
#include "control_counts.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

bool is_closed(const InterpolationOptions& options) { return options.closing == Closing::closed; }

void require_degree(int degree) {
  if (degree >= 1 && degree <= kMaxDegree) return;
  throw InvalidShape("degree = " + std::to_string(degree) + " is outside [1, " + std::to_string(kMaxDegree) + "]");
}

/// A natural spline is the one that bends least among all curves of its smoothness: fewer points leave it open.
void require_points_for_natural_ends(const InterpolationOptions& options, std::size_t count) {
  const int least = (options.degree + 1) / 2;
  if (options.ends != FitEnds::natural || count >= static_cast<std::size_t>(least)) return;
  throw InvalidShape("natural ends of degree " + std::to_string(options.degree) + " need at least " +
                     std::to_string(least) + " points, not " + std::to_string(count));
}

/// Derivatives at the ends are for open curves, and for ends that are not asked for something else.
void require_ends(const InterpolationOptions& options) {
  const bool has_derivatives = !options.start.empty() || !options.end.empty();
  require_finite(options.start, "start");
  require_finite(options.end, "end");
  for (const auto* end : {&options.start, &options.end}) {
    if (end->empty()) continue;
    if (end->size() >= static_cast<std::size_t>(options.degree)) {
      throw InvalidShape(std::to_string(end->size()) + " derivatives at an end are too many for degree " +
                         std::to_string(options.degree) + ", which has room for " + std::to_string(options.degree - 1));
    }
  }
  if (is_closed(options)) {
    if (has_derivatives) throw InvalidShape("a closed curve has no ends: start and end are for open ones");
    if (options.ends != FitEnds::averaged) {
      throw InvalidShape("a closed curve has no ends that could be natural or not-a-knot");
    }
    return;
  }
  if (options.ends == FitEnds::averaged) return;
  const bool is_natural = options.ends == FitEnds::natural;
  const std::string name = is_natural ? "natural" : "not-a-knot";
  if (has_derivatives || !options.tangents.empty()) {
    throw InvalidShape("derivatives cannot be given with " + name + " ends");
  }
  if (is_natural && options.degree % 2 == 0) {
    throw InvalidShape("natural ends need an odd degree, not " + std::to_string(options.degree));
  }
  if (is_natural && !options.knots.empty()) {
    throw InvalidShape("natural ends have knots at the points: knots cannot be given");
  }
}

void require_tangents(const InterpolationOptions& options, std::size_t count) {
  std::vector<glm::dvec3> values;
  for (std::size_t i = 0; i < options.tangents.size(); ++i) {
    const PointTangent& tangent = options.tangents[i];
    const bool is_in_order = i == 0 || tangent.point > options.tangents[i - 1].point;
    if (tangent.point >= count || !is_in_order) {
      throw InvalidShape("tangents" + index_text(i) + " belongs to point " + std::to_string(tangent.point) +
                         ": each point has one at most, in their order, of " + std::to_string(count) + " points");
    }
    const bool is_twice = !is_closed(options) && ((tangent.point == 0 && !options.start.empty()) ||
                                                  (tangent.point + 1 == count && !options.end.empty()));
    if (is_twice) throw InvalidShape("the derivative at an end is given twice: in tangents, and by itself");
    values.push_back(tangent.tangent);
  }
  require_finite(values, "tangents");
  if (options.degree == 1 && !values.empty()) throw InvalidShape("a curve of degree 1 takes no tangents");
}

/// Derivatives that an end has beyond its point; natural ends have zeros from the middle order on.
void add_end(std::vector<Condition>& all, double parameter, std::size_t point, std::span<const glm::dvec3> derivatives,
             const InterpolationOptions& options, const glm::dvec3& place, bool is_start) {
  std::vector<Condition> found{{parameter, 0, place, point}};
  for (std::size_t k = 0; k < derivatives.size(); ++k) {
    found.push_back({parameter, static_cast<int>(k) + 1, derivatives[k], point});
  }
  for (int k = (options.degree + 1) / 2; options.ends == FitEnds::natural && k < options.degree; ++k) {
    found.push_back({parameter, k, glm::dvec3(0.0), point});
  }
  if (!is_start) std::ranges::reverse(found);
  all.insert(all.end(), found.begin(), found.end());
}

}  // namespace

void require_parameters(std::span<const double> parameters, std::size_t count) {
  if (parameters.size() != count) {
    throw InvalidShape("parameters has " + std::to_string(parameters.size()) + " values, " + std::to_string(count) +
                       " are needed");
  }
  require_increasing(parameters, "parameters");
}

void require_interpolation(std::size_t count, std::span<const double> parameters,
                           const InterpolationOptions& options) {
  require_degree(options.degree);
  const std::size_t least = is_closed(options) ? 3 : 2;
  if (count < least) {
    throw InvalidShape("points has " + std::to_string(count) + " rows, at least " + std::to_string(least) +
                       " are needed");
  }
  require_parameters(parameters, count + (is_closed(options) ? 1 : 0));
  require_ends(options);
  require_points_for_natural_ends(options, count);
  require_tangents(options, count);
}

std::vector<Condition> conditions_of(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                     const InterpolationOptions& options) {
  std::vector<Condition> all;
  all.reserve(points.size() + options.tangents.size() + 2 * static_cast<std::size_t>(options.degree));
  const std::size_t last = points.size() - 1;
  auto tangent = options.tangents.begin();
  for (std::size_t i = 0; i <= last; ++i) {
    std::span<const glm::dvec3> derivatives;
    if (!is_closed(options) && i == 0) derivatives = options.start;
    if (!is_closed(options) && i == last) derivatives = options.end;
    if (tangent != options.tangents.end() && tangent->point == i) derivatives = {&(tangent++)->tangent, 1};
    const bool is_end = !is_closed(options) && (i == 0 || i == last);
    if (is_end) {
      add_end(all, parameters[i], i, derivatives, options, points[i], i == 0);
      continue;
    }
    all.push_back({parameters[i], 0, points[i], i});
    if (!derivatives.empty()) all.push_back({parameters[i], 1, derivatives[0], i});
  }
  const std::size_t needed = least_count(options.degree, is_closed(options));
  if (all.size() < needed) {
    throw InvalidShape(std::to_string(all.size()) + " conditions are too few for degree " +
                       std::to_string(options.degree) + ", which needs at least " + std::to_string(needed));
  }
  return all;
}

namespace {

/// Of `width` neighbors each, by differences, so that equal ones give themselves.
std::vector<double> averages(std::span<const double> values, std::size_t width) {
  if (values.size() < width) return {};
  const std::size_t count = values.size() - width + 1;
  breathe(4 * width * count);
  const double share = 1.0 / static_cast<double>(width);
  std::vector<double> found(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t k = 1; k < width; ++k) {
    for (std::size_t i = 0; i < count; ++i) found[i] += (values[i + k] - values[i]) * share;
  }
  return found;
}

double between(double a, double b) { return a + 0.5 * (b - a); }

std::vector<double> open_knots(std::span<const double> sites, std::span<const double> parameters,
                               const InterpolationOptions& options) {
  const auto degree = static_cast<std::size_t>(options.degree);
  const std::size_t half = (degree - 1) / 2;
  std::vector<double> knots;
  knots.reserve(sites.size() + degree + 1);
  knots.assign(degree + 1, parameters.front());
  const bool is_clamped = degree % 2 == 1 && options.tangents.empty() && options.start.size() == half &&
                          options.end.size() == half && half > 0;
  if (options.ends == FitEnds::natural || is_clamped) {
    knots.insert(knots.end(), parameters.begin() + 1, parameters.end() - 1);
  } else if (options.ends == FitEnds::not_a_knot) {
    const auto inner = parameters.subspan(degree / 2, parameters.size() - degree);
    if (degree % 2 == 1) knots.insert(knots.end(), inner.begin() + 1, inner.end());
    for (std::size_t i = 1; i < inner.size() && degree % 2 == 0; ++i) knots.push_back(between(inner[i - 1], inner[i]));
  } else {
    const std::vector<double> inner = averages(sites.subspan(1, sites.size() - 2), degree);
    knots.insert(knots.end(), inner.begin(), inner.end());
  }
  knots.insert(knots.end(), degree + 1, parameters.back());
  return knots;
}

/// @throws InvalidShape if the parameters return after another period than that of the knots.
void require_period(const KnotVector& knots, std::span<const double> parameters) {
  if (!knots.periodic()) return;
  const double period = knots.domain().length();
  const double around = parameters.back() - parameters.front();
  const double size = std::max({std::abs(knots.domain().start), std::abs(knots.domain().end),
                                std::abs(parameters.front()), std::abs(parameters.back())});
  if (std::abs(around - period) <= 4.0 * std::numeric_limits<double>::epsilon() * size) return;
  throw InvalidShape("parameters return after " + text_of(around) + ", but one period of the knots is " +
                     text_of(period));
}

std::vector<double> closed_knots(std::span<const double> sites, std::span<const double> parameters,
                                 const InterpolationOptions& options) {
  if (options.tangents.empty() && options.degree % 2 == 1) return {parameters.begin(), parameters.end()};
  const auto count = static_cast<std::ptrdiff_t>(sites.size());
  const double period = parameters.back() - parameters.front();
  const std::ptrdiff_t width = options.tangents.empty() ? 2 : options.degree;
  std::vector<double> around;
  for (std::ptrdiff_t i = -(width / 2); i < count + width - width / 2 - 1; ++i) {
    const std::ptrdiff_t in_period = (i % count + count) % count;
    const auto turns = static_cast<double>((i - in_period) / count);
    around.push_back(sites[static_cast<std::size_t>(in_period)] + turns * period);
  }
  std::vector<double> knots = averages(around, static_cast<std::size_t>(width));
  knots.push_back(knots.front() + period);
  return knots;
}

}  // namespace

std::vector<double> sites_of(std::span<const Condition> conditions) {
  std::vector<double> sites;
  sites.reserve(conditions.size());
  for (const Condition& condition : conditions) sites.push_back(condition.parameter);
  return sites;
}

KnotVector knots_for(std::span<const double> sites, std::span<const double> parameters,
                     const InterpolationOptions& options) {
  const bool closed = is_closed(options);
  if (options.knots.empty()) {
    return KnotVector::make(options.degree, closed ? closed_knots(sites, parameters, options)
                                                   : open_knots(sites, parameters, options), closed);
  }
  KnotVector given = KnotVector::make(options.degree, options.knots, closed);
  if (static_cast<std::size_t>(given.count()) != sites.size()) {
    throw InvalidShape("knots has " + std::to_string(options.knots.size()) + " values, for " +
                       std::to_string(given.count()) + " control points; " + std::to_string(sites.size()) +
                       " conditions are given");
  }
  require_period(given, parameters);
  return given;
}

}  // namespace splinecore
