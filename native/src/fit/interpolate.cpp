#include "splinecore/fit/interpolate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/length.hpp"
#include "basis/blossom.hpp"
#include "basis/span_tables.hpp"
#include "knot_points.hpp"
#include "near_points.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// Of a solution without exchanges: the largest distance beside the largest coordinate.
constexpr double kAccurate = 1e-13;

std::vector<glm::dvec4> solved(const KnotVector& knots, System system) {
  solve(knots, system.rows, system.right, 3);
  std::vector<glm::dvec4> points(system.rows.count());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const row = system.right.data() + 3 * i;
    points[i] = {row[0], row[1], row[2], 1.0};
    require_control_point(glm::dvec3(points[i]));
  }
  return points;
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

/// By a general system.
Approximation<NurbsCurve> general_curve(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                        const InterpolationOptions& options) {
  const std::vector<Condition> conditions = conditions_of(points, parameters, options);
  const KnotVector knots = knots_for(sites_of(conditions), parameters, options);
  const System system = system_of(knots, conditions);
  NurbsCurve curve = NurbsCurve::make(knots, solved(knots, system));
  const double error = largest_distance(curve, system.rows, conditions);
  return {std::move(curve), error};
}

}  // namespace

Approximation<NurbsCurve> interpolate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const InterpolationOptions& options) {
  require_interpolation(points.size(), parameters, options);
  const double largest = largest_coordinate(points);
  auto near = near_curve(points, parameters, options, largest);
  if (near && near->error <= kAccurate * largest) return *std::move(near);
  Approximation<NurbsCurve> curve = general_curve(points, parameters, options);
  require_passing(curve.error, largest);
  return curve;
}

}  // namespace splinecore
