#include "splinecore/measure/arc_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <numeric>
#include <string>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "length_parts.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/length.hpp"

namespace splinecore {

namespace {

/// Lengths along one part.
class PartLength {
 public:
  explicit PartLength(const LengthPart& part) : part_(part) {}

  /// @param t  of the part, which is [0, 1]
  double up_to(double t) {
    before_ = part_.speed;
    before_.cut(t, after_);
    return part_.rule.length(before_).value;
  }

  /// By t, where up_to() was asked for.
  double speed(double t) const {
    const glm::dvec4& slope = before_.slopes.values.back();
    const double w = before_.weights.values.back();
    return length_of(glm::dvec3(slope)) / (t * w * w);
  }

  /// Where the length is this one. Newton's steps that have not come there for long give way to halving, which does.
  double place_of(double length) {
    constexpr int kMostSlopes = 120;
    const double enough = 0x1p-51 * part_.length;
    double low = 0.0;
    double high = 1.0;
    double t = std::clamp(length / part_.length, 0.0, 1.0);
    for (int step = 0; t > low && t < high; ++step) {
      const double rest = length - up_to(t);
      if (std::abs(rest) <= enough) break;
      (rest > 0.0 ? low : high) = t;
      const double next = t + rest / speed(t);
      t = step < kMostSlopes && next > low && next < high ? next : low + 0.5 * (high - low);
    }
    return t;
  }

 private:
  const LengthPart& part_;
  SpeedPiece before_;
  SpeedPiece after_;
};

double parameter_of(const LengthPart& part, double t) {
  return std::lerp(part.span.start, part.span.end, std::lerp(part.part.start, part.part.end, t));
}

/// The places of increasing lengths on all of the curve, and its length.
/// @param take  called with (i, parameter)
template <class Take>
double place_all(const NurbsCurve& curve, std::span<const double> lengths, double tolerance, Take take) {
  // A length that rounding alone takes past the end of a part is that end, not behind where the curve stands still.
  std::size_t next = 0;
  const auto length = length_by_parts(curve, curve.domain(), tolerance, [&](const LengthPart& part) {
    PartLength along(part);
    for (; next < lengths.size(); ++next) {
      const double rest = std::ldexp(lengths[next], -part.exponent) - part.before;
      if (rest > part.length + kRoundingOfSum * (part.before + part.length)) return;
      take(next, parameter_of(part, rest > 0.0 ? along.place_of(rest) : 0.0));
    }
  });
  for (; next < lengths.size(); ++next) take(next, curve.domain().end);
  return length.value;
}

/// Indices that sort the values.
std::vector<std::size_t> order_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(values[i], i); });
  return order;
}

std::vector<double> sorted(std::span<const double> values, std::span<const std::size_t> order) {
  std::vector<double> found;
  for (const std::size_t i : order) found.push_back(values[i]);
  return found;
}

std::vector<double> places(const NurbsCurve& curve, std::span<const double> lengths, double tolerance, double& whole) {
  const std::vector<std::size_t> order = order_of(lengths);
  std::vector<double> found(lengths.size());
  whole = place_all(curve, sorted(lengths, order), tolerance,
                    [&](std::size_t i, double u) { found[order[i]] = u; });
  return found;
}

/// Which of the lengths it is: one alone has no index.
std::string name_of(std::span<const double> lengths, std::size_t i) {
  return "s" + (lengths.size() > 1 ? index_text(i) : "") + " = " + text_of(lengths[i]);
}

void require_lengths(std::span<const double> lengths) {
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (std::isfinite(lengths[i])) continue;
    throw InvalidShape(name_of(lengths, i) + " is not finite");
  }
}

void require_within(std::span<const double> lengths, double whole, double tolerance) {
  const double slack = tolerance * whole;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (lengths[i] >= -slack && lengths[i] <= whole + slack) continue;
    throw InvalidShape(name_of(lengths, i) + " is outside [0, " + text_of(whole) + "], the length of the curve");
  }
}

double positive_length(const NurbsCurve& curve, double tolerance) {
  const double whole = length(curve, curve.domain(), tolerance).value;
  if (!(whole > 0.0)) throw InvalidShape("the curve has no length");
  return whole;
}

std::vector<double> places_around(const NurbsCurve& curve, std::span<const double> lengths, double tolerance) {
  const double whole = positive_length(curve, tolerance);
  std::vector<double> rests;
  std::vector<double> turns;
  for (const double s : lengths) {
    turns.push_back(std::floor(s / whole));
    rests.push_back(std::clamp(std::fma(-turns.back(), whole, s), 0.0, whole));
  }
  double same = 0.0;
  std::vector<double> found = places(curve, rests, tolerance, same);
  const double period = curve.domain().length();
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i] = std::fma(turns[i], period, found[i]);
    if (std::isfinite(found[i])) continue;
    throw InvalidShape(name_of(lengths, i) + " is too many turns");
  }
  return found;
}

constexpr int kMostPlaces = 1 << 22;

/// The places of multiples of a length, the first `count`.
std::vector<double> multiples(const NurbsCurve& curve, double step, int count, double tolerance) {
  std::vector<double> lengths(count);
  for (int i = 0; i < count; ++i) lengths[i] = i * step;
  std::vector<double> found(count);
  place_all(curve, lengths, tolerance, [&](std::size_t i, double u) { found[i] = u; });
  return found;
}

}  // namespace

std::vector<double> parameters_at_lengths(const NurbsCurve& curve, std::span<const double> lengths, double tolerance) {
  require_relative(tolerance);
  require_lengths(lengths);
  if (curve.periodic()) return places_around(curve, lengths, tolerance);
  double whole = 0.0;
  std::vector<double> found = places(curve, lengths, tolerance, whole);
  require_within(lengths, whole, tolerance);
  return found;
}

std::vector<double> lengths_at_parameters(const NurbsCurve& curve, std::span<const double> parameters,
                                          double tolerance) {
  require_relative(tolerance);
  std::vector<double> at;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    at.push_back(curve.knot_vector().admit(parameters[i], Side::right, i));
  }
  const std::vector<std::size_t> order = order_of(at);
  std::vector<double> found(at.size(), 0.0);
  std::size_t next = 0;
  const auto whole = length_by_parts(curve, curve.domain(), tolerance, [&](const LengthPart& part) {
    const double start = parameter_of(part, 0.0);
    const double end = parameter_of(part, 1.0);
    PartLength along(part);
    for (; next < order.size() && at[order[next]] < end; ++next) {
      const double u = at[order[next]];
      const double rest = u > start ? along.up_to(std::min(1.0, (u - start) / (end - start))) : 0.0;
      found[order[next]] = std::ldexp(part.before + rest, part.exponent);
    }
  });
  for (; next < order.size(); ++next) found[order[next]] = whole.value;
  return found;
}

std::vector<double> divide(const NurbsCurve& curve, int count, double tolerance) {
  require_relative(tolerance);
  if (count < 1 || count > kMostPlaces) {
    throw InvalidShape("count = " + std::to_string(count) + " is outside [1, " + std::to_string(kMostPlaces) + "]");
  }
  const double whole = positive_length(curve, tolerance);
  std::vector<double> found = multiples(curve, whole / count, count, tolerance);
  if (!is_closed(curve)) found.push_back(curve.domain().end);
  return found;
}

std::vector<double> divide_by_length(const NurbsCurve& curve, double step, double tolerance) {
  require_relative(tolerance);
  if (!(step > 0.0 && std::isfinite(step))) throw InvalidShape("step = " + text_of(step) + " is not a positive length");
  const double whole = positive_length(curve, tolerance);
  // A part that is short by the tolerance is a part.
  const double steps = std::floor(whole / step * (1.0 + tolerance));
  if (!(steps < kMostPlaces)) {
    throw InvalidShape("step = " + text_of(step) + " makes more than 2^22 parts of the length " + text_of(whole));
  }
  const bool reaches_end = steps * step >= whole * (1.0 - tolerance);
  const int count = static_cast<int>(steps) + (reaches_end && is_closed(curve) ? 0 : 1);
  return multiples(curve, step, std::max(1, count), tolerance);
}

bool is_closed(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  const std::vector<Interval> whole = pieces(curve);
  if (whole.size() != 1 || whole.front() != domain) return false;
  if (curve.periodic()) return multiplicity(curve.knot_vector(), domain.start) <= curve.degree();
  if (is_at_infinity(curve, domain.start, Side::right) || is_at_infinity(curve, domain.end, Side::left)) return false;
  std::array<glm::dvec3, 2> ends;
  const std::array<double, 2> at{domain.start, domain.end};
  evaluate(curve, at, std::span(&ends[0].x, 6));
  return ends[0] == ends[1];
}

}  // namespace splinecore
