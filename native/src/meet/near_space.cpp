#include "near_space.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/require.hpp"
#include "base/rounding.hpp"

namespace splinecore {

namespace {

glm::dvec3 scaled(const glm::dvec3& p, int exponent) noexcept {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

TwoFactors power_of_two(int exponent) noexcept {
  return {std::ldexp(1.0, exponent / 2), std::ldexp(1.0, exponent - exponent / 2)};
}

/// The tolerance for places by the size of shapes.
constexpr double kOfSize = 0x1p-33;

double largest_of(const glm::dvec3& p) noexcept { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

/// Of a number that is not zero the exponent that brings it below 1.
int exponent_of(double x) noexcept { return x > 0.0 ? std::ilogb(x) + 1 : 0; }

}  // namespace

NearSpace::NearSpace(std::span<const glm::dvec4> points) {
  double largest = 0.0;
  for (const glm::dvec4& p : points) {
    if (p.w != 0.0) largest = std::max(largest, largest_of(glm::dvec3(p)));
  }
  outer_ = exponent_of(largest);
  into_outer_ = power_of_two(-outer_);
  out_of_outer_ = power_of_two(outer_);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (const glm::dvec4& p : points) {
    if (p.w == 0.0) continue;
    const glm::dvec3 near = into_outer_.times(glm::dvec3(p));
    low = glm::min(low, near);
    high = glm::max(high, near);
  }
  origin_ = 0.5 * low + 0.5 * high;
  // What is smaller is rounding of the coordinates.
  constexpr int kSmallest = -60;
  inner_ = std::max(exponent_of(largest_of(0.5 * high - 0.5 * low)), kSmallest);
  rounding_ = std::ldexp(0x1p-53 * largest_of(glm::max(glm::abs(low), glm::abs(high))), -inner_);
  into_inner_ = power_of_two(-inner_);
  out_of_inner_ = power_of_two(inner_);
  size_ = size_of(points);
}

NearSpace NearSpace::of_size_one() const noexcept {
  if (!(size_ > 0.0)) return *this;
  NearSpace found = *this;
  found.into_inner_.second /= size_;
  found.out_of_inner_.second *= size_;
  found.rounding_ = rounding_ / size_ + 0x1p-53;
  found.size_ = 1.0;
  return found;
}

double NearSpace::size_of(std::span<const glm::dvec4> points) const {
  const auto near = [&](const glm::dvec4& p) {
    return into_inner_.times(into_outer_.times(glm::dvec3(p)) - origin_);
  };
  glm::dvec3 sum(0.0);
  double count = 0.0;
  for (const glm::dvec4& p : points) {
    if (p.w == 0.0) continue;
    sum += near(p);
    count += 1.0;
  }
  const glm::dvec3 middle = sum / std::max(count, 1.0);
  double size = 0.0;
  for (const glm::dvec4& p : points) {
    if (p.w != 0.0) size = std::max(size, glm::distance(near(p), middle));
  }
  return size;
}

NearPoint NearSpace::enter(const glm::dvec3& point, double far) const noexcept {
  constexpr double kMostFar = 0x1p200;
  const glm::dvec3 outer = into_outer_.times(point);
  const bool is_inside = largest_of(outer) < kMostFar;  // else it may be no number
  const glm::dvec3 reached =
      is_inside ? outer : scaled(point, -exponent_of(largest_of(point))) * kMostFar;
  const glm::dvec3 near = into_inner_.times(reached - origin_);
  const double size = largest_of(near);
  if (is_inside && size <= far) return {near, false};
  return {scaled(near, -exponent_of(size)) * far, true};
}

std::vector<glm::dvec4> NearSpace::homogeneous(std::span<const glm::dvec4> given,
                                               std::span<const glm::dvec4> homogeneous, std::size_t width,
                                               std::size_t unrolled_width) const {
  std::vector<glm::dvec4> points(homogeneous.size());
  const std::size_t rows = given.size() / width;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = homogeneous[i].w;
    const glm::dvec4& own = given[i / unrolled_width % rows * width + i % unrolled_width % width];
    const glm::dvec3 near = w == 0.0 ? into_inner_.times(into_outer_.times(glm::dvec3(homogeneous[i])))
                                     : w * into_inner_.times(into_outer_.times(glm::dvec3(own)) - origin_);
    points[i] = glm::dvec4(near, w);
  }
  return points;
}

std::vector<glm::dvec4> NearSpace::enter(std::span<const glm::dvec4> points) const {
  std::vector<glm::dvec4> near;
  near.reserve(points.size());
  for (const glm::dvec4& p : points) {
    near.push_back(p.w == 0.0 ? glm::dvec4(glm::dvec3(p) / length(1.0), 0.0) : glm::dvec4(enter(glm::dvec3(p)).at, p.w));
  }
  return near;
}

std::vector<glm::dvec4> NearSpace::leave(std::span<const glm::dvec4> near) const {
  std::vector<glm::dvec4> points;
  points.reserve(near.size());
  for (const glm::dvec4& p : near) points.push_back(leave(p));
  return points;
}

std::vector<glm::dvec4> together(std::span<const glm::dvec4> a, std::span<const glm::dvec4> b) {
  std::vector<glm::dvec4> points(a.begin(), a.end());
  points.insert(points.end(), b.begin(), b.end());
  return points;
}

double default_place_tolerance(std::span<const glm::dvec4> points) {
  const NearSpace space(points);
  return space.length(kOfSize * space.size());
}

double distance_of_one(double tolerance, double rounding) noexcept {
  return std::max(0x1p-6 * tolerance, std::min(4.0 * rounding, 0.25 * tolerance));
}

double place_tolerance(const NearSpace& space, std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  return std::max(tolerance ? *tolerance / space.length(1.0) : kOfSize * space.size(), kRoundingOfShape + 4.0 * space.rounding());
}

}  // namespace splinecore
