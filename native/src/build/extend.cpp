#include "splinecore/build/extend.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "curve_ends.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/measure/length.hpp"
#include "with_end.hpp"

namespace splinecore {

namespace {

double curvature_at_end(const NurbsCurve& curve) {
  const double u = curve.domain().end;
  double bend = 0.0;
  curvature(curve, std::span(&u, 1), std::span(&bend, 1), Side::left);
  return bend;
}

/// None where the curve is straight.
std::optional<NurbsCurve> arc_on(const NurbsCurve& curve, const DirectedEnd& end, double length) {
  const double u = curve.domain().end;
  MovingFrame frame;
  frenet_frames(curve, std::span(&u, 1), std::span(&frame, 1), Side::left);
  const double bend = curvature_at_end(curve);
  constexpr double kStraight = 0x1p-40;
  const double angle = length * bend;
  if (std::isnan(frame.normal.x) || !(angle > kStraight)) return {};
  if (!(angle < 2.0 * std::numbers::pi)) {
    throw InvalidShape("the arc would be longer than its whole circle, which is " + text_of(2.0 * std::numbers::pi / bend) +
                       " long");
  }
  const double radius = 1.0 / bend;
  return ellipse_arc(end.point + radius * frame.normal, -radius * frame.normal, radius * end.tangent, 0.0, angle);
}

/// Whether what was put behind a curve is in sight.
bool is_finite_behind(const NurbsCurve& curve) {
  const auto points = curve.points().last(static_cast<std::size_t>(curve.degree()) + 1);
  return std::ranges::all_of(points, [&](const glm::dvec4& p) { return p.w * points.front().w > 0.0; });
}

NurbsCurve naturally_extended(const NurbsCurve& curve, const DirectedEnd& end, double length) {
  const Interval domain = curve.domain();
  const auto knots = curve.knot_vector().knots();
  const double last = domain.end - *(std::ranges::lower_bound(knots, domain.end) - 1);
  double step = end.speed > 0.0 ? std::min(length / end.speed, 4.0 * last) : last;
  constexpr int kDoublings = 64;
  for (int i = 0; i < kDoublings; ++i, step *= 2.0) {
    const NurbsCurve longer = with_end(curve, domain.end + step);
    if (!is_finite_behind(longer)) break;
    const NurbsCurve more = split(longer, domain.end).second;
    if (splinecore::length(more).value < length) continue;
    return with_end(curve, parameters_at_lengths(more, std::span(&length, 1)).front());
  }
  throw InvalidShape("the curve runs to infinity within that length");
}

void require_open(const NurbsCurve& curve) {
  if (is_closed(curve)) throw InvalidShape("the curve is closed: it has no end to extend");
}

/// So long an extension stays short of going round its circle.
double within_circle(const NurbsCurve& curve, double length) {
  constexpr double kWhole = 0.9999 * 2.0 * std::numbers::pi;
  const double bend = curvature_at_end(clamped(curve));
  return length * bend > kWhole ? kWhole / bend : length;
}

/// Turned round, and over what its domain is when turned back.
NurbsCurve turned(const NurbsCurve& curve, Interval domain) { return with_domain(reversed(curve), domain); }

}  // namespace

NurbsCurve extended(const NurbsCurve& curve, bool at_end, double length, Extension how) {
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape("the length is not above 0");
  require_open(curve);
  if (!at_end) {
    const Interval domain = curve.domain();
    const NurbsCurve back = extended(turned(curve, domain), true, length, how);
    return turned(back, {domain.start - (back.domain().end - domain.end), domain.end});
  }
  const NurbsCurve whole = clamped(curve);
  const DirectedEnd end = end_of(whole);
  if (how == Extension::natural) return naturally_extended(whole, end, length);
  const std::optional<NurbsCurve> arc = how == Extension::arc ? arc_on(whole, end, length) : std::nullopt;
  return follow(whole, arc ? *arc : line_between(end.point, end.point + length * end.tangent));
}

NurbsCurve extended_to(const NurbsCurve& curve, bool at_end, std::span<const NurbsCurve> others, Extension how) {
  require_open(curve);
  const Interval domain = curve.domain();
  if (!at_end) {
    const NurbsCurve back = extended_to(turned(curve, domain), true, others, how);
    return turned(back, {domain.start - (back.domain().end - domain.end), domain.end});
  }
  std::vector<glm::dvec4> all(curve.points().begin(), curve.points().end());
  for (const NurbsCurve& other : others) all = together(all, other.points());
  const double size = 2.0 * NearSpace(all).length(1.0);
  for (const double share : {0.25, 1.0, 4.0}) {
    std::optional<NurbsCurve> longer;
    const double length = how == Extension::arc ? within_circle(curve, share * size) : share * size;
    try {
      longer = extended(curve, true, length, how);
    } catch (const InvalidShape&) {
      if (share == 0.25) throw;
      break;
    }
    std::vector<double> meets = meeting_parameters(part(*longer, domain.end, longer->domain().end), others);
    constexpr double kHere = 0x1p-30;
    const double beyond = domain.end + kHere * (longer->domain().end - domain.end);
    std::erase_if(meets, [&](double u) { return u <= beyond; });
    if (!meets.empty()) return part(*longer, domain.start, meets.front());
  }
  throw InvalidShape("the continuation of the curve meets none of the others");
}

}  // namespace splinecore
