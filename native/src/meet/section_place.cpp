#include "section_place.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace splinecore {

namespace {

/// Hermite's cubics.
struct HermiteBlends {
  double start, end, start_slope, end_slope;
};

HermiteBlends blends(double s) {
  const double r = 1.0 - s;
  return {r * r * (1.0 + 2.0 * s), s * s * (1.0 + 2.0 * r), s * r * r, -s * s * r};
}

}  // namespace

SectionStep::SectionStep(const SectionPlace& begin, const SectionPlace& end) noexcept
    : from(begin), to(end), length(glm::distance(begin.point, end.point)) {}

glm::dvec3 SectionStep::point(double s) const noexcept {
  const HermiteBlends b = blends(s);
  return b.start * from.point + b.end * to.point + length * (b.start_slope * from.tangent + b.end_slope * to.tangent);
}

PatchSpots SectionStep::spots(double s) const noexcept {
  const HermiteBlends b = blends(s);
  PatchSpots at = from.at;
  for (std::size_t i = 0; i < 4; ++i) {
    const double slopes = b.start_slope * from.slopes[i] + b.end_slope * to.slopes[i];
    at[i] = b.start * from.at[i] + b.end * to.at[i] + length * slopes;
  }
  return at;
}

std::optional<SectionPlace> section_place(const TwoPatches& patches, const PatchSpots& at) {
  constexpr double kParallel = 0x1p-30;
  const PatchMeeting here = meeting_at(patches, at);
  const double sine = glm::length(here.along);
  if (!(sine > kParallel)) return {};
  const glm::dvec3 tangent = here.along / sine;
  return SectionPlace{at, here.a.point + 0.5 * here.b.offset, tangent, slopes_along(here, tangent)};
}

std::optional<Parting> parting_at(const PatchMeeting& here) {
  if (!(glm::length(here.normal_a) > 0.0) || !(glm::length(here.normal_b) > 0.0)) return {};
  const glm::dvec3& n = here.normal_a;
  const glm::dvec3 x = glm::normalize(here.a.first[0]);
  const std::array<glm::dvec3, 2> axes{x, glm::cross(n, x)};
  std::array<std::array<double, 4>, 2> slopes;
  for (std::size_t i = 0; i < 2; ++i) slopes[i] = slopes_along(here, axes[i]);
  // How each surface bends away from the plane along two tangents.
  const auto bend = [&](const Slopes<2>& s, const double* p, const double* q) {
    return p[0] * q[0] * glm::dot(s.second[0], n) + p[1] * q[1] * glm::dot(s.second[1], n) +
           (p[0] * q[1] + p[1] * q[0]) * glm::dot(s.second[2], n);
  };
  const auto apart = [&](std::size_t i, std::size_t k) {
    return bend(here.b, &slopes[i][2], &slopes[k][2]) - bend(here.a, &slopes[i][0], &slopes[k][0]);
  };
  const double xx = apart(0, 0);
  const double xy = apart(0, 1);
  const double yy = apart(1, 1);
  const double middle = 0.5 * (xx + yy);
  const double half = std::hypot(0.5 * (xx - yy), xy);
  const double across = middle < 0.0 ? middle - half : middle + half;
  const double along = middle < 0.0 ? middle + half : middle - half;
  // The way is at right angles to the eigenvector of the larger one.
  const glm::dvec2 first(xy, across - xx);
  const glm::dvec2 second(across - yy, xy);
  const glm::dvec2 bent = glm::dot(first, first) > glm::dot(second, second) ? first : second;
  const double length = glm::length(bent);
  const glm::dvec2 to = length > 0.0 ? bent / length : glm::dvec2(1.0, 0.0);
  return Parting{-to.y * axes[0] + to.x * axes[1], along, across};
}

bool is_curve(const Parting& parting) {
  constexpr double kBent = 0x1p-20;
  constexpr double kAlong = 0x1p-5;
  return std::abs(parting.across) > kBent && std::abs(parting.along) <= kAlong * std::abs(parting.across);
}

bool SectionStep::is_near(const glm::dvec3& place, double distance) const noexcept {
  constexpr int kRounds = 4;
  if (std::min(glm::distance(from.point, place), glm::distance(to.point, place)) > length + distance) return false;
  const glm::dvec3 chord = to.point - from.point;
  const double square = glm::dot(chord, chord);
  if (!(square > 0.0)) return true;
  double s = 0.5;
  for (int i = 0; i < kRounds; ++i) s = std::clamp(s + glm::dot(place - point(s), chord) / square, 0.0, 1.0);
  return glm::distance(point(s), place) <= distance;
}

bool SectionStep::passes(const SectionPlace& place, double distance, double cosine) const noexcept {
  const double along = glm::dot(place.point - from.point, from.tangent);
  if (along < -distance || along > glm::dot(to.point - from.point, from.tangent) + distance) return false;
  return glm::dot(place.tangent, from.tangent) >= cosine;
}

}  // namespace splinecore
