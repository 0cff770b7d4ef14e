#include "splinecore/conic/hermite_conic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/quotient.hpp"
#include "basis/bernstein_net.hpp"
#include "curve/bezier_piece.hpp"
#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/convert/to_bezier.hpp"

namespace splinecore {

namespace {

/// An arc in standard form: its polygon, and the weight of the middle point.
struct Arc {
  std::array<glm::dvec3, 3> points;
  double weight;

  /// How far the cubic's inner points lie along the legs.
  double leg() const { return 4.0 * weight / (3.0 * (1.0 + weight)); }
};

/// Above, the cubic's inner points would pass the middle one.
constexpr double kLargestWeight = 3.0;

/// Distance between an arc of weight w <= 3 and the cubic with inner points at the fraction
/// m = leg() of its legs, at most.
///
/// In barycentric coordinates of the polygon the conic is y² = 4 w² x z. On the cubic, with
/// s = t (1 - t), y = 3 m s and y² - 4 w² x z = 4 w² (3m - 2)² s² (1/4 - s) >= 0. So
/// y - 2 w sqrt(x z) is that over y + 2 w sqrt(x z) >= y (1 + q), q² = 1 - (w - 1)² / 4. Towards the
/// middle of the chord y falls and x, z rise, so that the difference falls at least 1 + w times as
/// fast as y. s (1/4 - s) <= 1/64, and the way from the middle of the chord to the middle point
/// gives the length.
double bound(const Arc& arc) {
  const double w = arc.weight;
  const double ratio = (w - 1.0) / (w + 1.0);
  const double root = std::sqrt(1.0 - 0.25 * (w - 1.0) * (w - 1.0));
  const glm::dvec3 chord_middle = 0.5 * (arc.points[0] + arc.points[2]);
  return w * ratio * ratio / (16.0 * (1.0 + root)) * glm::distance(arc.points[1], chord_middle);
}

/// In standard form, where all weights have one sign.
bool is_arc(std::span<const glm::dvec4> h) {
  return (h[0].w > 0.0 && h[1].w > 0.0 && h[2].w > 0.0) || (h[0].w < 0.0 && h[1].w < 0.0 && h[2].w < 0.0);
}

Arc arc_of(std::span<const glm::dvec4> h) {
  const double weight = std::abs(h[1].w) / (std::sqrt(std::abs(h[0].w)) * std::sqrt(std::abs(h[2].w)));
  return {{project(h[0]), project(h[1]), project(h[2])}, weight};
}

/// The halves of an arc, cut at its shoulder point. Both have the weight sqrt((1 + w) / 2).
std::array<Arc, 2> halves(const Arc& arc) {
  const auto& p = arc.points;
  const double w = arc.weight;
  const auto meet = [&](const glm::dvec3& end) { return (end + w * p[1]) / (1.0 + w); };
  const glm::dvec3 before = meet(p[0]);
  const glm::dvec3 after = meet(p[2]);
  const glm::dvec3 shoulder = 0.5 * (before + after);
  const double weight = std::sqrt(0.5 * (1.0 + w));
  return {Arc{{p[0], before, shoulder}, weight}, Arc{{shoulder, after, p[2]}, weight}};
}

/// What the points of an arc are rounded by.
double rounding_of(const Arc& arc) {
  double size = 0.0;
  for (const glm::dvec3& p : arc.points) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return kEpsilon * size;
}

/// Halves arcs until every part is near enough.
class Subdivision {
 public:
  explicit Subdivision(double tolerance) : tolerance_(tolerance) {}

  /// A span, first cut until its weights have one sign. That ends where the weight has no zero.
  void add(BernsteinNet<glm::dvec4> span, int depth = 0) {
    constexpr int kDeepest = 64;
    if (is_arc(span.values)) return add(arc_of(span.values));
    if (depth == kDeepest) refuse_far();
    BernsteinNet<glm::dvec4> after;
    span.halve(Axis::u, after);
    add(std::move(span), depth + 1);
    add(std::move(after), depth + 1);
  }

  const std::vector<Arc>& arcs() const noexcept { return arcs_; }
  double error() const noexcept { return error_; }

 private:
  [[noreturn]] static void refuse_far() {
    throw InvalidShape("the curve comes too near to infinity: clip it by finite_arcs() first");
  }

  void add(const Arc& arc) {
    if (!std::isfinite(arc.weight)) refuse_far();
    if (arc.weight <= kLargestWeight) {
      const double error = bound(arc);
      if (!std::isfinite(error)) refuse_far();
      if (error <= tolerance_) {
        arcs_.push_back(arc);
        error_ = std::max(error_, error);
        return;
      }
      if (error <= rounding_of(arc)) throw ToleranceNotReached("cubics cannot approximate the conic", tolerance_, error);
    }
    for (const Arc& half : halves(arc)) add(half);
  }

  double tolerance_;
  double error_ = 0.0;
  std::vector<Arc> arcs_;
};

/// Derivatives at both ends of the cubic over an interval of length 1.
std::array<glm::dvec3, 2> ends_of(const Arc& arc) {
  const double factor = 3.0 * arc.leg();
  return {factor * (arc.points[1] - arc.points[0]), factor * (arc.points[2] - arc.points[1])};
}

/// How much longer the next interval must be so that the speed goes on.
double stretch(const Arc& arc, const Arc& next) {
  const double ratio = glm::length(ends_of(next)[0]) / glm::length(ends_of(arc)[1]);
  return ratio > 0.0 && std::isfinite(ratio) ? ratio : 1.0;
}

HermiteCurve chain_of(const std::vector<Arc>& arcs) {
  std::vector<glm::dvec3> points{arcs.front().points[0]};
  std::vector<Tangents> tangents{{ends_of(arcs.front())[0], ends_of(arcs.front())[0]}};
  std::vector<double> parameters{0.0};
  double length = 1.0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto [start, end] = ends_of(arcs[i]);
    tangents.back().outgoing = start / length;
    points.push_back(arcs[i].points[2]);
    tangents.push_back({end / length, end / length});
    parameters.push_back(parameters.back() + length);
    if (i + 1 < arcs.size()) length *= stretch(arcs[i], arcs[i + 1]);
  }
  return HermiteCurve::make(std::move(points), std::move(tangents), std::move(parameters));
}

void require_finite_piece(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  const bool is_finite = pieces(curve).size() == 1 && !is_at_infinity(curve, domain.start, Side::right) &&
                         !is_at_infinity(curve, domain.end, Side::left);
  if (is_finite) return;
  throw InvalidShape("the curve passes through infinity or has a gap: clip it by finite_arcs() first");
}

}  // namespace

Approximation<HermiteCurve> conic_as_hermite(const NurbsCurve& curve, double tolerance) {
  if (curve.degree() != 2) {
    throw InvalidShape("degree = " + std::to_string(curve.degree()) + ": a conic is a curve of degree 2");
  }
  if (!(tolerance > 0.0)) throw InvalidShape("tolerance = " + text_of(tolerance) + " is not a positive length");
  require_finite_piece(curve);
  Subdivision subdivision(tolerance);
  for (const BezierCurve& span : to_bezier(curve)) subdivision.add(bezier_piece(span.nurbs(), 0));
  return {chain_of(subdivision.arcs()), subdivision.error()};
}

}  // namespace splinecore
