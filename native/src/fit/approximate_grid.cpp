#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "along.hpp"
#include "base/length.hpp"
#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "control_counts.hpp"
#include "fitted_points.hpp"
#include "grid.hpp"
#include "least_squares_options.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/fit/approximate.hpp"
#include "splinecore/fit/approximate_patch.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "swing.hpp"
#include "tensor_fit.hpp"

namespace splinecore {

namespace {

FittedAxis axis_of(const NearDirection& given, std::size_t rows, bool fixed_ends) {
  const std::vector<glm::dvec3> places(rows, glm::dvec3(0.0));
  ApproximationOptions options;
  options.smoothing = given.smoothing;
  options.fixed_ends = fixed_ends;
  options.weights = given.weights;
  require_approximation(places, given.parameters, given.closing, options);
  KnotVector knots = given.knots.empty()
                         ? approximating_knots(given.parameters, given.degree, given.count, given.closing)
                         : KnotVector::make(given.degree, given.knots, given.closing == Closing::closed);
  require_approximation_knots(knots, std::span(given.parameters).first(rows), options);
  return {std::move(knots),
          {given.parameters.begin(), given.parameters.begin() + static_cast<std::ptrdiff_t>(rows)},
          given.weights,
          given.smoothing, fixed_ends};
}

std::span<const double> numbers(std::span<const glm::dvec3> points) { return {&points.front().x, 3 * points.size()}; }

Approximation<NurbsPatch> fitted(const PointGrid& grid, const FittedAxis& u, const FittedAxis& v) {
  NurbsPatch made = NurbsPatch::make(u.knots, v.knots, tensor_fit(u, v, numbers(grid.points)));
  std::vector<glm::dvec3> found(grid.points.size());
  evaluate_grid(made, u.parameters, v.parameters, {&found.front().x, 3 * found.size()});
  double error = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) error = std::max(error, distance_of(found[i], grid.points[i]));
  return {std::move(made), error};
}

/// The largest distance of points from their lines that are fitted along one axis alone.
double miss(const FittedAxis& axis, std::span<const double> values, std::size_t columns) {
  const std::vector<double> controls = fitted_rows(axis, values, columns);
  const Samples samples = Samples::make(axis.knots, axis.parameters, 0);
  std::vector<double> left(columns);
  double largest = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto weights = samples.weights(i);
    breathe(4 * weights.size() * columns);
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * columns), columns, left.begin());
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const double* const from = &controls[(static_cast<std::size_t>(samples.first(i)) + k) % axis.count() * columns];
      for (std::size_t c = 0; c < columns; ++c) left[c] -= weights[k] * from[c];
    }
    for (std::size_t c = 0; c < columns; c += 3) {
      largest = std::max(largest, length_of({left[c], left[c + 1], left[c + 2]}));
    }
  }
  return largest;
}

std::size_t least_of(const NearDirection& given) {
  return least_count(given.degree, given.closing == Closing::closed);
}

/// What is refused with the fewest control points is with any number.
NearDirection with_least(NearDirection given) {
  given.count = std::min(given.count, least_of(given));
  return given;
}

/// As few control points along an axis as bring its lines within the tolerance; where none do, the most that numbers tell.
std::size_t sufficient_count(NearDirection given, std::size_t rows, std::span<const double> values, double tolerance,
                             bool fixed_ends) {
  const std::size_t columns = values.size() / rows;
  const std::size_t most = given.count;
  bool is_told = true;
  const auto needs_more = [&](std::size_t count) {
    given.count = count;
    try {
      const bool is_far = miss(axis_of(given, rows, fixed_ends), values, columns) > tolerance;
      if (!is_far) is_told = true;
      return is_far;
    } catch (const InvalidShape&) {
      is_told = false;
      return false;
    }
  };
  const std::size_t least = least_of(given);
  std::size_t low = least - 1;
  std::size_t high = least;
  while (needs_more(high)) {
    if (high == most) return most;
    low = high;
    high = std::min(2 * high, most);
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (needs_more(middle) ? low : high) = middle;
  }
  return is_told || high == least ? high : low;
}

/// The patch on as many control points, if numbers tell them.
std::optional<Approximation<NurbsPatch>> tried(const PointGrid& grid, const NearDirection& u, const NearDirection& v,
                                               bool fixed_ends) {
  try {
    return approximate(grid, u, v, fixed_ends);
  } catch (const InvalidShape&) {
    return {};
  }
}

}  // namespace

Approximation<NurbsPatch> approximate(const PointGrid& grid, const NearDirection& u, const NearDirection& v,
                                      bool fixed_ends) {
  require_grid(grid);
  const FittedAxis along_u = along("u", [&] { return axis_of(u, grid.count_u, fixed_ends); });
  const FittedAxis along_v = along("v", [&] { return axis_of(v, grid.count_v, fixed_ends); });
  return fitted(grid, along_u, along_v);
}

namespace {

/// What was found of a patch within a tolerance.
struct GridSearch {
  std::optional<Approximation<NurbsPatch>> found;
  double least = std::numeric_limits<double>::infinity();  ///< error of a patch that stays near its points
  bool is_swinging = false;                                 ///< others do not
};

void grow(NearDirection& given, std::size_t most) { given.count = std::min(most, given.count + given.count / 4 + 1); }

GridSearch search(const PointGrid& grid, NearDirection u, NearDirection v, double tolerance, bool fixed_ends) {
  constexpr double kShareOfEach = 0.5;
  const NearDirection most_u = u;
  const NearDirection most_v = v;
  static_cast<void>(along("u", [&] { return axis_of(with_least(u), grid.count_u, fixed_ends); }));
  static_cast<void>(along("v", [&] { return axis_of(with_least(v), grid.count_v, fixed_ends); }));
  const auto rows = numbers(grid.points);
  const auto columns = transposed(rows, grid.count_u, grid.count_v);
  u.count = sufficient_count(most_u, grid.count_u, rows, kShareOfEach * tolerance, fixed_ends);
  v.count = sufficient_count(most_v, grid.count_v, columns, kShareOfEach * tolerance, fixed_ends);
  GridSearch made;
  for (;; grow(u, most_u.count), grow(v, most_v.count)) {
    if (auto patch = tried(grid, u, v, fixed_ends)) {
      if (!stays_near(patch->value, grid, u.parameters, v.parameters, {kCalm, tolerance})) {
        made.is_swinging = true;
      } else if (patch->error <= tolerance) {
        made.found = std::move(patch);
        return made;
      } else {
        made.least = std::min(made.least, patch->error);
      }
    }
    if (u.count == most_u.count && v.count == most_v.count) break;
  }
  if (std::isinf(made.least)) made.least = approximate(grid, with_least(most_u), with_least(most_v), fixed_ends).error;
  return made;
}

/// The parameters that are given, or others of which the better ones come first.
std::vector<NearDirection> choices_of(const PointGrid& grid, Axis axis, NearDirection given) {
  given.count = std::min(given.count, grid.count(axis));
  if (!given.parameters.empty()) return {given, given};
  NearDirection calm = given;
  given.parameters = parameters_of(grid, axis, Parameterization::chordal, given.closing);
  calm.parameters = calm_parameters(grid, axis, given.degree, given.closing);
  return {given, calm};
}

}  // namespace

Approximation<NurbsPatch> approximate_within(const PointGrid& grid, NearDirection u, NearDirection v, double tolerance,
                                             bool fixed_ends) {
  require_positive(tolerance);
  require_grid(grid);
  const std::size_t choices = u.parameters.empty() || v.parameters.empty() ? 2 : 1;
  const auto choices_u = choices_of(grid, Axis::u, u);
  const auto choices_v = choices_of(grid, Axis::v, v);
  GridSearch made;
  double least = std::numeric_limits<double>::infinity();
  bool is_swinging = false;
  for (std::size_t i = 0; i < choices; ++i) {
    made = search(grid, choices_u[i], choices_v[i], tolerance, fixed_ends);
    is_swinging |= made.is_swinging;
    if (made.found) return *std::move(made.found);
    least = std::min(least, made.least);
  }
  throw ToleranceNotReached("the points cannot be approximated by " + std::to_string(choices_u.front().count) + " x " +
                                std::to_string(choices_v.front().count) + " control points" +
                                and_smoothing(u.smoothing > 0.0 || v.smoothing > 0.0) + without_swings(is_swinging),
                            tolerance, least);
}

}  // namespace splinecore
