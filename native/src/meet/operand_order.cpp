#include "operand_order.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numeric>
#include <span>
#include <vector>

#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

/// The mean square of distances from their mean of points all over a patch.
double spread_of(const NurbsPatch& patch) {
  constexpr int kLooks = 9;
  const auto looks = [](const Interval& domain) {
    std::vector<double> at;
    for (int i = 0; i < kLooks; ++i) at.push_back(std::lerp(domain.start, domain.end, i / (kLooks - 1.0)));
    return at;
  };
  const std::vector<double> u = looks(patch.knot_vector(Axis::u).domain());
  const std::vector<double> v = looks(patch.knot_vector(Axis::v).domain());
  std::vector<double> numbers(std::size_t{3} * kLooks * kLooks);
  evaluate_grid(patch, u, v, std::span<double>(numbers), {.at_infinity = AtInfinity::nan, .threads = 1});
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3) points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  const glm::dvec3 sum = std::accumulate(points.begin(), points.end(), glm::dvec3(0.0));
  const glm::dvec3 mean = sum / static_cast<double>(points.size());
  double squares = 0.0;
  for (const glm::dvec3& point : points) squares += glm::dot(point - mean, point - mean);
  return squares;
}

std::vector<double> numbers_of(const NurbsPatch& patch) {
  std::vector<double> numbers;
  for (const glm::dvec4& point : patch.points()) numbers.insert(numbers.end(), {point.x, point.y, point.z, point.w});
  for (const Axis axis : {Axis::u, Axis::v}) {
    const std::span<const double> knots = patch.knot_vector(axis).knots();
    numbers.insert(numbers.end(), knots.begin(), knots.end());
  }
  return numbers;
}

}  // namespace

bool are_exchanged(const NurbsPatch& a, const NurbsPatch& b) {
  constexpr double kAlike = 1e-6;
  const double of_a = spread_of(a);
  const double of_b = spread_of(b);
  if (of_b > (1.0 + kAlike) * of_a) return true;
  if (of_a > (1.0 + kAlike) * of_b) return false;
  return std::ranges::lexicographical_compare(numbers_of(b), numbers_of(a));
}

}  // namespace splinecore
