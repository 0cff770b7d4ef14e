#include "splinecore/base/points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr const char* kAxes = "xyz";

void require_coordinates(const double* xyz, const std::string& argument, std::size_t index,
                         std::size_t row_length) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(xyz[axis])) continue;
    throw InvalidShape(argument + index_text(index, row_length) + "." + kAxes[axis] + " = " +
                       text_of(xyz[axis]) + " is not finite");
  }
}

}  // namespace

std::vector<glm::dvec4> homogeneous(std::span<const glm::dvec4> given) {
  std::vector<glm::dvec4> points(given.size());
  std::ranges::transform(given, points.begin(), [](const auto& p) { return homogeneous(p); });
  return points;
}

std::vector<glm::dvec4> finite_homogeneous(std::span<const glm::dvec4> given, std::size_t row_length) {
  std::vector<glm::dvec4> points = homogeneous(given);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(points[i][axis])) continue;
      const std::string place = index_text(i, row_length);
      throw InvalidShape("points" + place + "." + kAxes[axis] + " = " + text_of(given[i][axis]) + " times weights" +
                         place + " = " + text_of(given[i].w) + " is too large for a number");
    }
  }
  return points;
}

std::vector<glm::dvec4> as_given(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec4> given(points.size());
  std::ranges::transform(points, given.begin(), [](const auto& p) { return as_given(p); });
  return given;
}

std::vector<glm::dvec4> as_given_polynomial(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec4> given = as_given(points);
  for (glm::dvec4& point : given) point.w = 1.0;
  return given;
}

bool is_rational(std::span<const glm::dvec4> points) noexcept {
  return std::ranges::any_of(points, [](const glm::dvec4& p) { return p.w != 1.0; });
}

double extent(std::span<const glm::dvec4> points) noexcept {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (const glm::dvec4& p : points) {
    if (p.w == 0.0) continue;
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  return low.x > high.x ? 0.0 : std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

double largest_coordinate(std::span<const glm::dvec4> points) noexcept {
  double size = 0.0;
  for (const glm::dvec4& p : points) {
    if (p.w != 0.0) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return size;
}

void require_points(std::span<const glm::dvec4> points, std::size_t row_length) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    require_coordinates(&points[i].x, "points", i, row_length);
    if (!std::isfinite(points[i].w)) {
      throw InvalidShape("weights" + index_text(i, row_length) + " = " + text_of(points[i].w) +
                         " is not finite");
    }
  }
  if (std::ranges::all_of(points, [](const glm::dvec4& p) { return p.w == 0.0; })) {
    throw InvalidShape("weights are all zero: no point of the shape is finite");
  }
}

void require_finite(std::span<const double> values, const std::string& argument) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw InvalidShape(argument + index_text(i) + " = " + text_of(values[i]) + " is not finite");
  }
}

void require_finite(std::span<const glm::dvec3> vectors, const std::string& argument,
                    std::size_t row_length) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    require_coordinates(&vectors[i].x, argument, i, row_length);
  }
}

}  // namespace splinecore
