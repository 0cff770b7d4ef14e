#include "touching_place.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace splinecore {

namespace {

/// The tangent of a curve of touch. Where patches part so little, as a tube and the bend that it goes on in do at two
/// points of their circle, that nothing tells, the curve goes on straight.
std::optional<glm::dvec3> way_of_touch(const PatchMeeting& here, const glm::dvec3& way) {
  constexpr double kWeak = 0x1p-6;
  constexpr double kStraight = 0.9;
  const std::optional<Parting> parting = parting_at(here);
  if (!parting) return {};
  if (is_curve(*parting)) return parting->way;
  if (std::abs(parting->across) > kWeak) return {};
  const glm::dvec3 flat = way - glm::dot(way, here.normal_a) * here.normal_a;
  return glm::length(flat) > kStraight ? std::optional(glm::normalize(flat)) : std::nullopt;
}

std::optional<glm::dvec3> way_of_border(const PatchMeeting& here, const OnFace& border) {
  const std::size_t other = border.parameter ^ 1U;
  const glm::dvec3& slope = other < 2 ? here.a.first[other] : here.b.first[other - 2];
  return glm::length(slope) > 0.0 ? std::optional(glm::normalize(slope)) : std::nullopt;
}

}  // namespace

std::optional<SectionPlace> touching_place(const TwoPatches& patches, const PatchSpots& at, const PatchContact& contact,
                                           const glm::dvec3& way, double tolerance) {
  const PatchMeeting here = meeting_at(patches, at);
  if (here.distance() > tolerance) return {};
  const bool is_border = contact.kind == PatchContact::Kind::border;
  const auto found = is_border ? way_of_border(here, contact.border) : way_of_touch(here, way);
  if (!found) return {};
  const glm::dvec3 tangent = glm::dot(*found, way) < 0.0 ? -*found : *found;
  SectionPlace place{at, here.a.point + 0.5 * here.b.offset, tangent, slopes_along(here, tangent)};
  if (is_border) place.slopes[contact.border.parameter] = 0.0;
  return place;
}

void settle_on_sides(const TwoPatches& patches, PatchSpots& at, double tolerance) {
  constexpr double kOfTolerance = 0x1p-16;
  constexpr double kRounding = 0x1p-44;
  const double near = std::max(kOfTolerance * tolerance, kRounding);
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = at[i] < 0.5 ? 0.0 : 1.0;
    const Slopes<2> there = i < 2 ? patches.a.at(at.a) : patches.b.at(at.b);
    if (std::abs(at[i] - side) * glm::length(there.first[i % 2]) <= near) at[i] = side;
  }
}

}  // namespace splinecore
