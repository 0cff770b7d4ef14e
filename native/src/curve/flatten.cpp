#include "splinecore/curve/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/length.hpp"
#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "basis/bernstein_net.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/interval.hpp"

namespace splinecore {

namespace {

using Piece = BernsteinNet<glm::dvec4>;

constexpr std::size_t kMaxPoints = 1 << 18;
constexpr int kMaxHalvings = 60;

bool is_flat(const Piece& piece, double tolerance) {
  const auto& points = piece.values;
  if (!has_one_sign(points, &glm::dvec4::w)) return false;
  const glm::dvec3 from = project(points.front());
  const glm::dvec3 to = project(points.back());
  return std::ranges::all_of(points, [&](const glm::dvec4& p) {
    return distance_to_segment(project(p), from, to) <= tolerance;
  });
}

[[noreturn]] void refuse(double tolerance) {
  throw InvalidShape("tolerance = " + text_of(tolerance) + " is too small: " + std::to_string(kMaxPoints) +
                     " points do not reach it");
}

/// Appends the ends of the flat parts of a part of the curve.
void append_flat(Piece piece, Interval part, int halvings, double tolerance, Flattened& line) {
  if (is_flat(piece, tolerance)) {
    line.parameters.push_back(part.end);
    line.points.push_back(project(piece.values.back()));
    if (line.points.size() > kMaxPoints) refuse(tolerance);
    return;
  }
  if (halvings == 0) refuse(tolerance);
  Piece right;
  piece.halve(Axis::u, right);
  append_flat(std::move(piece), {part.start, part.middle()}, halvings - 1, tolerance, line);
  append_flat(std::move(right), {part.middle(), part.end}, halvings - 1, tolerance, line);
}

/// @throws PointAtInfinity at the first parameter where the curve leaves the finite.
void require_finite_curve(const NurbsCurve& curve) {
  const std::vector<Interval> finite = pieces(curve);
  if (is_at_infinity(curve, 0.0, Side::right)) throw PointAtInfinity(0.0);
  if (finite.empty() || finite.front().end < 1.0) throw PointAtInfinity(finite.empty() ? 0.0 : finite.front().end);
  if (is_at_infinity(curve, 1.0, Side::left)) throw PointAtInfinity(1.0);
}

}  // namespace

Flattened flattened(const BezierCurve& curve, double tolerance) {
  if (!(tolerance > 0.0) || !std::isfinite(tolerance)) {
    throw InvalidShape("tolerance = " + text_of(tolerance) + " is not a positive, finite number");
  }
  require_finite_curve(curve.nurbs());
  const auto points = curve.nurbs().homogeneous_points();
  Flattened line{{0.0}, {project(points.front())}};
  append_flat(Piece::of_curve({points.begin(), points.end()}), {}, kMaxHalvings, tolerance, line);
  line.points.front() = glm::dvec3(curve.points().front());
  line.points.back() = glm::dvec3(curve.points().back());
  return line;
}

}  // namespace splinecore
