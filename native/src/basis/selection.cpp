#include "selection.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/double_double.hpp"
#include "periodic_knots.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

std::vector<int> range_of(int start, int end) {
  std::vector<int> indices(end - start);
  std::iota(indices.begin(), indices.end(), start);
  return indices;
}

int position_of(const KnotVector& knots, double u) {
  return static_cast<int>(std::ranges::find(knots.knots(), u) - knots.knots().begin());
}

int modulo(std::ptrdiff_t i, int count) { return static_cast<int>((i % count + count) % count); }

}  // namespace

int missing_for_cut(const KnotVector& knots, double u) noexcept {
  return knots.degree() + 1 - multiplicity(knots, u);
}

Selection part_before(const KnotVector& knots, double u) {
  const int at = position_of(knots, u);
  const auto given = knots.knots();
  return {KnotVector::make(knots.degree(), {given.begin(), given.begin() + at + knots.degree() + 1}),
          range_of(0, at)};
}

Selection part_after(const KnotVector& knots, double u) {
  const int at = position_of(knots, u);
  const auto given = knots.knots();
  return {KnotVector::make(knots.degree(), {given.begin() + at, given.end()}),
          range_of(at, knots.count())};
}

Selection opened_at(const KnotVector& knots, double u) {
  const auto period = knots.knots();
  // The first of the degree + 1 equal knots; at the seam they may begin before knot 0.
  std::ptrdiff_t at = position_of(knots, u);
  while (periodic_knot(period, at - 1) == u) --at;
  const int degree = knots.degree();
  std::vector<double> plain;
  for (std::ptrdiff_t i = at; i <= at + knots.count() + degree; ++i) plain.push_back(periodic_knot(period, i));
  std::vector<int> indices;
  for (std::ptrdiff_t i = at; i < at + knots.count(); ++i) indices.push_back(modulo(i + degree, knots.count()));
  return {KnotVector::make(degree, std::move(plain)), std::move(indices)};
}

Selection closed_up(const KnotVector& knots) {
  const auto given = knots.knots();
  const int degree = knots.degree();
  const int count = knots.count() - 1;
  std::vector<int> indices(count);
  for (int i = 0; i < count; ++i) indices[(i + degree - 1) % count] = i;
  return {KnotVector::make(degree, {given.begin() + 1, given.begin() + count + 2}, true), std::move(indices)};
}

Selection unrolled(const KnotVector& knots) {
  const auto all = knots.unrolled();
  std::vector<int> indices = range_of(0, knots.unrolled_count());
  for (int& i : indices) i %= knots.count();
  return {KnotVector::make(knots.degree(), {all.begin(), all.end()}), std::move(indices)};
}

namespace {

/// start + end - u, rounded once.
double mirror_image(double u, const Interval& range) {
  return (exact_sum(range.end, -u) + range.start).rounded();
}

/// Whether every `window` steps that have a length keep it but for a few roundings of that length.
bool keeps_steps(std::span<const double> knots, std::span<const double> mirrored, std::size_t window) {
  constexpr double kSlack = 0x1p-30;
  const std::size_t last = knots.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const std::size_t end = std::min(i + window, last);
    const double step = knots[end] - knots[i];
    for (std::size_t k = i + 1; k <= end; ++k) {
      const double moved = (mirrored[last - i] - mirrored[last - k]) - (knots[k] - knots[i]);
      if (!(std::abs(moved) <= kSlack * step)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<double> mirrored(std::span<const double> knots, const Interval& range, std::size_t window) {
  std::vector<double> about_middle(knots.rbegin(), knots.rend());
  for (double& u : about_middle) u = mirror_image(u, range);
  // Rounding may push a knot past an end of the domain by an ulp.
  std::inclusive_scan(about_middle.begin(), about_middle.end(), about_middle.begin(),
                      [](double a, double b) { return std::max(a, b); });
  if (keeps_steps(knots, about_middle, window)) return about_middle;
  std::vector<double> about_zero(knots.rbegin(), knots.rend());
  for (double& u : about_zero) u = 0.0 - u;
  return about_zero;
}

Selection reversed(const KnotVector& knots) {
  std::vector<double> turned = mirrored(knots.knots(), knots.domain(), std::max(1, knots.degree()));
  const int count = knots.count();
  const int last = knots.periodic() ? count + knots.degree() - 1 : count - 1;
  std::vector<int> indices(count);
  for (int i = 0; i < count; ++i) indices[i] = modulo(last - i, count);
  return {KnotVector::make(knots.degree(), std::move(turned), knots.periodic()), std::move(indices)};
}

void require_inside(const KnotVector& knots, double u) {
  if (knots.periodic()) {
    throw InvalidShape("a periodic shape is not cut in two at one parameter: open it there first");
  }
  const Interval range = knots.domain();
  if (u > range.start && u < range.end) return;
  throw InvalidShape("u = " + text_of(u) + " is not inside the domain (" + text_of(range.start) +
                     ", " + text_of(range.end) + ")");
}

}  // namespace splinecore
