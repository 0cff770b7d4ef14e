#include "row_spline.hpp"

#include <algorithm>

#include "system.hpp"

namespace splinecore {

namespace {

/// One number in place of a row: system_of() then says by what a row is multiplied.
const glm::dvec3 kOne(1.0);

const std::vector<double>& row_of(const RowConditions& given, const Condition& condition) {
  if (condition.order == 0) return given.rows[condition.point];
  return (condition.point == 0 ? given.start : given.end)[static_cast<std::size_t>(condition.order) - 1];
}

InterpolationOptions options_of(const RowConditions& given, int degree, Closing closing,
                                const std::vector<double>& knots) {
  InterpolationOptions options;
  options.degree = degree;
  options.closing = closing;
  options.knots = knots;
  options.start.assign(given.start.size(), kOne);
  options.end.assign(given.end.size(), kOne);
  require_interpolation(given.rows.size(), given.parameters, options);
  return options;
}

std::vector<Condition> conditions_of(const RowConditions& given, const InterpolationOptions& options) {
  const std::vector<glm::dvec3> places(given.rows.size(), kOne);
  return conditions_of(places, given.parameters, options);
}

}  // namespace

std::vector<double> numbers_of(std::span<const glm::dvec4> row) {
  std::vector<double> numbers;
  for (const glm::dvec4& p : row) numbers.insert(numbers.end(), {p.x, p.y, p.z, p.w});
  return numbers;
}

KnotVector knots_through(const RowConditions& given, int degree, Closing closing, const std::vector<double>& knots) {
  const InterpolationOptions options = options_of(given, degree, closing, knots);
  return knots_for(sites_of(conditions_of(given, options)), given.parameters, options);
}

void solve_rows(const KnotVector& knots, std::span<const double> parameters, std::span<double> rows) {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < parameters.size(); ++i) conditions.push_back({parameters[i], 0, kOne, i});
  solve(knots, system_of(knots, conditions).rows, rows, rows.size() / parameters.size());
}

RowSpline spline_through(const RowConditions& given, int degree, Closing closing, const std::vector<double>& knots) {
  const InterpolationOptions options = options_of(given, degree, closing, knots);
  const std::vector<Condition> conditions = conditions_of(given, options);
  RowSpline spline{knots_for(sites_of(conditions), given.parameters, options), {}};
  const System system = system_of(spline.knots, conditions);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (const double value : row_of(given, conditions[i])) spline.controls.push_back(value * system.right[3 * i]);
  }
  solve(spline.knots, system.rows, spline.controls, given.rows.front().size());
  return spline;
}

}  // namespace splinecore
