#include "splinecore/measure/length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "length_parts.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

double admitted(double u, const Interval& domain, const char* name) {
  constexpr double kSlack = 4.0 * std::numeric_limits<double>::epsilon();
  const double slack = kSlack * std::max(std::abs(domain.start), std::abs(domain.end));
  if (u >= domain.start - slack && u <= domain.end + slack) return std::clamp(u, domain.start, domain.end);
  throw InvalidShape(std::string(name) + " = " + text_of(u) + " is outside the domain [" + text_of(domain.start) +
                     ", " + text_of(domain.end) + "]");
}

void require_order(const Interval& range) {
  if (range.start <= range.end) return;
  throw InvalidShape("start = " + text_of(range.start) + " is above end = " + text_of(range.end));
}

/// Whole turns, and what is left of one, which may lie on both sides of the seam.
Approximation<double> length_around(const NurbsCurve& curve, const Interval& range, double tolerance) {
  const KnotVector& knots = curve.knot_vector();
  const Interval domain = curve.domain();
  const double start = knots.admit(range.start, Side::right, {}, "start");
  const double end = knots.admit(range.end, Side::left, {}, "end");
  require_order(range);
  if (range.start == range.end) return {0.0, 0.0};
  const auto part = [&](double from, double to) { return length_by_parts(curve, {from, to}, tolerance); };
  // Halves, because the distance itself may overflow.
  const double ways = (0.5 * range.end - 0.5 * range.start - (0.5 * end - 0.5 * start)) / (0.5 * domain.length());
  double turns = std::round(ways);
  Approximation<double> total{0.0, 0.0};
  const auto add = [&](double times, const Approximation<double>& more) {
    total.value += times * more.value;
    total.error += times * more.error;
  };
  if (start <= end) {
    add(1.0, part(start, end));
  } else {
    add(1.0, part(start, domain.end));
    add(1.0, part(domain.start, end));
    turns -= 1.0;
  }
  if (turns > 0.0) add(turns, part(domain.start, domain.end));
  if (!std::isfinite(total.value)) throw InvalidShape("the length is too large for a number");
  return total;
}

}  // namespace

Approximation<double> length(const NurbsCurve& curve, Interval range, double tolerance) {
  require_relative(tolerance);
  if (curve.periodic()) return length_around(curve, range, tolerance);
  const Interval domain = curve.domain();
  const Interval within{admitted(range.start, domain, "start"), admitted(range.end, domain, "end")};
  require_order(range);
  return length_by_parts(curve, within, tolerance);
}

Approximation<double> length(const NurbsCurve& curve) { return length(curve, curve.domain()); }

}  // namespace splinecore
