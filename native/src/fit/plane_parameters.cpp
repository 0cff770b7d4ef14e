#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/approximate_patch.hpp"
#include "spread.hpp"
#include "unit_points.hpp"

namespace splinecore {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The corners of the convex hull, counterclockwise (Andrew 1979).
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
  std::ranges::sort(points, [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  const auto add = [&](const glm::dvec2& point, std::size_t from) {
    while (hull.size() > from + 1 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const glm::dvec2& point : points) add(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
  hull.pop_back();
  return hull;
}

struct Rectangle {
  glm::dvec2 axis;  ///< of length 1, along which x is measured
  glm::dvec2 low;
  glm::dvec2 size;
};

Rectangle around(std::span<const glm::dvec2> points, const glm::dvec2& axis) {
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const glm::dvec2& point : points) {
    const glm::dvec2 at(glm::dot(axis, point), cross(axis, point));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return {axis, low, high - low};
}

/// One of its sides lies on one of the hull (Freeman and Shapira 1975). Of many corners some are tried.
Rectangle least_rectangle(std::span<const glm::dvec2> hull) {
  constexpr std::size_t kMostTried = 1024;
  Rectangle best{{}, {}, glm::dvec2(std::numeric_limits<double>::infinity())};
  const std::size_t step = hull.size() / kMostTried + 1;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const glm::dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
    if (side == glm::dvec2(0.0)) continue;
    const Rectangle found = around(hull, glm::normalize(side));
    // Of sides that make the same rectangle the first is taken.
    constexpr double kSmaller = 1.0 - 1e-9;
    if (found.size.x * found.size.y < kSmaller * best.size.x * best.size.y) best = found;
  }
  return best;
}

/// The same with its longer side along x, and x towards the first axis that tells.
Rectangle turned(Rectangle rectangle) {
  if (rectangle.size.y > rectangle.size.x) {
    rectangle.axis = {-rectangle.axis.y, rectangle.axis.x};
    rectangle.low = {rectangle.low.y, -rectangle.low.x - rectangle.size.x};
    std::swap(rectangle.size.x, rectangle.size.y);
  }
  constexpr double kTells = 1e-9;
  const double tells = std::abs(rectangle.axis.x) > kTells ? rectangle.axis.x : rectangle.axis.y;
  if (tells < 0.0) {
    rectangle.axis = -rectangle.axis;
    rectangle.low = -rectangle.low - rectangle.size;
  }
  return rectangle;
}

}  // namespace

std::vector<glm::dvec2> plane_parameters(std::span<const glm::dvec3> points) {
  constexpr double kThin = 1e-7;
  require_finite(points, "points");
  const UnitPoints unit = unit_points(points);
  const glm::dvec3 normal = least_spread(unit.points);
  const glm::dvec3 away = std::abs(normal.x) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(away - glm::dot(away, normal) * normal);
  const glm::dvec3 y = glm::cross(normal, x);
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& point : unit.points) flat.emplace_back(glm::dot(x, point), glm::dot(y, point));
  const auto hull = hull_of(flat);
  const Rectangle rectangle = hull.size() < 3 ? Rectangle{} : turned(least_rectangle(hull));
  if (!(rectangle.size.y > kThin * rectangle.size.x)) {
    throw InvalidShape("points lie on a line: they are near no patch");
  }
  const glm::dvec2 most(1.0, rectangle.size.y / rectangle.size.x);
  for (glm::dvec2& place : flat) {
    const glm::dvec2 at(glm::dot(rectangle.axis, place), cross(rectangle.axis, place));
    place = glm::clamp((at - rectangle.low) / rectangle.size.x, glm::dvec2(0.0), most);
  }
  return flat;
}

}  // namespace splinecore
