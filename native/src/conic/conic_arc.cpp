#include "splinecore/conic/conic_arc.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/plane.hpp"

namespace splinecore {

namespace {

/// Sign of w1² - w0 w2, a quarter of the weight's discriminant; 0 where the two are equal up to rounding.
int discriminant_sign(double w0, double w1, double w2) {
  const double size = std::max({std::abs(w0), std::abs(w1), std::abs(w2)});
  w0 /= size;
  w1 /= size;
  w2 /= size;
  const double value = difference_of_products(w1, w1, w0, w2);
  const double noise = 8.0 * kEpsilon * std::max(w1 * w1, std::abs(w0 * w2));
  return value > noise ? 1 : value < -noise ? -1 : 0;
}

/// How many zeros the weight has inside (0, 1).
int poles_inside(double w0, double w1, double w2) {
  const bool ends_differ = (w0 < 0.0 && w2 > 0.0) || (w0 > 0.0 && w2 < 0.0);
  if (ends_differ) return 1;
  const double end = w0 != 0.0 ? w0 : w2;
  const bool middle_differs = (end < 0.0 && w1 > 0.0) || (end > 0.0 && w1 < 0.0);
  if (!middle_differs) return 0;
  const int sign = discriminant_sign(w0, w1, w2);
  if (sign < 0) return 0;
  // A double zero, or the one beside a zero at an end.
  return sign == 0 || w0 == 0.0 || w2 == 0.0 ? 1 : 2;
}

ConicArcClass ellipse_class(double w0, double w1) {
  if (w1 == 0.0) return ConicArcClass::half_ellipse;
  return (w0 > 0.0) == (w1 > 0.0) ? ConicArcClass::shorter_ellipse_arc : ConicArcClass::longer_ellipse_arc;
}

bool is_one_point(std::span<const glm::dvec4> points) {
  const auto same = [&](const glm::dvec4& p) { return p.w != 0.0 && glm::dvec3(p) == glm::dvec3(points[0]); };
  const bool without_middle = points[1] == glm::dvec4(0.0) && same(points[0]) && same(points[2]);
  return without_middle || std::ranges::all_of(points, same);
}

}  // namespace

BezierCurve conic_arc(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2, double w1) {
  require_vector(p0, "p0");
  require_vector(p1, "p1");
  require_vector(p2, "p2");
  if (!std::isfinite(w1)) throw InvalidShape("w1 = " + text_of(w1) + " is not finite");
  const glm::dvec4 middle = w1 == 0.0 ? glm::dvec4(0.0) : glm::dvec4(p1, w1);
  return BezierCurve::make({glm::dvec4(p0, 1.0), middle, glm::dvec4(p2, 1.0)});
}

ConicArcClass conic_class(const BezierCurve& curve) {
  if (curve.degree() != 2) {
    throw InvalidShape("degree = " + std::to_string(curve.degree()) + ": a conic is a curve of degree 2");
  }
  const auto points = curve.points();
  const double w0 = points[0].w;
  const double w1 = points[1].w;
  const double w2 = points[2].w;
  const int inside = poles_inside(w0, w1, w2);
  if (!plane_of_control_points(points)) {
    if (is_one_point(points)) return ConicArcClass::point;
    return inside == 0 && w0 != 0.0 && w2 != 0.0 ? ConicArcClass::segment : ConicArcClass::line_through_infinity;
  }
  const int sign = discriminant_sign(w0, w1, w2);
  if (sign < 0) return ellipse_class(w0, w1);
  if (sign == 0) return inside == 0 ? ConicArcClass::parabola_arc : ConicArcClass::two_parabola_arcs;
  if (inside == 0) return ConicArcClass::hyperbola_arc;
  return inside == 1 ? ConicArcClass::two_hyperbola_arcs : ConicArcClass::three_hyperbola_arcs;
}

}  // namespace splinecore
