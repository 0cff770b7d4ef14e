#include "standstill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "slope_parts.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// Half of how fast the square of the speed rises, and that square.
struct SpeedChange {
  double rise;
  double square;
};

SpeedChange speed_at(const BezierCurve& curve, double t) {
  std::array<glm::dvec3, 3> d;
  derivatives(curve.nurbs(), std::span(&t, 1), 2, std::span(&d[0].x, 9), {.at_infinity = AtInfinity::nan});
  return {glm::dot(d[1], d[2]), glm::dot(d[1], d[1])};
}

/// Where the square of the speed is least between two places.
double least_between(const BezierCurve& curve, double low, double high) {
  constexpr int kHalvings = 60;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = 0.5 * (low + high);
    (speed_at(curve, middle).rise <= 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// About the largest square of the speed.
double most_square(const BezierCurve& curve) {
  const int looks = 8 * curve.degree();
  double most = 0.0;
  for (int i = 0; i <= looks; ++i) most = std::max(most, speed_at(curve, static_cast<double>(i) / looks).square);
  return most;
}

/// Where it stands still, but for its ends: all such places that are not nearer to each other than the parts that are looked at.
std::vector<double> still_places(const BezierCurve& curve) {
  constexpr double kStill = 1e-8;
  constexpr double kAtEnd = 1e-6;  // there it may stand still as it begins
  constexpr int kDepth = 14;
  const double square = kStill * kStill * most_square(curve);
  const auto may_be_still = [&](const SlopePart& part) {
    const auto [low, high] = part.weight.range();
    const double weight = std::max(std::abs(low), std::abs(high));
    return part.slope_lengths().start <= std::sqrt(square) * weight * weight;
  };
  std::vector<double> found;
  for (const Interval& part : parts_that_matter(curve, {}, kDepth, may_be_still)) {
    if (!(speed_at(curve, part.start).rise <= 0.0 && speed_at(curve, part.end).rise > 0.0)) continue;
    const double at = least_between(curve, part.start, part.end);
    if (at > kAtEnd && at < 1.0 - kAtEnd && speed_at(curve, at).square <= square) found.push_back(at);
  }
  return found;
}

}  // namespace

std::vector<BezierCurve> cut_where_still(const BezierCurve& curve) {
  if (curve.degree() == 1) return {curve};
  std::vector<BezierCurve> parts;
  BezierCurve rest = curve;
  double done = 0.0;
  for (const double at : still_places(curve)) {
    auto [before, behind] = split(rest, (at - done) / (1.0 - done));
    parts.push_back(std::move(before));
    rest = std::move(behind);
    done = at;
  }
  parts.push_back(std::move(rest));
  return parts;
}

}  // namespace splinecore
