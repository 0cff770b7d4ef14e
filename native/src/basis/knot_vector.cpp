#include "splinecore/basis/knot_vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <string>

#include "base/require.hpp"
#include "kernels/kernels.hpp"
#include "knot_tables.hpp"
#include "periodic_knots.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

void require_degree(int degree) {
  if (degree >= 0 && degree <= kMaxDegree) return;
  throw InvalidShape("degree = " + std::to_string(degree) + " is outside [0, " +
                     std::to_string(kMaxDegree) + "]");
}

/// Whether those that degree others lie before and behind increase.
bool are_simple_inside(std::span<const double> knots, int degree) {
  const std::size_t ends = 2 * static_cast<std::size_t>(degree);
  return knots.size() > ends + 1 && kernels().are_increasing(&knots[degree], knots.size() - ends);
}

/// Also of what is no number, which std::ranges::is_sorted() takes for in order.
bool do_not_fall(std::span<const double> knots) {
  return std::ranges::adjacent_find(knots, [](double a, double b) { return !(a <= b); }) == knots.end();
}

/// Whether they do not decrease, none more often than degree + 1 times.
bool is_in_order(std::span<const double> knots, int degree, bool are_simple) {
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  if (are_simple) {
    return do_not_fall(knots.first(order)) && do_not_fall(knots.last(order));
  }
  std::int64_t wrong = 0;  // as wide as a knot, so that several are compared at once
  for (std::size_t i = 1; i < knots.size(); ++i) wrong += knots[i - 1] <= knots[i] ? 0 : 1;
  for (std::size_t i = order; i < knots.size(); ++i) wrong += knots[i - order] < knots[i] ? 0 : 1;
  return wrong == 0;
}

/// @throws InvalidShape naming the knot that is not in order, or not finite.
void require_order(std::span<const double> knots, int degree, bool are_simple) {
  if (std::isfinite(knots.front()) && std::isfinite(knots.back()) && is_in_order(knots, degree, are_simple)) return;
  require_finite(knots, "knots");
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] < knots[i - 1]) {
      throw InvalidShape("knots" + index_text(i) + " = " + text_of(knots[i]) + " is below knots" +
                         index_text(i - 1) + " = " + text_of(knots[i - 1]));
    }
    const auto first = i - std::min<std::size_t>(i, degree + 1);
    if (i > static_cast<std::size_t>(degree) && knots[i] == knots[first]) {
      throw InvalidShape("knots" + index_text(i) + " = " + text_of(knots[i]) +
                         " has multiplicity above degree + 1 = " + std::to_string(degree + 1));
    }
  }
}

void require_period(std::span<const double> knots, int degree) {
  const auto leading = static_cast<std::ptrdiff_t>(std::ranges::equal_range(knots, knots.front()).size());
  const auto trailing = static_cast<std::ptrdiff_t>(std::ranges::equal_range(knots, knots.back()).size());
  if (knots.front() == knots.back()) {
    throw InvalidShape("knots" + index_text(knots.size() - 1) + " = " + text_of(knots.back()) +
                       " equals knots[0]: the period has no length");
  }
  if (leading + trailing - 1 > degree + 1) {
    throw InvalidShape("knots[0] = " + text_of(knots.front()) +
                       " has multiplicity above degree + 1 = " + std::to_string(degree + 1) +
                       " together with the end of the period");
  }
}

std::vector<double> unroll(std::span<const double> period, int degree) {
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(period.size()) - 1;
  std::vector<double> unrolled;
  unrolled.reserve(count + 2 * degree + 1);
  for (std::ptrdiff_t i = -degree; i <= count + degree; ++i) unrolled.push_back(periodic_knot(period, i));
  return unrolled;
}

std::vector<int> positive_spans(std::span<const double> knots, int degree, bool are_simple) {
  const int last = static_cast<int>(knots.size()) - degree - 1;
  std::vector<int> spans(std::max(last - degree, 0));
  if (are_simple) {
    std::iota(spans.begin(), spans.end(), degree);
    return spans;
  }
  std::size_t count = 0;
  for (int k = degree; k < last; ++k) {
    spans[count] = k;
    count += knots[k] < knots[k + 1] ? 1 : 0;
  }
  spans.resize(count);
  return spans;
}

/// The matrices of all spans may take 1 GB.
void require_size(int degree, std::size_t spans) {
  const std::size_t order = degree + 1;
  if (order * order * spans <= std::size_t{1} << 27) return;
  throw InvalidShape("knots of degree " + std::to_string(degree) + " with " + std::to_string(spans) +
                     " spans are too many to be evaluated");
}

std::vector<double> repeated(double low, double high, int times) {
  std::vector<double> knots(times, low);
  knots.insert(knots.end(), times, high);
  return knots;
}

/// A vector that cannot be built is refused before its memory is asked for.
void require_count(int degree, int count) {
  require_degree(degree);
  constexpr int kMaxCount = 1 << 28;
  if (count < 1 || count > kMaxCount) {
    throw InvalidShape("count = " + std::to_string(count) + " is outside [1, " +
                       std::to_string(kMaxCount) + "]");
  }
}

}  // namespace

KnotVector KnotVector::make(int degree, std::vector<double> knots, bool periodic) {
  require_degree(degree);
  const std::size_t needed = periodic ? 2 : degree + 2;
  if (knots.size() < needed) {
    throw InvalidShape("knots has " + std::to_string(knots.size()) + " values, at least " +
                       std::to_string(needed) + " are needed for degree " + std::to_string(degree));
  }
  const bool are_simple = are_simple_inside(knots, degree);
  require_order(knots, degree, are_simple);
  if (!std::isfinite(knots.back() - knots.front())) {
    throw InvalidShape("knots from " + text_of(knots.front()) + " to " + text_of(knots.back()) +
                       " overflow: their distance is not a finite number");
  }
  if (periodic) require_period(knots, degree);

  auto state = std::make_shared<State>();
  state->degree = degree;
  state->periodic = periodic;
  state->count = static_cast<int>(knots.size()) - (periodic ? 1 : degree + 1);
  if (periodic) state->periods = unroll(knots, degree);
  state->knots = std::move(knots);
  state->unrolled = periodic ? state->periods : state->knots;
  const bool are_spans_simple = periodic ? are_simple_inside(state->unrolled, degree) : are_simple;
  state->spans = positive_spans(state->unrolled, degree, are_spans_simple);
  require_size(degree, state->spans.size());
  state->tables = std::make_shared<KnotTables>(state->unrolled, state->spans, degree);
  return KnotVector(std::move(state));
}

KnotVector KnotVector::bezier(int degree) {
  require_degree(degree);
  // One for each degree: pieces by the thousand share their knots.
  static std::array<std::once_flag, kMaxDegree + 1> flags;
  static std::array<std::optional<KnotVector>, kMaxDegree + 1> known;
  std::call_once(flags[degree], [&] { known[degree] = make(degree, repeated(0.0, 1.0, degree + 1)); });
  return *known[degree];
}

KnotVector KnotVector::clamped(int degree, int count) {
  require_count(degree, count);
  if (count <= degree) {
    throw InvalidShape("count = " + std::to_string(count) + " is below degree + 1 = " +
                       std::to_string(degree + 1));
  }
  std::vector<double> knots = repeated(0.0, count - degree, degree);
  std::vector<double> inner(count - degree + 1);
  std::iota(inner.begin(), inner.end(), 0.0);
  knots.insert(knots.begin() + degree, inner.begin(), inner.end());
  return make(degree, std::move(knots));
}

KnotVector KnotVector::uniform(int degree, int count) {
  require_count(degree, count);
  std::vector<double> knots(count + degree + 1);
  std::iota(knots.begin(), knots.end(), 0.0);
  return make(degree, std::move(knots));
}

KnotVector KnotVector::periodic_uniform(int degree, int count) {
  require_count(degree, count);
  std::vector<double> knots(count + 1);
  std::iota(knots.begin(), knots.end(), 0.0);
  return make(degree, std::move(knots), true);
}

int KnotVector::unrolled_count() const noexcept {
  return state_->count + (state_->periodic ? state_->degree : 0);
}

Interval KnotVector::domain() const {
  if (!has_domain()) {
    throw InvalidShape("knots leave no domain: for degree " + std::to_string(degree()) +
                       " the knots u_" + std::to_string(degree()) + " and u_" +
                       std::to_string(count()) + " must differ");
  }
  return {state_->unrolled[degree()], state_->unrolled[unrolled_count()]};
}

Interval KnotVector::span_interval(int i) const noexcept {
  const int k = state_->spans[i];
  return {state_->unrolled[k], state_->unrolled[k + 1]};
}

double KnotVector::admit(double u, Side side, std::optional<std::size_t> index, const char* name) const {
  const Interval range = domain();
  if (u > range.start && u < range.end) return u;
  if (periodic() && std::isfinite(u)) {
    const double period = range.length();
    // Halves, because the distance itself may overflow.
    double rest = 2.0 * std::fmod(0.5 * u - 0.5 * range.start, 0.5 * period);
    if (rest < 0.0) rest += period;
    if (rest == 0.0) return side == Side::right ? range.start : range.end;
    return std::min(range.start + rest, range.end);
  }
  const double slack = 4.0 * std::numeric_limits<double>::epsilon() *
                       std::max(std::abs(range.start), std::abs(range.end));
  if (u >= range.start - slack && u <= range.end + slack) {
    return std::clamp(u, range.start, range.end);
  }
  throw InvalidShape(name + (index ? index_text(*index) : "") + " = " + text_of(u) + " is outside the domain [" +
                     text_of(range.start) + ", " + text_of(range.end) + "]");
}

int KnotVector::span_of(double u, Side side) const { return state_->tables->finder.find(u, side); }

SquareRows KnotVector::bezier_matrix(int i) const {
  return {state_->tables->rows(*this, i, 0), static_cast<std::size_t>(degree()) + 1, table_width(degree())};
}

bool operator==(const KnotVector& a, const KnotVector& b) noexcept {
  return a.state_ == b.state_ || (a.degree() == b.degree() && a.periodic() == b.periodic() &&
                                  std::ranges::equal(a.knots(), b.knots()));
}

double periodic_image(std::span<const double> period, double u, std::ptrdiff_t turns) noexcept {
  const double start = period.front();
  const double end = period.back();
  const double length = end - start;
  // Relative to the nearer end, so that an image of an end is equal to a knot of that value.
  if (turns > 0) return end + ((u - start) + static_cast<double>(turns - 1) * length);
  if (turns < 0) return start + ((u - end) + static_cast<double>(turns + 1) * length);
  return u;
}

double periodic_knot(std::span<const double> period, std::ptrdiff_t i) noexcept {
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(period.size()) - 1;
  if (i >= 0 && i <= count) return period[i];
  const std::ptrdiff_t turns = i / count - (i % count < 0 ? 1 : 0);
  return periodic_image(period, period[i - turns * count], turns);
}

int multiplicity(const KnotVector& knots, double u) noexcept {
  const auto given = knots.knots();
  if (!(u >= given.front() && u <= given.back())) return 0;
  const auto times = [&](double knot) { return static_cast<int>(std::ranges::equal_range(given, knot).size()); };
  if (!knots.periodic() || (u != given.front() && u != given.back())) return times(u);
  return times(given.front()) + times(given.back()) - 1;
}

}  // namespace splinecore
