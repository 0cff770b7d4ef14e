#include "apex.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/length.hpp"
#include "hole_plane.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

bool has_neighbour(const HolePlace& place) { return place.out != glm::dvec3(0.0); }

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

/// Towards the middle, in the neighbour's plane and straight over the way there.
glm::dvec3 onward(const HolePlace& place, const glm::dvec3& inwards, const HolePlane& plane) {
  const glm::dvec3 across = place.out - place.along * (glm::dot(place.out, place.along) / glm::dot(place.along, place.along));
  const glm::dvec3 found = glm::cross(glm::cross(place.out, place.along), glm::cross(plane.normal, inwards));
  return glm::dot(found, across) < 0.0 ? -found : found;
}

Expectation expectation_at(const HolePlace& place, double length, const HolePlane& plane) {
  constexpr double kSteepest = 12.0;  // of tan(angle / 2)
  const glm::dvec3 off = place.point - plane.origin;
  const double height = glm::dot(off, plane.normal);
  const glm::dvec3 way = off - height * plane.normal;
  const double weight = weight_of(way, length, plane.size);
  const double distance = length_of(way);
  if (!has_neighbour(place) || distance == 0.0) return {way, 1.0, height, weight};
  const glm::dvec3 inwards = -way / distance;
  const glm::dvec3 leaves = onward(place, inwards, plane);
  const double rise = glm::dot(leaves, plane.normal);
  const double run = glm::dot(leaves, inwards);
  const double half = rise == 0.0 ? 0.0 : rise / std::max(std::hypot(rise, run) + run, std::abs(rise) / kSteepest);
  return {way, 0.5, height + distance * half, weight};
}

/// The height of the apex over the plane and the slope of its tangent plane, by least squares.
Eigen::Vector3d solved(const std::vector<Expectation>& all, const HolePlane& plane) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> left(static_cast<Eigen::Index>(all.size()), 3);
  Eigen::VectorXd right(static_cast<Eigen::Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double weight = std::sqrt(all[i].weight);
    left.row(row) << plane.size, all[i].factor * glm::dot(all[i].way, plane.x), all[i].factor * glm::dot(all[i].way, plane.y);
    left.row(row) *= weight;
    right[row] = weight * all[i].height;
  }
  Eigen::Vector3d found = left.colPivHouseholderQr().solve(right);
  found[0] *= plane.size;
  return found;
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
  if (!has_neighbour(place)) return 1.0;
  const glm::dvec3 end = apex.arriving(place.point);
  return stretch_of(leaving(place, apex), end) * glm::dot(apex.point - place.point, end) / glm::dot(end, end);
}

}  // namespace

glm::dvec3 leaving(const HolePlace& place, const Apex& apex) {
  const glm::dvec3 chord = apex.point - place.point;
  if (!has_neighbour(place)) return chord;
  glm::dvec3 normal = glm::cross(place.out, place.along);
  const double area = length_of(normal);
  if (!(area > 0.0)) return chord;
  normal /= area;
  const glm::dvec3 way = chord - normal * glm::dot(normal, chord);
  const double cosine = length_of(way) / length_of(chord);
  const double of_circle = 2.0 / (cosine * (1.0 + cosine));  // if the chord is that of a circle that leaves so
  return way * std::min(of_circle, stretch_of(way, apex.arriving(place.point)));
}

Apex apex_of(const Hole& hole) {
  constexpr int kPlaces = 65;
  std::vector<std::vector<HolePlace>> sides;
  for (const HoleSide& side : hole.sides) sides.push_back(places_along(side, kPlaces));
  const std::optional<HolePlane> plane = plane_of(sides);
  if (!plane) throw InvalidShape("the hole is round, but lies over no plane");
  const std::optional<Apex> apex = apex_over(*plane, sides);
  if (apex) return *apex;
  throw InvalidShape("the hole is round, but not seen whole from its middle: surfaces that run together there would fold");
}

std::optional<Apex> apex_over(const HolePlane& plane, const std::vector<std::vector<HolePlace>>& sides) {
  std::vector<HolePlace> places;
  std::vector<double> lengths;
  for (const auto& side : sides) {
    const std::vector<double> of_side = lengths_at(side);
    places.insert(places.end(), side.begin(), side.end());
    lengths.insert(lengths.end(), of_side.begin(), of_side.end());
  }
  std::vector<Expectation> all;
  for (std::size_t k = 0; k < places.size(); ++k) all.push_back(expectation_at(places[k], lengths[k], plane));
  if (!is_seen_whole(all, plane)) return {};
  const Eigen::Vector3d found = solved(all, plane);
  Apex apex{plane.origin + found[0] * plane.normal, plane.normal, found[1] * plane.x + found[2] * plane.y};
  double sum = 0.0;
  double length = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    sum += lengths[k] * arriving_stretch(places[k], apex);
    length += lengths[k];
  }
  apex.speed = sum / length;
  return apex;
}

}  // namespace splinecore
