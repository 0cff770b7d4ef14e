#include "splinecore/conic/make_conic.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "base/require.hpp"
#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/ellipse.hpp"

namespace splinecore {

namespace {

/// x, y, 1 coefficients of a line, positive on one side.
glm::dvec3 line_through(const glm::dvec2& a, const glm::dvec2& b) {
  return {a.y - b.y, b.x - a.x, difference_of_products(a.x, b.y, a.y, b.x)};
}

double side_of(const glm::dvec3& line, const glm::dvec2& p) { return line.x * p.x + line.y * p.y + line.z; }

/// The pair of lines as a conic.
std::array<double, 6> product(const glm::dvec3& l, const glm::dvec3& m) {
  return {l.x * m.x, l.x * m.y + l.y * m.x, l.y * m.y, l.x * m.z + l.z * m.x, l.y * m.z + l.z * m.y, l.z * m.z};
}

double extent_of(std::span<const glm::dvec3> points) {
  glm::dvec3 low = points[0];
  glm::dvec3 high = points[0];
  for (const glm::dvec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::distance(low, high);
}

void require_apart(std::span<const glm::dvec3> points, double tolerance) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (glm::distance(points[i], points[j]) > tolerance) continue;
      throw InvalidShape("points" + index_text(i) + " and points" + index_text(j) + " coincide");
    }
  }
}

/// Largest distance of four points from the line through two of them that are farthest apart.
double distance_from_line(const std::array<glm::dvec3, 4>& points) {
  glm::dvec3 a = points[0];
  glm::dvec3 b = points[1];
  for (const glm::dvec3& p : points) {
    for (const glm::dvec3& q : points) {
      if (glm::distance(p, q) > glm::distance(a, b)) {
        a = p;
        b = q;
      }
    }
  }
  const glm::dvec3 along = glm::normalize(b - a);
  double distance = 0.0;
  for (const glm::dvec3& p : points) distance = std::max(distance, glm::length(glm::cross(along, p - a)));
  return distance;
}

void require_no_four_on_a_line(std::span<const glm::dvec3> points, double tolerance) {
  for (std::size_t left_out = 0; left_out < 5; ++left_out) {
    std::array<glm::dvec3, 4> four;
    std::string names;
    for (std::size_t i = 0, k = 0; i < 5; ++i) {
      if (i == left_out) continue;
      four[k++] = points[i];
      names += (names.empty() ? "" : ", ") + std::to_string(i);
    }
    if (distance_from_line(four) > tolerance) continue;
    throw InvalidShape("points " + names + " lie on one line: more than one conic passes through all five");
  }
}

NurbsCurve quadratic(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2, double w1) {
  return NurbsCurve::make(KnotVector::bezier(2), {{p0, 1.0}, {p1, w1}, {p2, 1.0}});
}

NurbsCurve parabola_arc(const ImplicitConic& conic, double start, double end) {
  const auto at = [&](double height, double across) {
    const auto [axis, side] = axis_directions(conic);
    return *center(conic) + height / (4.0 * conic.shape().first) * axis + across * side;
  };
  return quadratic(at(start * start, start), at(start * end, 0.5 * start + 0.5 * end), at(end * end, end), 1.0);
}

NurbsCurve hyperbola_arc(const ImplicitConic& conic, double start, double end) {
  const double weight = std::cosh(0.5 * (end - start));
  const double middle = 0.5 * (start + end);
  const auto at = [&](double u, double divisor) {
    const auto [axis, side] = axis_directions(conic);
    const ConicShape& s = conic.shape();
    return *center(conic) + s.first * std::cosh(u) / divisor * axis + s.second * std::sinh(u) / divisor * side;
  };
  return quadratic(at(start, 1.0), at(middle, weight), at(end, 1.0), weight);
}

}  // namespace

ImplicitConic conic_through(std::span<const glm::dvec3> points, std::optional<double> tolerance) {
  constexpr double kRelativeTolerance = 1e-9;
  // Of points that are rounded, in units of their extent: what is no more counts as zero.
  constexpr double kNoise = 16.0 * kEpsilon;
  if (points.size() != 5) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " rows, a conic is given by 5");
  }
  require_finite(points, "points");
  if (tolerance && (!(*tolerance >= 0.0) || !std::isfinite(*tolerance))) {
    throw InvalidShape("tolerance = " + text_of(*tolerance) + " is not a length");
  }
  const double extent = extent_of(points);
  const double near = tolerance.value_or(kRelativeTolerance * extent);
  require_apart(points, near);
  require_no_four_on_a_line(points, near);
  const Plane plane = plane_of(points, near);
  // In units of the extent, so that products of four lengths stay in the range of numbers.
  std::array<glm::dvec2, 5> p;
  std::ranges::transform(points, p.begin(), [&](const glm::dvec3& q) { return point_in(plane, q) / extent; });
  const auto l = [&](int i, int j) { return line_through(p[i], p[j]); };
  const double one = side_of(l(0, 2), p[4]) * side_of(l(1, 3), p[4]);
  const double other = side_of(l(0, 1), p[4]) * side_of(l(2, 3), p[4]);
  const auto pair = product(l(0, 1), l(2, 3));
  const auto crossed = product(l(0, 2), l(1, 3));
  const double noise = kNoise * (std::abs(one) * glm::length(l(0, 1)) * glm::length(l(2, 3)) +
                                 std::abs(other) * glm::length(l(0, 2)) * glm::length(l(1, 3)));
  const double units[6] = {1.0, 1.0, 1.0, extent, extent, extent * extent};
  std::array<double, 6> k;
  for (int i = 0; i < 6; ++i) {
    const double value = difference_of_products(one, pair[i], other, crossed[i]);
    k[i] = std::abs(value) <= noise ? 0.0 : value * units[i];
  }
  normalize(k);
  return ImplicitConic::make(k, plane);
}

ImplicitConic conic_by_foci(const glm::dvec3& focus_1, const glm::dvec3& focus_2, double distance,
                            const glm::dvec3& normal) {
  require_vector(focus_1, "focus_1");
  require_vector(focus_2, "focus_2");
  require_positive(distance, "distance");
  const glm::dvec3 middle = 0.5 * focus_1 + 0.5 * focus_2;
  const Plane across = plane_across(middle, normal);
  const double a = 0.5 * distance;
  if (focus_1 == focus_2) return ImplicitConic::make({1, 0, 1, 0, 0, -a * a}, across);
  const double c = 0.5 * glm::distance(focus_1, focus_2);
  if (a == c) throw InvalidShape("distance = " + text_of(distance) + " is that of the foci: no curve has it");
  const glm::dvec3 along = (focus_2 - focus_1) / (2.0 * c);
  const glm::dvec3 n = glm::cross(across.x_axis, across.y_axis);
  const glm::dvec3 sideways = glm::cross(n, along);
  if (glm::length(sideways) <= 4.0 * kEpsilon) throw InvalidShape("normal lies along the line of the foci");
  const double bb = (c - a) * (c + a);
  return ImplicitConic::make({-bb, 0, a * a, 0, 0, a * a * bb}, plane_along(middle, along, sideways));
}

ImplicitConic parabola(const glm::dvec3& focus, const glm::dvec3& directrix_point,
                       const glm::dvec3& directrix_direction) {
  require_vector(focus, "focus");
  require_vector(directrix_point, "directrix_point");
  require_vector(directrix_direction, "directrix_direction");
  const double length = length_of(directrix_direction);
  if (!std::isnormal(length)) throw InvalidShape("directrix_direction has the length " + text_of(length));
  const glm::dvec3 along = directrix_direction / length;
  const glm::dvec3 offset = focus - directrix_point;
  const glm::dvec3 away = offset - glm::dot(offset, along) * along;
  const double distance = glm::length(away);
  if (!(distance > 8.0 * kEpsilon * glm::length(offset))) throw InvalidShape("focus lies on the directrix");
  const glm::dvec3 vertex = focus - 0.5 * away;
  return ImplicitConic::make({1, 0, 0, 0, -2.0 * distance, 0}, plane_along(vertex, along, away));
}

NurbsCurve arc_between(const ImplicitConic& conic, double start, double end) {
  if (!std::isfinite(start)) throw InvalidShape("start = " + text_of(start) + " is not finite");
  if (!std::isfinite(end)) throw InvalidShape("end = " + text_of(end) + " is not finite");
  if (start == end) throw InvalidShape("start = end = " + text_of(start) + ": the arc would be a point");
  const auto [axis, side] = axis_directions(conic);
  const ConicShape& s = conic.shape();
  switch (s.type) {
    case ConicType::circle:
    case ConicType::ellipse: return ellipse_arc(*center(conic), s.first * axis, s.second * side, start, end - start);
    case ConicType::parabola: return parabola_arc(conic, start, end);
    case ConicType::hyperbola: return hyperbola_arc(conic, start, end);
    default: throw InvalidShape("only a circle, an ellipse, a parabola and a hyperbola have arcs");
  }
}

}  // namespace splinecore
