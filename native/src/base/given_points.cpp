#include "given_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

glm::dvec4 divided(const glm::dvec4& point, int exponent) {
  if (point.w != 0.0) return {glm::dvec3(point), std::scalbn(point.w, -exponent)};
  return {std::scalbn(point.x, -exponent), std::scalbn(point.y, -exponent), std::scalbn(point.z, -exponent), 0.0};
}

}  // namespace

std::vector<glm::dvec4> with_weights_divided(std::span<const glm::dvec4> given, int exponent) {
  std::vector<glm::dvec4> points(given.begin(), given.end());
  if (exponent == 0) return points;
  for (glm::dvec4& point : points) point = divided(point, exponent);
  return points;
}

std::vector<glm::dvec4> as_given_polynomial(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec4> given = as_given(points);
  for (glm::dvec4& point : given) point.w = 1.0;
  return given;
}

GivenPoints as_given_from(std::span<const glm::dvec4> old, bool is_rational, int exponent,
                          std::span<const glm::dvec4> points) {
  if (!is_rational) return {as_given_polynomial(points), old, {}};
  std::vector<glm::dvec4> made = as_given(points);
  if (exponent == 0) return {std::move(made), old, {}};
  const auto comes_back = [&](const glm::dvec4& point) { return divided(divided(point, -exponent), exponent) == point; };
  if (std::ranges::all_of(made, comes_back)) return {with_weights_divided(made, -exponent), old, {}};
  std::vector<glm::dvec4> divided = with_weights_divided(old, exponent);
  const std::span<const glm::dvec4> view = divided;
  return {std::move(made), view, std::move(divided)};
}

void require_same(std::span<const glm::dvec4> before, std::span<const glm::dvec4> after) {
  constexpr double kLost = 0x1p-30;
  const auto weight_of = [](const glm::dvec4& h) { return std::abs(h.w); };
  const auto heaviest = std::ranges::max_element(before, {}, weight_of) - before.begin();
  const double factor = after[heaviest].w / before[heaviest].w;
  constexpr double kLeast = 0x1p-1000;
  double largest = kLeast * weight_of(before[heaviest]);
  for (const glm::dvec4& h : before) largest = std::max({largest, std::abs(h.x), std::abs(h.y), std::abs(h.z)});
  const double scale = weight_of(before[heaviest]) / largest;
  const auto size_of = [&](const glm::dvec4& h) {
    return std::max({scale * std::abs(h.x), scale * std::abs(h.y), scale * std::abs(h.z), std::abs(h.w)});
  };
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (size_of(after[i] / factor - before[i]) <= kLost * size_of(before[i])) continue;
    throw InvalidShape("weights are so different that a point would be lost in the rounding of the others");
  }
}

}  // namespace splinecore
