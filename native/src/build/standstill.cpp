#include "standstill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

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

}  // namespace

std::vector<BezierCurve> cut_where_still(const BezierCurve& curve) {
  if (curve.degree() == 1) return {curve};
  // Between two looks a polynomial speed has one least value as a rule; near the ends it may stand still as it begins.
  const int looks = 8 * curve.degree();
  constexpr double kStill = 1e-8;
  constexpr double kAtEnd = 1e-6;
  std::vector<double> cuts;
  double most = 0.0;
  std::vector<SpeedChange> seen;
  for (int i = 0; i <= looks; ++i) {
    seen.push_back(speed_at(curve, static_cast<double>(i) / looks));
    most = std::max(most, seen.back().square);
  }
  for (int i = 0; i < looks; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!(seen[k].rise <= 0.0 && seen[k + 1].rise > 0.0)) continue;
    double low = static_cast<double>(i) / looks;
    double high = static_cast<double>(i + 1) / looks;
    constexpr int kHalvings = 60;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = 0.5 * (low + high);
      (speed_at(curve, middle).rise <= 0.0 ? low : high) = middle;
    }
    const double at = 0.5 * (low + high);
    if (at > kAtEnd && at < 1.0 - kAtEnd && speed_at(curve, at).square <= kStill * kStill * most) cuts.push_back(at);
  }
  std::vector<BezierCurve> parts;
  BezierCurve rest = curve;
  double done = 0.0;
  for (const double at : cuts) {
    auto [before, behind] = split(rest, (at - done) / (1.0 - done));
    parts.push_back(std::move(before));
    rest = std::move(behind);
    done = at;
  }
  parts.push_back(std::move(rest));
  return parts;
}

}  // namespace splinecore
