#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "base/require.hpp"
#include "base/sort_by.hpp"
#include "build/fit_options.hpp"
#include "control_counts.hpp"
#include "fitted_points.hpp"
#include "least_squares_options.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "swing.hpp"

namespace splinecore {

namespace {

/// Points and what is asked of the curve, on ever other knots.
struct Task {
  std::span<const glm::dvec3> points;
  std::vector<double> parameters;  ///< of the points; corrected as knots change
  const ApproximationOptions& options;
  double tolerance;
  std::size_t most;
  double start;              ///< the first parameter that was given
  double end;                ///< the last one, where closed of the return
  double most_swing;         ///< as of Swing
  bool is_swinging = false;  ///< a curve was within the tolerance, and far from the points in between
};

bool is_near(const NurbsCurve& curve, Task& task) {
  std::vector<double> around = task.parameters;
  if (curve.periodic()) around.push_back(around.front() + (task.end - task.start));
  if (stays_near(curve, task.points, around, {task.most_swing, task.tolerance})) return true;
  task.is_swinging = true;
  return false;
}

bool is_within(const FittedPoints& fit, Task& task) {
  return fit.error <= task.tolerance && is_near(fit.curve(), task);
}

/// The distinct knots of the domain.
std::vector<double> breaks_of(const KnotVector& knots) {
  std::vector<double> breaks{knots.domain().start};
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) breaks.push_back(knots.span_interval(i).end);
  return breaks;
}

/// Simple knots at these places, clamped at the ends of an open curve.
KnotVector on_breaks(const KnotVector& like, std::span<const double> breaks) {
  const std::size_t copies = like.periodic() ? 0 : static_cast<std::size_t>(like.degree());
  std::vector<double> knots(copies, breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), copies, breaks.back());
  return KnotVector::make(like.degree(), std::move(knots), like.periodic());
}

/// Where a span is halved: between the two of its points in the middle, if some are left on each side:
/// with fewer the curve swings between them.
std::optional<double> halving_place(const Task& task, std::size_t begin, std::size_t end, int degree) {
  const auto fewest = static_cast<std::size_t>(std::max(4, degree + 1));
  if (end - begin < fewest) return {};
  const std::size_t i = begin + (end - begin) / 2;
  const double place = task.parameters[i - 1] + 0.5 * (task.parameters[i] - task.parameters[i - 1]);
  if (place > task.parameters[i - 1] && place < task.parameters[i]) return place;
  return {};
}

/// Knots with the spans halved that have a point too far away: the worst ones, where there is no room for all.
/// @returns nothing where none can be
std::optional<KnotVector> finer(const FittedPoints& fit, const Task& task) {
  const std::vector<double> breaks = breaks_of(fit.knots);
  std::vector<std::pair<double, double>> places;  // error and place
  std::size_t i = 0;
  for (std::size_t s = 0; s < fit.span_errors.size(); ++s) {
    const std::size_t begin = i;
    const bool is_last = s + 1 == fit.span_errors.size();
    while (i < task.parameters.size() && (is_last || task.parameters[i] < breaks[s + 1])) ++i;
    if (fit.span_errors[s] <= task.tolerance) continue;
    if (const auto place = halving_place(task, begin, i, fit.knots.degree())) places.emplace_back(fit.span_errors[s], *place);
  }
  const auto count = static_cast<std::size_t>(fit.knots.count());
  if (places.empty() || count >= task.most) return {};
  const std::size_t room = std::min(places.size(), task.most - count);
  std::ranges::partial_sort(places, places.begin() + static_cast<std::ptrdiff_t>(room), std::greater{});
  std::vector<double> all = breaks;
  for (std::size_t k = 0; k < room; ++k) all.push_back(places[k].second);
  std::ranges::sort(all);
  return on_breaks(fit.knots, all);
}

/// The curve on these knots, if they have a solution.
std::optional<FittedPoints> fit_on(const KnotVector& knots, Task& task) {
  try {
    return corrected_fit(task.points, task.parameters, knots, task.options);
  } catch (const InvalidShape&) {
    return {};
  }
}

/// How much the highest derivative jumps at each inner knot, times the size of the spans beside it: what its removal
/// would cost, or so.
std::vector<double> jumps_of(const FittedPoints& fit) {
  const int degree = fit.knots.degree();
  const auto width = static_cast<std::size_t>(degree) + 1;
  const std::size_t spans = fit.span_errors.size();
  const std::size_t count = fit.controls.size();
  std::vector<glm::dvec3> tops(spans);
  for (std::size_t s = 0; s < spans; ++s) {
    const SquareRows matrix = fit.knots.bezier_matrix(static_cast<int>(s));
    const auto first = static_cast<std::size_t>(fit.knots.spans()[s]) - (width - 1);
    std::vector<glm::dvec3> piece(width, glm::dvec3(0.0));
    for (std::size_t j = 0; j < width; ++j) {
      for (std::size_t a = 0; a < width; ++a) piece[j] += matrix[j][a] * fit.controls[(first + a) % count];
    }
    for (int k = 0; k < degree; ++k) {
      for (std::size_t j = 0; j + 1 < width - static_cast<std::size_t>(k); ++j) piece[j] = piece[j + 1] - piece[j];
    }
    tops[s] = piece[0];
  }
  const std::vector<double> breaks = breaks_of(fit.knots);
  std::vector<double> jumps;
  for (std::size_t s = 0; s + 1 < spans; ++s) {
    const double left = breaks[s + 1] - breaks[s];
    const double right = breaks[s + 2] - breaks[s + 1];
    const double whole = left + right;
    jumps.push_back(glm::length(std::pow(whole / right, degree) * tops[s + 1] - std::pow(whole / left, degree) * tops[s]));
  }
  return jumps;
}

/// Knots without some `number` of the inner ones that jump least, no two of them neighbors.
/// @param spared  so many that jump less stay
KnotVector coarser(const FittedPoints& fit, std::size_t number, std::size_t spared) {
  const std::vector<double> jumps = jumps_of(fit);
  std::vector<std::size_t> order(jumps.size());
  std::iota(order.begin(), order.end(), 0);
  sort_by(order, [&](std::size_t i) { return jumps[i]; });
  std::vector<bool> is_out(jumps.size() + 2, false);  // by break
  for (const std::size_t i : std::span(order).subspan(std::min(spared, order.size()))) {
    if (number == 0) break;
    if (is_out[i] || is_out[i + 1] || (i + 2 < is_out.size() && is_out[i + 2])) continue;
    is_out[i + 1] = true;
    --number;
  }
  const std::vector<double> breaks = breaks_of(fit.knots);
  std::vector<double> left;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    if (!is_out[i]) left.push_back(breaks[i]);
  }
  return on_breaks(fit.knots, left);
}

/// Takes knots away as long as the curve stays within the tolerance: half of them at a time, then fewer, then some one by
/// one that seem to cost more.
FittedPoints thinned(FittedPoints fit, Task& task) {
  const std::size_t least = least_count(fit.knots.degree(), fit.knots.periodic());
  constexpr std::size_t kMostSpared = 16;
  std::size_t number = fit.controls.size() / 2;
  std::size_t spared = 0;
  while (spared < kMostSpared && fit.controls.size() > least && fit.span_errors.size() > spared + 1) {
    number = std::clamp<std::size_t>(number, 1, fit.controls.size() - least);
    const std::vector<double> before = task.parameters;
    auto next = fit_on(coarser(fit, number, spared), task);
    if (next && next->controls.size() < fit.controls.size() && is_within(*next, task)) {
      fit = *std::move(next);
      continue;
    }
    task.parameters = before;
    if (number == 1) ++spared;
    number /= 2;
  }
  return fit;
}

/// The curve through all points, which is within every tolerance that rounding leaves, and thinner ones on its knots.
std::optional<Approximation<NurbsCurve>> through_all(std::span<const double> parameters, int degree, Closing closing,
                                                     Task& task) {
  InterpolationOptions exact;
  exact.degree = degree;
  exact.closing = closing;
  exact.start = task.options.start;
  exact.end = task.options.end;
  try {
    Approximation<NurbsCurve> made = interpolate(task.points, parameters, exact);
    if (made.error > task.tolerance) return {};
    task.parameters.assign(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(task.points.size()));
    const bool is_taken = is_near(made.value, task);
    auto fit = fit_on(made.value.knot_vector(), task);
    if (!fit || !is_within(*fit, task)) return is_taken ? std::optional(std::move(made)) : std::nullopt;
    fit = thinned(*std::move(fit), task);
    return Approximation<NurbsCurve>{fit->curve(), fit->error};
  } catch (const InvalidShape&) {
    return {};
  }
}

/// As few control points as the degree, and the ends with their derivatives, need.
/// @throws InvalidShape if there are not so many points, or `most` are fewer.
KnotVector coarsest(std::span<const double> parameters, std::size_t points, int degree, Closing closing,
                    std::size_t most, const ApproximationOptions& options) {
  const bool is_closed = closing == Closing::closed;
  const std::size_t least = least_count(degree, is_closed);
  require_enough_points(points, degree, is_closed);
  require_count(most, degree, is_closed);
  if (is_closed) return approximating_knots(parameters, degree, least, closing);
  const std::size_t derivatives = options.start.size() + options.end.size();
  if (points < 2 + derivatives) {
    throw InvalidShape(std::to_string(points) + " points are too few beside " + std::to_string(derivatives) +
                       " derivatives at the ends, which need at least " + std::to_string(2 + derivatives));
  }
  if (options.fixed_ends) require_room_for_ends(most, 2 + derivatives);
  return approximating_knots(parameters, degree, std::max(least, 2 + derivatives), closing);
}

/// Knots where they are needed; where that does not help the curve through all points.
/// @param least  takes the least error of what was near the points
std::optional<Approximation<NurbsCurve>> refined(const KnotVector& knots, std::span<const double> parameters,
                                                 Closing closing, Task& task, double& least) {
  FittedPoints fit = corrected_fit(task.points, task.parameters, knots, task.options);
  bool is_done = is_within(fit, task);
  while (!is_done) {
    least = std::min(least, std::max(fit.error, task.tolerance));
    const auto next = finer(fit, task);
    if (!next) break;
    auto made = fit_on(*next, task);
    if (!made) break;
    fit = *std::move(made);
    is_done = is_within(fit, task);
  }
  if (is_done) {
    fit = thinned(std::move(fit), task);
    return Approximation<NurbsCurve>{fit.curve(), fit.error};
  }
  const std::size_t conditions = task.points.size() + task.options.start.size() + task.options.end.size();
  if (task.most < conditions || task.options.smoothing > 0.0) return {};
  return through_all(parameters, knots.degree(), closing, task);
}

/// The first curve that is found, of those that stay near their points rather than of those that swing wide.
/// @param choices  of parameters, the better ones first
/// @throws InvalidShape where the points decide about no curve at the last of them
Approximation<NurbsCurve> within(std::span<const glm::dvec3> points, std::span<const std::vector<double>> choices,
                                 int degree, Closing closing, double tolerance, std::size_t most,
                                 const ApproximationOptions& options) {
  double least = std::numeric_limits<double>::infinity();
  bool is_swinging = false;
  for (const double swing : {kCalm, kWide}) {
    if (swing == kWide && !is_swinging) break;
    for (const std::vector<double>& parameters : choices) {
      const KnotVector knots = coarsest(parameters, points.size(), degree, closing, most, options);
      Task task{points, {parameters.begin(), parameters.begin() + std::ssize(points)}, options, tolerance,
                most, parameters.front(), parameters.back(), swing};
      try {
        if (auto made = refined(knots, parameters, closing, task, least)) return *std::move(made);
      } catch (const InvalidShape&) {
        if (&parameters == &choices.back()) throw;
      }
      is_swinging |= task.is_swinging;
    }
  }
  throw ToleranceNotReached("the points cannot be approximated by " + std::to_string(most) + " control points" +
                                and_smoothing(options.smoothing > 0.0) + without_swings(is_swinging),
                            tolerance, least);
}

}  // namespace

Approximation<NurbsCurve> approximate_within(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                             int degree, Closing closing, double tolerance, std::size_t most,
                                             const ApproximationOptions& options) {
  require_positive(tolerance);
  require_approximation(points, parameters, closing, options);
  const std::vector<double> given(parameters.begin(), parameters.end());
  return within(points, {&given, 1}, degree, closing, tolerance, most, options);
}

Approximation<NurbsCurve> approximate_within(std::span<const glm::dvec3> points, int degree, Closing closing,
                                             double tolerance, std::size_t most, const ApproximationOptions& options) {
  require_positive(tolerance);
  const std::array choices{parameters_of(points, Parameterization::chordal, closing),
                           calm_parameters(points, degree, closing)};
  require_approximation(points, choices.front(), closing, options);
  return within(points, choices, degree, closing, tolerance, most, options);
}

}  // namespace splinecore
