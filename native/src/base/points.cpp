#include "splinecore/base/points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/length.hpp"
#include "given_points.hpp"
#include "kernels/kernels.hpp"
#include "require.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

std::vector<glm::dvec4> homogeneous(std::span<const glm::dvec4> given) {
  std::vector<glm::dvec4> points(given.size());
  std::ranges::transform(given, points.begin(), [](const auto& p) { return homogeneous(p); });
  return points;
}

namespace {

/// Smallest and largest exponent of the numbers that are not zero.
struct Exponents {
  int least = std::numeric_limits<int>::max();
  int most = std::numeric_limits<int>::min();

  void add(double value) {
    if (value == 0.0) return;
    const int exponent = std::ilogb(value);
    least = std::min(least, exponent);
    most = std::max(most, exponent);
  }
};

}  // namespace

int weight_exponent(std::span<const glm::dvec4> given) noexcept {
  constexpr int kRoom = 900;      // so that a product with any modest coordinate is a number with all its digits
  constexpr int kLargest = 1020;  // of the coordinates of a direction
  Exponents weights;
  Exponents directions;
  for (const glm::dvec4& p : given) {
    weights.add(p.w);
    for (int axis = 0; p.w == 0.0 && axis < 3; ++axis) directions.add(p[axis]);
  }
  if (weights.most < weights.least) return 0;
  const int exponent = std::max(std::min(weights.most, weights.least + kRoom), weights.most - kRoom);
  return directions.most < directions.least ? exponent : std::max(exponent, directions.most - kLargest);
}

std::vector<glm::dvec4> homogeneous(std::span<const glm::dvec4> given, int exponent) {
  std::vector<glm::dvec4> points = with_weights_divided(given, exponent);
  for (glm::dvec4& point : points) point = homogeneous(point);
  return points;
}

std::vector<glm::dvec4> finite_homogeneous(std::span<const glm::dvec4> given, std::size_t row_length) {
  std::vector<glm::dvec4> points = homogeneous(given);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(points[i][axis])) continue;
      const std::string place = index_text(i, row_length);
      throw InvalidShape("points" + place + "." + "xyz"[axis] + " = " + text_of(given[i][axis]) + " times weights" +
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

bool is_rational(std::span<const glm::dvec4> points) noexcept {
  return !points.empty() && !kernels().are_weights_one(&points.front().x, points.size());
}

double extent(std::span<const glm::dvec4> points) noexcept {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (const glm::dvec4& p : points) {
    if (p.w == 0.0) continue;
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  return low.x > high.x ? 0.0 : distance_of(low, high);
}

double largest_coordinate(std::span<const glm::dvec4> points) noexcept {
  double size = 0.0;
  for (const glm::dvec4& p : points) {
    if (p.w != 0.0) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return size;
}

void require_points(std::span<const glm::dvec4> points, std::size_t row_length) {
  const bool is_finite = points.empty() || std::isfinite(kernels().largest_size(&points.front().x, 4 * points.size()));
  for (std::size_t i = 0; !is_finite && i < points.size(); ++i) {
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

}  // namespace splinecore
