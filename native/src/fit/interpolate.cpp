#include "splinecore/fit/interpolate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/length.hpp"
#include "basis/blossom.hpp"
#include "basis/span_tables.hpp"
#include "knot_points.hpp"
#include "near_points.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// Of a solution without exchanges: the largest distance beside the largest coordinate.
constexpr double kAccurate = 1e-13;

/// Larger ones are no numbers any more beside others.
constexpr double kMostValue = 1e150;

/// A solution and what is known of it.
struct Solved {
  std::vector<glm::dvec4> points;
  double size;         ///< the largest coordinate of a point or control point
  double uncertainty;  ///< how far rounding may have moved the curve
};

/// The largest value of the function with these coefficients, at some places of each span.
double largest_value(const KnotVector& knots, std::span<const glm::dvec4> coefficients) {
  constexpr int kEach = 4;
  std::vector<double> places;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (int k = 0; k < kEach; ++k) places.push_back(span.start + (k + 0.5) / kEach * (span.end - span.start));
  }
  std::vector<glm::dvec3> values(places.size());
  evaluate(NurbsCurve::make(knots, {coefficients.begin(), coefficients.end()}), places,
           {&values.front().x, 3 * values.size()});
  double largest = 0.0;
  for (const glm::dvec3& value : values) largest = std::max(largest, std::abs(value.x));
  return largest;
}

/// 1 and -1 without a pattern, the same in every call.
double sign_of(std::size_t i) noexcept {
  const auto mixed = static_cast<std::uint64_t>(i + 1) * 0x9E3779B97F4A7C15u;
  return ((mixed ^ (mixed >> 29)) * 0xBF58476D1CE4E5B9u >> 63) == 0 ? 1.0 : -1.0;
}

/// Beside the points the function of ones without a pattern is found. Rounding changes values as much as it is, times
/// their rounding.
Solved solved(const KnotVector& knots, const System& system, double largest) {
  constexpr std::size_t kColumns = 4;
  const std::size_t count = system.rows.count();
  std::vector<double> right(kColumns * count);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(&system.right[3 * i], 3, &right[kColumns * i]);
    right[kColumns * i + 3] = sign_of(i);
  }
  solve(knots, system.rows, right, kColumns);
  Solved made{std::vector<glm::dvec4>(count), largest, 0.0};
  std::vector<glm::dvec4> signs(count);
  bool is_told = true;
  for (std::size_t i = 0; i < count; ++i) {
    const double* const row = &right[kColumns * i];
    made.points[i] = {row[0], row[1], row[2], 1.0};
    require_control_point(glm::dvec3(made.points[i]));
    made.size = std::max({made.size, std::abs(row[0]), std::abs(row[1]), std::abs(row[2])});
    signs[i] = {row[3], 0.0, 0.0, 1.0};
    is_told &= std::abs(row[3]) < kMostValue;
  }
  made.uncertainty = is_told ? largest_value(knots, signs) * std::numeric_limits<double>::epsilon() * made.size
                             : std::numeric_limits<double>::infinity();
  return made;
}

/// Of the curve from its points, as it is evaluated.
double measured_distance(const NurbsCurve& curve, std::span<const Condition> conditions) {
  std::vector<double> places;
  std::vector<glm::dvec3> wanted;
  for (const Condition& condition : conditions) {
    if (condition.order > 0) continue;
    places.push_back(condition.parameter);
    wanted.push_back(condition.value);
  }
  std::vector<glm::dvec3> found(places.size());
  evaluate(curve, places, {&found.front().x, 3 * found.size()});
  double largest = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) largest = std::max(largest, distance_of(found[i], wanted[i]));
  return largest;
}

/// Of the curve from its points.
double largest_distance(const NurbsCurve& curve, const BandedRows& rows, std::span<const Condition> conditions) {
  const std::span<const glm::dvec4> points = curve.points();
  double largest = 0.0;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].order > 0) continue;
    breathe(4 * rows.width);
    const auto row = rows.row(i);
    glm::dvec3 left = conditions[i].value;
    std::size_t at = static_cast<std::size_t>(rows.first[i]) % points.size();
    for (const double weight : row) {
      left -= weight * glm::dvec3(points[at]);
      if (++at == points.size()) at = 0;
    }
    largest = std::max(largest, length_of(left));
  }
  return largest;
}

/// How many derivatives of zero natural ends have beside their point.
std::size_t count_of_zeros(const InterpolationOptions& options) {
  return options.ends == FitEnds::natural ? static_cast<std::size_t>(options.degree) / 2 : 0;
}

/// Derivatives of the functions on a span, whose first knot is *knot, at the parameter u.
EndRow end_row(const double* knot, int degree, double u, int order, const glm::dvec3& value) {
  std::array<double, kMaxDegree> same;
  const std::span<double> arguments(same.data(), static_cast<std::size_t>(degree - order));
  std::ranges::fill(arguments, u);
  EndRow row{std::vector<double>(static_cast<std::size_t>(degree) + 1, 0.0), order, value};
  blossom_weights(knot - (degree - order), degree - order, arguments, row.functions.data());
  differentiate(knot, degree - order, row.functions);
  double largest = order == 0 ? 1.0 : 0.0;
  for (const double weight : row.functions) largest = std::max(largest, std::abs(weight));
  for (double& weight : row.functions) weight /= largest;
  row.value /= largest;
  return row;
}

std::vector<EndRow> end_rows(const double* knot, double u, const glm::dvec3& point,
                             std::span<const glm::dvec3> derivatives, const InterpolationOptions& options) {
  const int degree = options.degree;
  std::vector<EndRow> rows;
  rows.reserve(static_cast<std::size_t>(degree) + 1);
  rows.push_back(end_row(knot, degree, u, 0, point));
  for (const glm::dvec3& derivative : derivatives) {
    rows.push_back(end_row(knot, degree, u, static_cast<int>(rows.size()), derivative));
  }
  for (int k = (degree + 1) / 2; options.ends == FitEnds::natural && k < degree; ++k) {
    rows.push_back(end_row(knot, degree, u, k, glm::dvec3(0.0)));
  }
  return rows;
}

/// The parameters, and those of the ends once more for each condition there.
std::vector<double> repeated(std::span<const double> parameters, std::size_t at_start, std::size_t at_end) {
  std::vector<double> sites(at_start, parameters.front());
  sites.insert(sites.end(), parameters.begin(), parameters.end());
  sites.insert(sites.end(), at_end, parameters.back());
  return sites;
}

NearPoints near_points(const KnotVector& knots, std::span<const glm::dvec3> points, std::span<const double> parameters,
                       const InterpolationOptions& options, double largest) {
  const std::span<const double> chain = knots.knots();
  const double* const first = &chain[knots.degree()];
  const double* const final = &chain[knots.count() - 1];
  const std::size_t last = points.size() - 1;
  // Not-a-knot cubics: the point next to an end is in its span, and belongs to its rows.
  const bool are_beside = knots.degree() == 3 && static_cast<std::size_t>(knots.count()) == points.size() && last > 4 &&
                          first[1] == parameters[2] && *final == parameters[last - 2];
  const std::size_t taken = are_beside ? 2 : 1;
  const std::size_t inner = points.size() - 2 * taken;
  NearPoints system{options.degree, chain, parameters.subspan(taken, inner), points.subspan(taken, inner),
                    end_rows(first, parameters.front(), points.front(), options.start, options),
                    end_rows(final, parameters.back(), points.back(), options.end, options), largest};
  if (are_beside) {
    system.start.push_back(end_row(first, 3, parameters[1], 0, points[1]));
    system.end.push_back(end_row(final, 3, parameters[last - 1], 0, points[last - 1]));
  }
  std::ranges::reverse(system.end);
  return system;
}

/// Open curves whose conditions lie near the knots of their control points: nearly all. Where several derivatives of
/// order above 1 follow none, or lie inside, rows may have to be exchanged, which general systems do.
std::optional<Approximation<NurbsCurve>> near_curve(std::span<const glm::dvec3> points,
                                                    std::span<const double> parameters,
                                                    const InterpolationOptions& options, double largest) {
  const auto degree = static_cast<std::size_t>(options.degree);
  const std::size_t zeros = count_of_zeros(options);
  const bool is_plain = options.closing == Closing::open && options.tangents.empty() && zeros <= 1;
  if (!is_plain || points.size() <= degree) return {};
  std::vector<double> more;
  if (!options.start.empty() || !options.end.empty() || zeros > 0) {
    more = repeated(parameters, options.start.size() + zeros, options.end.size() + zeros);
  }
  KnotVector knots = knots_for(more.empty() ? parameters : more, parameters, options);
  const std::span<const double> chain = knots.knots();
  const auto count = static_cast<std::size_t>(knots.count());
  const bool are_spans = chain[degree] < chain[degree + 1] && chain[count - 1] < chain[count];
  if (!are_spans || chain[degree] != parameters.front() || chain[count] != parameters.back()) return {};
  const NearPoints system = near_points(knots, points, parameters, options, largest);
  std::optional<NearSolution> found = solve_at_knots(system);
  if (!found || !(found->error <= kAccurate * largest)) found = solve_near(system);
  if (!found) return {};
  return Approximation<NurbsCurve>{NurbsCurve::make(std::move(knots), std::move(found->points)), found->error};
}

/// Whether steps beside each other are so even that values of such a degree are hardly made larger between them.
bool are_even(std::span<const double> parameters, int degree) {
  const double most = std::exp2(30.0 / degree);
  const auto window = static_cast<std::size_t>(degree) + 1;
  const auto step = [&](std::size_t i) { return parameters[i + 1] - parameters[i]; };
  double low = step(0);
  double high = low;
  for (std::size_t i = 1; i + 1 < parameters.size(); ++i) {
    low = std::min(low, step(i));
    high = std::max(high, step(i));
  }
  if (high <= most * low) return true;
  for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
    low = high = step(i);
    for (std::size_t k = i + 1; k < std::min(i + window, parameters.size() - 1); ++k) {
      low = std::min(low, step(k));
      high = std::max(high, step(k));
    }
    if (high > most * low) return false;
  }
  return true;
}

/// By a general system.
Approximation<NurbsCurve> general_curve(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                        const InterpolationOptions& options, double largest) {
  const std::vector<Condition> conditions = conditions_of(points, parameters, options);
  const KnotVector knots = knots_for(sites_of(conditions), parameters, options);
  const System system = system_of(knots, conditions);
  Solved made = solved(knots, system, largest);
  NurbsCurve curve = NurbsCurve::make(knots, std::move(made.points));
  const double error = std::max(largest_distance(curve, system.rows, conditions), measured_distance(curve, conditions));
  require_passing(error, largest);
  require_passing(made.uncertainty, made.size);
  return {std::move(curve), error};
}

}  // namespace

Approximation<NurbsCurve> interpolate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const InterpolationOptions& options) {
  require_interpolation(points.size(), parameters, options);
  const double largest = largest_coordinate(points);
  if (are_even(parameters, options.degree)) {
    auto near = near_curve(points, parameters, options, largest);
    if (near && near->error <= kAccurate * largest) return *std::move(near);
  }
  return general_curve(points, parameters, options, largest);
}

}  // namespace splinecore
