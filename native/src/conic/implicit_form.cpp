#include "splinecore/conic/implicit_form.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/ellipse.hpp"

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
