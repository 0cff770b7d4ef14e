#include "hole_guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "base/length.hpp"
#include "bulge.hpp"
#include "hole_plane.hpp"
#include "numeric/linear_equations.hpp"
#include "plane_terms.hpp"

namespace splinecore {

namespace {

constexpr int kDegreeOfGuide = 8;
constexpr std::size_t kTermsOfGuide = (kDegreeOfGuide + 1) * (kDegreeOfGuide + 2) / 2;

/// A cubic from a side to the apex, by t from 0 to 1.
struct LineToApex {
  std::array<glm::dvec3, 4> points;

  glm::dvec3 at(double t) const {
    const double s = 1.0 - t;
    return s * s * s * points[0] + 3.0 * s * s * t * points[1] + 3.0 * s * t * t * points[2] + t * t * t * points[3];
  }

  double length_to(double t) const {
    constexpr int kParts = 16;
    double sum = 0.0;
    for (int k = 0; k < kParts; ++k) sum += distance_of(at(t * k / kParts), at(t * (k + 1.0) / kParts));
    return sum;
  }
  double length() const { return length_to(1.0); }
};

LineToApex line_from(const HolePlace& place, const Apex& apex) {
  const glm::dvec3 start = leaving(place, apex);
  const glm::dvec3 end = apex.arriving(place.point);
  return {{place.point, place.point + start / 3.0, apex.point - end / 3.0, apex.point}};
}

}  // namespace

glm::dvec2 HoleGuide::place_of(const HolePlace& place) const {
  const glm::dvec3 way = -apex_.arriving(place.point);
  const glm::dvec2 seen(glm::dot(way, x_), glm::dot(way, y_));
  const double distance = glm::length(seen);
  return distance > 0.0 ? seen * (line_from(place, apex_).length() / distance) : seen;
}

std::vector<glm::dvec2> HoleGuide::border(const HoleSide& side, std::span<const double> s) const {
  std::vector<glm::dvec2> found;
  for (const HolePlace& place : side.places(s)) found.push_back(place_of(place));
  return found;
}

/// By differences: these places need not be exact.
glm::dvec2 HoleGuide::speed_along(const HoleSide& side, bool is_end, int order) const {
  constexpr double kStep = 0x1p-8;
  const double way = is_end ? -kStep : kStep;
  const double at = is_end ? 1.0 : 0.0;
  const double s[] = {at, at + way, at + 2.0 * way, at + 3.0 * way};
  const std::vector<glm::dvec2> p = border(side, s);
  if (order == 1) return (-11.0 * p[0] + 18.0 * p[1] - 9.0 * p[2] + 2.0 * p[3]) / (6.0 * way);
  return (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]) / (way * way);
}

std::vector<glm::dvec2> HoleGuide::across(const Hole& hole, std::size_t i, std::span<const double> s, int order) const {
  const double h = hole.share;
  const double factor = order == 1 ? -h : h * h;
  const glm::dvec2 start = factor * speed_along(hole.sides[hole.before(i)], true, order);
  const glm::dvec2 end = h * (order == 1 ? 1.0 : h) * speed_along(hole.sides[hole.after(i)], false, order);
  const double half[] = {0.5};
  const glm::dvec2 middle = order == 1 ? -border(hole.sides[i], half).front() : glm::dvec2(0.0);
  const int power = hole.continuity() + 1;
  std::vector<glm::dvec2> found;
  for (const double at : s) found.push_back((1.0 - at) * start + at * end + bulge(at, power) * (middle - 0.5 * (start + end)));
  return found;
}

glm::dvec3 HoleGuide::at(const glm::dvec2& place) const {
  return derivative(place / size_, {0, 0});
}

/// At p, in sizes.
glm::dvec3 HoleGuide::derivative(const glm::dvec2& p, const std::array<int, 2>& by) const {
  const std::vector<double> terms = plane_terms(kDegreeOfGuide, p, by);
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < terms.size(); ++k) sum += terms[k] * factors_[k];
  return sum;
}

std::vector<glm::dvec3> HoleGuide::across_on_surface(const Hole& hole, std::size_t i, std::span<const double> s,
                                                     int order) const {
  const std::vector<glm::dvec2> places = border(hole.sides[i], s);
  const std::vector<glm::dvec2> ways = across(hole, i, s, 1);
  const std::vector<glm::dvec2> turns = order == 2 ? across(hole, i, s, 2) : std::vector<glm::dvec2>(s.size());
  std::vector<glm::dvec3> found;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const glm::dvec2 p = places[k] / size_;
    const glm::dvec2 way = ways[k] / size_;
    const glm::dvec2 first = order == 1 ? way : turns[k] / size_;
    glm::dvec3 sum = first.x * derivative(p, {1, 0}) + first.y * derivative(p, {0, 1});
    if (order == 2) {
      sum += way.x * way.x * derivative(p, {2, 0}) + 2.0 * way.x * way.y * derivative(p, {1, 1});
      sum += way.y * way.y * derivative(p, {0, 2});
    }
    found.push_back(sum);
  }
  return found;
}

/// The polynomial nearest to the lines to the apex, and to how they leave their sides.
void HoleGuide::fit(const Hole& hole) {
  constexpr int kParts = 8;
  constexpr double kOnSides = 4.0;
  constexpr double kOfSlopes = 1.2;
  constexpr double kDependent = 1e-8;
  LinearEquations equations(kTermsOfGuide, 3);
  const auto add = [&](double weight, std::span<const double> terms, const glm::dvec3& value) {
    equations.add(terms, std::array{value.x, value.y, value.z}, weight);
  };
  std::vector<HolePlace> places;
  for (const HoleSide& side : hole.sides) {
    for (const HolePlace& place : places_along(side)) places.push_back(place);
  }
  size_ = 0.0;
  for (const HolePlace& place : places) size_ = std::max(size_, glm::length(place_of(place)));
  for (const HolePlace& place : places) {
    const LineToApex line = line_from(place, apex_);
    const glm::dvec2 from = place_of(place) / size_;
    const double length = line.length();
    for (int k = 0; k <= kParts; ++k) {
      const double t = static_cast<double>(k) / kParts;
      const double left = 1.0 - line.length_to(t) / length;
      add(k == 0 ? kOnSides : 1.0, plane_terms(kDegreeOfGuide, left * from), line.at(t));
    }
    const glm::dvec3 start = 3.0 * (line.points[1] - line.points[0]);
    const double speed = length_of(start);
    if (!(speed > 0.0)) continue;
    const double distance = glm::length(from);
    const glm::dvec2 inwards = -from / distance;
    std::vector<double> slopes = plane_terms(kDegreeOfGuide, from, {1, 0});
    const std::vector<double> by_y = plane_terms(kDegreeOfGuide, from, {0, 1});
    for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k] = inwards.x * slopes[k] + inwards.y * by_y[k];
    add(kOfSlopes, slopes, start * (size_ / speed));
  }
  const std::vector<double> found = equations.least_squares(kDependent);
  factors_.clear();
  for (std::size_t k = 0; k < found.size(); k += 3) factors_.emplace_back(found[k], found[k + 1], found[k + 2]);
}

/// Seen along the apex's own normal: there lines from all sides come as evenly as on a sphere.
std::optional<HoleGuide> HoleGuide::of(const Hole& hole) {
  constexpr int kRounds = 3;
  std::vector<std::vector<HolePlace>> sides;
  for (const HoleSide& side : hole.sides) sides.push_back(places_along(side));
  std::optional<HolePlane> plane = plane_of(sides);
  for (int round = 0; plane; ++round) {
    std::optional<Apex> apex = apex_over(*plane, sides);
    if (!apex) return {};
    const glm::dvec3 normal = glm::normalize(plane->normal - apex->rise);
    plane->x = glm::normalize(plane->x - normal * glm::dot(plane->x, normal));
    plane->y = glm::cross(normal, plane->x);
    plane->normal = normal;
    plane->origin = apex->point;
    if (round + 1 < kRounds) continue;
    const glm::dvec3 axis = apex->axis / glm::dot(apex->axis, normal);
    HoleGuide guide({apex->point, normal, axis, glm::dvec3(0.0), apex->speed, apex->leaving}, plane->x, plane->y);
    guide.fit(hole);
    return guide;
  }
  return {};
}

}  // namespace splinecore
