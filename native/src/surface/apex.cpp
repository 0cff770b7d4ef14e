#include "apex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/length.hpp"
#include "hole_plane.hpp"
#include "numeric/linear_equations.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

bool has_neighbor(const HolePlace& place) { return place.out != glm::dvec3(0.0); }

/// c + factor (rise . way) = height: what a place says of the apex, by its height over the plane and the rise there.
struct Expectation {
  glm::dvec3 way;  ///< in the plane, from its origin to the place
  double factor;
  double height;
  double weight;
};

/// Near places count more: in a long hole the apex is what those beside it let expect.
double weight_of(const glm::dvec3& way, double length, double size) {
  const double near = size / std::max(length_of(way), 1e-3 * size);
  return length * near * near * near * near;
}

/// Towards the middle, in the neighbor's plane and straight over the way there, as seen along the axis.
glm::dvec3 onward(const HolePlace& place, const glm::dvec3& inwards, const glm::dvec3& axis) {
  const glm::dvec3 across = place.out - place.along * (glm::dot(place.out, place.along) / glm::dot(place.along, place.along));
  const glm::dvec3 found = glm::cross(glm::cross(place.out, place.along), glm::cross(axis, inwards));
  return glm::dot(found, across) < 0.0 ? -found : found;
}

Expectation expectation_at(const HolePlace& place, double length, const HolePlane& plane, const glm::dvec3& axis) {
  constexpr double kSteepest = 12.0;  // of tan(angle / 2)
  const glm::dvec3 off = place.point - plane.origin;
  const double height = glm::dot(off, plane.normal);
  const glm::dvec3 way = off - height * axis;
  const double weight = weight_of(way, length, plane.size);
  const double distance = length_of(way);
  if (!has_neighbor(place) || distance == 0.0) return {way, 1.0, height, weight};
  const glm::dvec3 inwards = -way / distance;
  const glm::dvec3 leaves = onward(place, inwards, axis);
  const double rise = glm::dot(leaves, plane.normal);
  const double run = glm::dot(leaves - rise * axis, inwards);
  const double half = rise == 0.0 ? 0.0 : rise / std::max(std::hypot(rise, run) + run, std::abs(rise) / kSteepest);
  return {way, 0.5, height + distance * half, weight};
}

/// The way to the point in which all neighbors' planes meet, as nearly as may be, also where that is far away or below; as long
/// as it rises by 1 over the plane. The plane's normal as far as these say nothing.
glm::dvec3 axis_of(const std::vector<HolePlace>& places, const std::vector<double>& lengths, const HolePlane& plane) {
  constexpr double kSlight = 1e-3;  // of the sum of the lengths
  constexpr double kSteepest = 1.5;
  LinearEquations equations(3);
  double length = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    length += lengths[k];
    const glm::dvec3 normal = glm::cross(places[k].out, places[k].along);
    const double area = length_of(normal);
    if (!(area > 0.0)) continue;
    const glm::dvec3 seen = glm::dvec3(glm::dot(normal, plane.x), glm::dot(normal, plane.y), glm::dot(normal, plane.normal)) / area;
    const double off = glm::dot(normal, places[k].point - plane.origin) / (area * plane.size);
    equations.add(std::array{seen.x, seen.y, -off}, -seen.z, std::sqrt(lengths[k]));
  }
  equations.add(std::array{1.0, 0.0, 0.0}, 0.0, std::sqrt(kSlight * length));
  equations.add(std::array{0.0, 1.0, 0.0}, 0.0, std::sqrt(kSlight * length));
  equations.add(std::array{0.0, 0.0, 1.0}, 0.0, kSlight * std::sqrt(length));
  const std::vector<double> found = equations.least_squares();
  const glm::dvec3 slope = found[0] * plane.x + found[1] * plane.y;
  const double steepness = length_of(slope);
  return plane.normal + (steepness > kSteepest ? slope * (kSteepest / steepness) : slope);
}

/// The height of the apex over the plane and the slope of its tangent plane, by least squares.
glm::dvec3 solved(const std::vector<Expectation>& all, const HolePlane& plane) {
  LinearEquations equations(3);
  for (const Expectation& one : all) {
    const std::array factors{plane.size, one.factor * glm::dot(one.way, plane.x), one.factor * glm::dot(one.way, plane.y)};
    equations.add(factors, one.height, std::sqrt(one.weight));
  }
  const std::vector<double> found = equations.least_squares();
  return {found[0] * plane.size, found[1], found[2]};
}

bool is_seen_whole(const std::vector<Expectation>& all, const HolePlane& plane) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::dvec3& next = all[(i + 1) % all.size()].way;
    if (!(glm::dot(glm::cross(all[i].way, next), plane.normal) > -kRounding * plane.size * plane.size)) return false;
  }
  return true;
}

/// The derivative at an end of a circle's arc as a cubic, by the part of its chord along that, from how far the arc turns.
double stretch_of(const glm::dvec3& start, const glm::dvec3& end) {
  constexpr double kStraight = 1e-6;
  constexpr double kMostTurn = 2.8;
  const double turn = std::min(kMostTurn, std::atan2(length_of(glm::cross(start, end)), glm::dot(start, end)));
  return turn < kStraight ? 1.0 : 4.0 * std::tan(0.25 * turn) / std::sin(turn);
}

double arriving_stretch(const HolePlace& place, const Apex& apex) {
  if (!has_neighbor(place)) return 1.0;
  const glm::dvec3 end = apex.arriving(place.point);
  return stretch_of(leaving(place, apex), end) * glm::dot(apex.point - place.point, end) / glm::dot(end, end);
}

}  // namespace

glm::dvec3 leaving(const HolePlace& place, const Apex& apex) {
  const double least = apex.leaving == LeavingWay::straight_on ? 0.2 : 0.0;
  const glm::dvec3 chord = apex.point - place.point;
  const glm::dvec3 inwards = apex.seen(chord);
  if (!has_neighbor(place) || inwards == glm::dvec3(0.0)) return chord;
  const glm::dvec3 normal = glm::normalize(glm::cross(place.out, place.along));
  const glm::dvec3 way = apex.leaving == LeavingWay::straight_on ? onward(place, inwards / length_of(inwards), apex.axis)
                                                              : chord - normal * glm::dot(normal, chord);
  const double speed = length_of(way);
  if (!(speed > 0.0)) return chord;
  const double length = length_of(chord);
  const double cosine = std::max(least, glm::dot(way, chord) / (speed * length));
  const double of_circle = 2.0 / (1.0 + cosine);  // if the chord is that of a circle that leaves so
  return way * (length / speed * std::min(of_circle, cosine * stretch_of(way, apex.arriving(place.point))));
}

Apex apex_of(const Hole& hole, LeavingWay leaving) {
  constexpr int kPlaces = 65;
  std::vector<std::vector<HolePlace>> sides;
  for (const HoleSide& side : hole.sides) sides.push_back(places_along(side, kPlaces));
  const std::optional<HolePlane> plane = plane_of(sides);
  if (!plane) throw InvalidShape("the hole is round, but lies over no plane");
  const std::optional<Apex> apex = apex_over(*plane, sides, leaving);
  if (apex) return *apex;
  throw InvalidShape("the hole is round, but not seen whole from its middle: surfaces that run together there would fold");
}

namespace {

/// Places of all sides, and how long a piece of a side each stands for.
struct AllPlaces {
  std::vector<HolePlace> places;
  std::vector<double> lengths;
};

AllPlaces all_places(const std::vector<std::vector<HolePlace>>& sides) {
  AllPlaces all;
  for (const auto& side : sides) {
    const std::vector<double> of_side = lengths_at(side);
    all.places.insert(all.places.end(), side.begin(), side.end());
    all.lengths.insert(all.lengths.end(), of_side.begin(), of_side.end());
  }
  return all;
}

/// None where the places are not seen whole along the axis.
std::optional<Apex> apex_along(const HolePlane& plane, const glm::dvec3& axis, const AllPlaces& all, LeavingWay leaving) {
  std::vector<Expectation> expected;
  for (std::size_t k = 0; k < all.places.size(); ++k) expected.push_back(expectation_at(all.places[k], all.lengths[k], plane, axis));
  if (!is_seen_whole(expected, plane)) return {};
  const glm::dvec3 found = solved(expected, plane);
  Apex apex{plane.origin + found[0] * axis, plane.normal, axis, found[1] * plane.x + found[2] * plane.y, 1.0, leaving};
  double sum = 0.0;
  double length = 0.0;
  for (std::size_t k = 0; k < all.places.size(); ++k) {
    sum += all.lengths[k] * arriving_stretch(all.places[k], apex);
    length += all.lengths[k];
  }
  apex.speed = sum / length;
  return apex;
}

/// Whether lines to the apex leave all neighbors onward, not back over them or nearly along the side.
bool leave_onward(const std::vector<HolePlace>& places, const Apex& apex) {
  constexpr double kLeast = 0.1;
  return std::ranges::all_of(places, [&](const HolePlace& place) {
    const glm::dvec3 normal = glm::cross(place.out, place.along);
    const glm::dvec3 leaves = leaving(place, apex);
    const double across = glm::dot(glm::cross(leaves, place.along), normal);
    return !has_neighbor(place) || across >= kLeast * length_of(leaves) * length_of(place.along) * length_of(normal);
  });
}

}  // namespace

/// As far along the axis that the neighbors have in common as lets all lines leave onward.
std::optional<Apex> apex_over(const HolePlane& plane, const std::vector<std::vector<HolePlace>>& sides, LeavingWay leaving) {
  constexpr int kParts = 4;
  const AllPlaces all = all_places(sides);
  const glm::dvec3 slope = axis_of(all.places, all.lengths, plane) - plane.normal;
  for (int part = kParts; part > 0; --part) {
    const double share = static_cast<double>(part) / kParts;
    const std::optional<Apex> apex = apex_along(plane, plane.normal + share * slope, all, leaving);
    if (apex && leave_onward(all.places, *apex)) return apex;
  }
  return apex_along(plane, plane.normal, all, leaving);
}

}  // namespace splinecore
