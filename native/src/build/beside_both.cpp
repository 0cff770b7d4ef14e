#include "beside_both.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "splinecore/base/pause.hpp"
#include "splinecore/conic/arcs.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// A place of a curve, the unit tangent, the point beside it, and how that and the tangent's angle go by the parameter.
struct BesidePlace {
  glm::dvec3 point;
  glm::dvec3 tangent;
  glm::dvec3 center;
  glm::dvec3 slope;
  double turning;
};

BesidePlace place(const NurbsCurve& curve, double u, double side, const glm::dvec3& normal) {
  std::array<glm::dvec3, 3> d;
  derivatives(curve, std::span(&u, 1), 2, std::span(&d[0].x, 9));
  const double speed = glm::length(d[1]);
  const glm::dvec3 tangent = d[1] / speed;
  const double curvature = glm::dot(glm::cross(tangent, d[2] / speed), normal) / speed;
  return {d[0], tangent, d[0] + side * glm::cross(normal, tangent), (1.0 - side * curvature) * d[1],
          std::abs(curvature) * speed};
}

/// Whether the tangent turns within the rounding of the parameter, as at a cusp: then it is a corner.
bool is_corner(const BesidePlace& place, double u) {
  constexpr double kFew = 0x1p-50;
  constexpr double kTurned = 0x1p-20;
  return !(kFew * std::abs(u) * place.turning <= kTurned);
}

/// How far the place beside a curve goes between two parameters that follow each other as numbers.
double rounding_of(const BesidePlace& place, double u) {
  constexpr double kFew = 0x1p-50;
  return kFew * std::abs(u) * glm::length(place.slope);
}

}  // namespace

std::optional<TouchedBoth> BesideBoth::near(double u, double v) const {
  constexpr int kMost = 40;
  constexpr double kParallel = 0x1p-44;
  const std::array<Interval, 2> domains{a_.domain(), b_.domain()};
  std::array<double, 2> before{domains[0].length(), domains[1].length()};
  for (int round = 0; round < kMost; ++round) {
    breathe(1024);
    const BesidePlace on_a = place(a_, u, sides_[0], normal_);
    const BesidePlace on_b = place(b_, v, sides_[1], normal_);
    const glm::dvec3 gap = on_b.center - on_a.center;
    const double area = glm::dot(glm::cross(on_a.slope, on_b.slope), normal_);
    const double square = glm::dot(on_b.slope, on_b.slope);
    const bool is_parallel = std::abs(area) <= kParallel * glm::length(on_a.slope) * glm::length(on_b.slope);
    if (!std::isfinite(area) || (is_parallel && !(square > 0.0))) return at(u, v);
    const double by_u = is_parallel ? 0.0 : glm::dot(glm::cross(gap, on_b.slope), normal_) / area;
    const double by_v = is_parallel ? -glm::dot(gap, on_b.slope) / square : glm::dot(glm::cross(gap, on_a.slope), normal_) / area;
    const double next_u = std::clamp(u + by_u, domains[0].start, domains[0].end);
    const double next_v = std::clamp(v + by_v, domains[1].start, domains[1].end);
    const std::array<double, 2> steps{std::abs(next_u - u), std::abs(next_v - v)};
    u = next_u;
    v = next_v;
    constexpr double kStill = 0x1p-50;
    const bool is_still = steps[0] <= kStill * domains[0].length() && steps[1] <= kStill * domains[1].length();
    const bool is_noise = round > 4 && steps[0] >= before[0] && steps[1] >= before[1];
    if (is_still || is_noise) break;
    before = steps;
  }
  return at(u, v);
}

std::optional<TouchedBoth> BesideBoth::at(double u, double v) const {
  constexpr double kOff = 1e-9;
  const BesidePlace on_a = place(a_, u, sides_[0], normal_);
  const BesidePlace on_b = place(b_, v, sides_[1], normal_);
  if (is_corner(on_a, u) || is_corner(on_b, v)) return {};
  const double radius = std::abs(sides_[0]);
  const glm::dvec3 center = 0.5 * (on_a.center + on_b.center);
  const double room = kOff * radius + rounding_of(on_a, u) + rounding_of(on_b, v);
  if (!(glm::distance(on_a.center, on_b.center) <= room)) return {};
  if (!(glm::distance(on_a.point, on_b.point) > kOff * radius)) return TouchedBoth{u, v, {}};
  const glm::dvec3 from = on_a.point - center;
  const glm::dvec3 to = on_b.point - center;
  const double turn = glm::dot(glm::cross(from / radius, to / radius), normal_) < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 start = turn * glm::cross(normal_, from);
  const glm::dvec3 end = turn * glm::cross(normal_, to);
  return TouchedBoth{u, v,
                     Fillet{arc_about(center, on_a.point, on_b.point, turn * normal_), u, v, center,
                            glm::dot(start, on_a.tangent) > 0.0, glm::dot(end, on_b.tangent) > 0.0}};
}

}  // namespace splinecore
