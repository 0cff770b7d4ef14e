#include "splinecore/conic/implicit_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/conic/make_conic.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// (wx, wy, w) in the plane's coordinates.
glm::dvec3 homogeneous_in(const Plane& plane, const glm::dvec4& given) {
  if (given.w == 0.0) return {direction_in(plane, glm::dvec3(given)), 0.0};
  return {given.w * point_in(plane, glm::dvec3(given)), given.w};
}

/// Divided by a power of two, so that products of four stay in the range of numbers.
/// @throws InvalidShape if a point times its weight does not.
void scale_to_one(std::array<glm::dvec3, 3>& points) {
  double size = 0.0;
  for (const glm::dvec3& p : points) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (!std::isfinite(size)) throw InvalidShape("points reach beyond the range of numbers with their weights");
  const int exponent = -std::ilogb(size);
  for (glm::dvec3& p : points) p = {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent), std::scalbn(p.z, exponent)};
}

NurbsCurve line(const glm::dvec3& point, const glm::dvec3& direction) {
  return NurbsCurve::make(1, {0, 0, 1, 2, 2}, {{-direction, 0.0}, {point, 1.0}, {direction, 0.0}});
}

/// vertex + 2 f t side + f t² axis, t from minus to plus infinity.
NurbsCurve whole_parabola(const glm::dvec3& vertex, const glm::dvec3& axis, const glm::dvec3& side) {
  return NurbsCurve::make(2, {0, 0, 0, 1, 1, 2, 2, 2},
                          {{axis, 0.0}, {-side, 0.0}, {vertex, 1.0}, {side, 0.0}, {axis, 0.0}});
}

/// As many points inside each span as decide whether all of it lies on a conic; those that are finite.
std::vector<glm::dvec3> inner_points(const NurbsCurve& curve) {
  const int count = std::max(2 * curve.degree() + 1, 7);
  const KnotVector& knots = curve.knot_vector();
  std::vector<double> parameters;
  for (int span = 0; span < static_cast<int>(knots.spans().size()); ++span) {
    const Interval own = knots.span_interval(span);
    for (int i = 0; i < count; ++i) parameters.push_back(own.start + (i + 0.5) / count * own.length());
  }
  std::vector<glm::dvec3> points(parameters.size());
  evaluate(curve, parameters, std::span(&points[0].x, 3 * points.size()), {.at_infinity = AtInfinity::nan});
  std::erase_if(points, [](const glm::dvec3& p) { return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z); });
  if (points.size() < static_cast<std::size_t>(count)) throw InvalidShape("the curve lies at infinity");
  return points;
}

/// How far a point is from lying on a conic: off its plane, the value of the equation, and the size of its terms.
struct OffConic {
  double off_plane;
  double value;
  double terms;
};

OffConic off_conic(const ImplicitConic& conic, const glm::dvec3& point) {
  const glm::dvec2 p = point_in(conic.plane(), point);
  OffConic off{glm::distance(conic.plane().point(p), point), 0.0, 0.0};
  const auto& k = conic.coefficients();
  for (const double term : {k[0] * p.x * p.x, k[1] * p.x * p.y, k[2] * p.y * p.y, k[3] * p.x, k[4] * p.y, k[5]}) {
    off.value += term;
    off.terms += std::abs(term);
  }
  return off;
}

bool all_lie_on(const ImplicitConic& conic, std::span<const glm::dvec3> points) {
  constexpr double kSame = 1e-10;
  constexpr double kRounding = 64.0 * kEpsilon;
  double reach = 0.0;
  double most = 0.0;
  for (const glm::dvec3& p : points) {
    reach = std::max(reach, glm::distance(conic.plane().origin, p));
    most = std::max(most, off_conic(conic, p).terms);
  }
  return std::ranges::all_of(points, [&](const glm::dvec3& p) {
    const OffConic off = off_conic(conic, p);
    return off.off_plane <= kSame * reach && std::abs(off.value) <= kSame * off.terms + kRounding * most;
  });
}

}  // namespace

ImplicitConic implicit_conic(const BezierCurve& curve) {
  // What remains of products that cancel: without it the equation of a parabola would be an ellipse's.
  constexpr double kNoise = 16.0 * kEpsilon;
  if (curve.degree() != 2) {
    throw InvalidShape("degree = " + std::to_string(curve.degree()) + ": a conic is a curve of degree 2");
  }
  const auto plane = plane_of_control_points(curve.points());
  if (!plane) throw InvalidShape("the points lie on one line: the equation of the curve is not unique");
  std::array<glm::dvec3, 3> g;
  std::ranges::transform(curve.points(), g.begin(), [&](const auto& p) { return homogeneous_in(*plane, p); });
  scale_to_one(g);
  const glm::dvec3 l0 = accurate_cross(g[1], g[2]);
  const glm::dvec3 l1 = accurate_cross(g[2], g[0]);
  const glm::dvec3 l2 = accurate_cross(g[0], g[1]);
  // Half the coefficient of coordinates i and j in L_1² - 4 L_0 L_2.
  const auto half = [&](int i, int j) {
    const double value = difference_of_products(l1[i], l1[j], 2.0 * l0[i], l2[j]) - 2.0 * l0[j] * l2[i];
    const double size = std::abs(l1[i] * l1[j]) + 2.0 * std::abs(l0[i] * l2[j]) + 2.0 * std::abs(l0[j] * l2[i]);
    return std::abs(value) <= kNoise * size ? 0.0 : value;
  };
  std::array<double, 6> k{half(0, 0), 2 * half(0, 1), half(1, 1), 2 * half(0, 2), 2 * half(1, 2), half(2, 2)};
  normalize(k);
  return ImplicitConic::make(k, *plane);
}

ImplicitConic implicit_conic(const NurbsCurve& curve) {
  if (curve.degree() == 2 && curve.knot_vector().spans().size() == 1) return implicit_conic(to_bezier(curve).front());
  const std::vector<glm::dvec3> points = inner_points(curve);
  std::array<glm::dvec3, 5> chosen;
  for (std::size_t i = 0; i < 5; ++i) chosen[i] = points[(i * (points.size() - 1) + 2) / 4];
  const ImplicitConic conic = conic_through(chosen);
  if (!all_lie_on(conic, points)) throw InvalidShape("the curve lies on no conic");
  return conic;
}

std::vector<NurbsCurve> curves_of(const ImplicitConic& conic) {
  const ConicShape& s = conic.shape();
  const glm::dvec3 middle = conic.plane().point(s.center);
  const auto [axis, side] = axis_directions(conic);
  const glm::dvec3 first = s.first * axis;
  const glm::dvec3 second = s.second * side;
  switch (s.type) {
    case ConicType::circle:
    case ConicType::ellipse: return {ellipse(middle, first, second)};
    case ConicType::parabola: return {whole_parabola(middle, first, s.first * side)};
    case ConicType::hyperbola: return hyperbola(middle, first, second);
    case ConicType::crossing_lines: return {line(middle, first + second), line(middle, first - second)};
    case ConicType::parallel_lines: return {line(middle + second, axis), line(middle - second, axis)};
    case ConicType::line: return {line(middle, axis)};
    default: return {};
  }
}

}  // namespace splinecore
