#include "splinecore/base/motions.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "length.hpp"
#include "require.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// A linear map that leaves a point where it is.
glm::dmat4 about_point(const glm::dmat3& linear, const glm::dvec3& point) {
  glm::dmat4 map(linear);
  map[3] = glm::dvec4(point - linear * point, 1.0);
  return map;
}

void require_vector(const glm::dvec3& vector, const char* name) { require_finite(std::span(&vector.x, 3), name); }

}  // namespace

glm::dmat4 translation(const glm::dvec3& by) {
  require_vector(by, "by");
  glm::dmat4 map(1.0);
  map[3] = glm::dvec4(by, 1.0);
  return map;
}

glm::dmat4 rotation(double angle, const glm::dvec3& axis, const glm::dvec3& about) {
  require_finite(std::span(&angle, 1), "angle");
  require_vector(axis, "axis");
  require_vector(about, "about");
  const double length = length_of(axis);
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape("axis is zero or too long");
  const glm::dvec3 way = axis / length;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  glm::dmat3 linear(cosine);
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 unit(0.0);
    unit[k] = 1.0;
    linear[k] += (1.0 - cosine) * way[k] * way + sine * glm::cross(way, unit);
  }
  return about_point(linear, about);
}

glm::dmat4 scaling(const glm::dvec3& factors, const glm::dvec3& about) {
  require_vector(factors, "factors");
  require_vector(about, "about");
  if (factors.x == 0.0 || factors.y == 0.0 || factors.z == 0.0) throw InvalidShape("a factor is zero");
  glm::dmat3 linear(0.0);
  for (int k = 0; k < 3; ++k) linear[k][k] = factors[k];
  return about_point(linear, about);
}

}  // namespace splinecore
