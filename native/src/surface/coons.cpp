#include "splinecore/surface/coons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "bicubic_sum.hpp"
#include "border_loop.hpp"
#include "greville.hpp"
#include "meet/near_space.hpp"
#include "run_back.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

NurbsCurve over_unit(const NurbsCurve& curve) { return with_domain(curve, {0.0, 1.0}); }

/// A side that is a point, run through from 0 to 1.
NurbsCurve standing(const glm::dvec3& point) {
  return NurbsCurve::make(KnotVector::bezier(1), {glm::dvec4(point, 1.0), glm::dvec4(point, 1.0)});
}

/// The side on the knots of a border that it is, up to rounding.
NurbsCurve on_knots_of(const NurbsCurve& border, const NurbsCurve& side) {
  return side.knot_vector() == border.knot_vector() ? side : compatible(border, side).second;
}

/// Lets the borders of a net be these points.
void set_borders(std::vector<glm::dvec4>& net, std::span<const glm::dvec4> low, std::span<const glm::dvec4> high,
                 std::span<const glm::dvec4> left, std::span<const glm::dvec4> right) {
  const std::size_t width = left.size();
  std::ranges::copy(left, net.begin());
  std::ranges::copy(right, net.end() - std::ssize(right));
  for (std::size_t i = 0; i < low.size(); ++i) {
    net[i * width] = low[i];
    net[i * width + width - 1] = high[i];
  }
}

/// The patch with sides that are these in every bit where that is so but for rounding.
NurbsPatch with_sides(const NurbsPatch& patch, const NurbsCurve& low, const NurbsCurve& high, const NurbsCurve& left,
                      const NurbsCurve& right) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  const NurbsCurve of_u = boundary(patch, Border::v_start);
  const NurbsCurve of_v = boundary(patch, Border::u_start);
  set_borders(points, on_knots_of(of_u, low).points(), on_knots_of(of_u, high).points(), on_knots_of(of_v, left).points(),
              on_knots_of(of_v, right).points());
  return patch.with_points(std::move(points));
}

/// Sides on the same knots, and as homogeneous points of a space.
struct OppositeSides {
  NurbsCurve start;
  NurbsCurve end;
  std::vector<glm::dvec4> from;
  std::vector<glm::dvec4> to;

  OppositeSides(const std::pair<NurbsCurve, NurbsCurve>& both, const NearSpace& space)
      : start(both.first), end(both.second), from(homogeneous(space.enter(start.points()))),
        to(homogeneous(space.enter(end.points()))) {}

  glm::dvec4 between(std::size_t i, double share) const { return (1.0 - share) * from[i] + share * to[i]; }
};

/// Both ruled surfaces less the bilinear one of the corners. A linear function has its values at Greville's places for control
/// points.
NurbsPatch bilinear_sum(const OppositeSides& along_u, const OppositeSides& along_v, const NearSpace& space) {
  const std::vector<double> u = greville_places(along_u.start.knot_vector());
  const std::vector<double> v = greville_places(along_v.start.knot_vector());
  std::vector<glm::dvec4> start;  // sides along v less what the others are between at their ends
  std::vector<glm::dvec4> end;
  for (std::size_t j = 0; j < v.size(); ++j) {
    start.push_back(along_v.from[j] - along_u.between(0, v[j]));
    end.push_back(along_v.to[j] - along_u.between(u.size() - 1, v[j]));
  }
  std::vector<glm::dvec4> net;
  net.reserve(u.size() * v.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    const glm::dvec4 from = along_u.from[i];
    const glm::dvec4 to = along_u.to[i];
    const double before = 1.0 - u[i];
    for (std::size_t j = 0; j < v.size(); ++j) {
      const glm::dvec4 near = ((1.0 - v[j]) * from + v[j] * to) + (before * start[j] + u[i] * end[j]);
      net.push_back(space.leave(as_given(near)));
    }
  }
  set_borders(net, along_u.start.points(), along_u.end.points(), along_v.start.points(), along_v.end.points());
  return NurbsPatch::make(along_u.start.knot_vector(), along_v.start.knot_vector(), std::move(net));
}

/// How far apart two curves over one domain are at the same parameters, seen in every span of either; 0 for rounding of points so
/// far out, and where a point lies at infinity.
double distance_of_curves(const NurbsCurve& a, const NurbsCurve& b, double size) {
  constexpr int kInSpan = 12;
  constexpr double kRounding = 1e-13;
  std::vector<double> ends(a.knot_vector().knots().begin(), a.knot_vector().knots().end());
  ends.insert(ends.end(), b.knot_vector().knots().begin(), b.knot_vector().knots().end());
  std::ranges::sort(ends);
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double length = ends[i + 1] - ends[i];
    for (int k = 0; k < kInSpan && length > 0.0; ++k) at.push_back(ends[i] + length * (k + 0.5) / kInSpan);
  }
  std::vector<glm::dvec3> of_a(at.size());
  std::vector<glm::dvec3> of_b(at.size());
  evaluate(a, at, {&of_a.front().x, 3 * at.size()}, {.at_infinity = AtInfinity::nan});
  evaluate(b, at, {&of_b.front().x, 3 * at.size()}, {.at_infinity = AtInfinity::nan});
  double largest = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double distance = distance_of(of_a[k], of_b[k]);
    if (distance > largest) largest = distance;
  }
  return largest > kRounding * size ? largest : 0.0;
}

/// How far places in every span of a curve are from another one, which runs through it at another pace; 0 for rounding.
double distance_from_curve(const NurbsCurve& given, const NurbsCurve& made, double size) {
  constexpr int kInSpan = 12;
  constexpr double kRounding = 1e-13;
  std::vector<double> at;
  for (std::size_t i = 0; i < given.knot_vector().spans().size(); ++i) {
    const Interval span = given.knot_vector().span_interval(static_cast<int>(i));
    for (int k = 0; k < kInSpan; ++k) at.push_back(span.start + span.length() * (k + 0.5) / kInSpan);
  }
  std::vector<glm::dvec3> points(at.size());
  evaluate(given, at, {&points.front().x, 3 * at.size()}, {.at_infinity = AtInfinity::nan});
  std::erase_if(points, [](const glm::dvec3& p) { return !std::isfinite(p.x + p.y + p.z); });
  std::vector<NearestOnCurve> found(points.size());
  nearest(made, points, found, 1);
  double largest = 0.0;
  for (const NearestOnCurve& one : found) largest = std::max(largest, one.distance);
  return largest > kRounding * size ? largest : 0.0;
}

/// A derivative as vectors of the space, over [0, 1], as the side now runs.
std::optional<NurbsCurve> entered(const std::optional<NurbsCurve>& across, std::size_t side, bool is_turned, double unit) {
  if (!across) return {};
  const std::string name = "across" + index_text(side);
  if (across->rational()) throw InvalidShape(name + " has weights: it is a curve of vectors");
  if (across->periodic()) throw InvalidShape(name + " is closed: a side is not");
  std::vector<glm::dvec4> vectors(across->points().begin(), across->points().end());
  for (glm::dvec4& p : vectors) p = glm::dvec4(glm::dvec3(p) / unit, 1.0);
  const NurbsCurve near = over_unit(clamped(across->with_points(std::move(vectors))));
  return is_turned ? run_back(near) : near;
}

/// @throws ToleranceNotReached for the side that is farthest off
void require_corners(const CornerMisfits& misfits, double tolerance, double unit) {
  const std::array off{misfits.along_u[0], misfits.along_v[1], misfits.along_u[1], misfits.along_v[0]};
  const auto worst = std::ranges::max_element(off);
  if (*worst * unit <= tolerance) return;
  throw ToleranceNotReached("the derivative across" + index_text(static_cast<std::size_t>(worst - off.begin())) +
                                " is not, at an end, the one along the side that meets it there",
                            tolerance, *worst * unit);
}

}  // namespace

Approximation<NurbsPatch> coons(std::span<const NurbsCurve> sides, std::optional<double> tolerance) {
  if (sides.size() != 3 && sides.size() != 4) {
    throw InvalidShape(std::to_string(sides.size()) + " sides: three or four are needed");
  }
  BorderLoop loop = border_loop(sides, tolerance);
  const std::vector<NurbsCurve> before = loop.curves;
  std::vector<glm::dvec4> all;
  for (NurbsCurve& side : loop.curves) {
    side = over_unit(side.rational() ? standard_form(side) : side);
    all.insert(all.end(), side.points().begin(), side.points().end());
  }
  if (loop.curves.size() == 3) loop.curves.push_back(standing(glm::dvec3(loop.curves[2].points().back())));
  const NearSpace space(all);
  const OppositeSides along_u(compatible(loop.curves[0], run_back(loop.curves[2])), space);
  const OppositeSides along_v(compatible(run_back(loop.curves[3]), loop.curves[1]), space);
  double size = 0.0;
  for (const glm::dvec4& p : all) size = std::max(size, length_of(glm::dvec3(p)));
  double error = loop.error;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].rational()) error = std::max(error, distance_from_curve(before[i], loop.curves[i], size));
  }
  const auto compare = [&](const NurbsCurve& given, const NurbsCurve& made) { error = std::max(error, distance_of_curves(given, made, size)); };
  compare(loop.curves[0], along_u.start);
  compare(loop.curves[1], along_v.end);
  compare(run_back(loop.curves[2]), along_u.end);
  compare(run_back(loop.curves[3]), along_v.start);
  return {bilinear_sum(along_u, along_v, space), error};
}

Approximation<NurbsPatch> bicubic_coons(std::span<const NurbsCurve> sides, std::span<const std::optional<NurbsCurve>> across,
                                        std::optional<double> tolerance) {
  if (sides.size() != 4) throw InvalidShape(std::to_string(sides.size()) + " sides: four are needed");
  if (across.size() != 4) throw InvalidShape("across has " + std::to_string(across.size()) + " values: one for each side is needed");
  const BorderLoop loop = border_loop(sides, tolerance);
  std::vector<glm::dvec4> all;
  for (const NurbsCurve& side : loop.curves) all.insert(all.end(), side.points().begin(), side.points().end());
  const NearSpace space(all);
  const double unit = space.length(1.0);
  const auto near = [&](std::size_t i) {
    const NurbsCurve& side = loop.curves[i];
    return LeftBorder{over_unit(side.with_points(space.enter(side.points()))), entered(across[i], i, loop.is_turned[i], unit)};
  };
  const BorderPairs borders = borders_around({near(0), near(1), near(2), near(3)});
  const BicubicSum sum = bicubic_sum(borders.along_u, borders.along_v);
  if (!keeps_weights_positive(sum)) {
    throw InvalidShape("the weights of the sides differ so much that inside the patch some would not stay positive");
  }
  require_corners(sum.misfits, loop.tolerance, unit);
  const double off = std::max(std::ranges::max(sum.misfits.along_u), std::ranges::max(sum.misfits.along_v));
  const auto left = [&](const NurbsCurve& curve) { return curve.with_points(space.leave(curve.points())); };
  const NurbsPatch patch = sum.patch.with_points(space.leave(sum.patch.points()));
  return {with_sides(patch, left(sum.along_u[0]), left(sum.along_u[1]), left(sum.along_v[0]), left(sum.along_v[1])),
          std::max(loop.error, unit * (off + sum.misfits.twist))};
}

}  // namespace splinecore
