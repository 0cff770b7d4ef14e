#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "apex.hpp"
#include "hole.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A surface in a hole that is near what neighbors let expect, over a plane in which all places lie as far from the origin,
/// and in the same direction, as along a line of the surface from the apex: also where the surface is no graph.
///
/// It is a polynomial of degree 8, nearest to the lines that run from all sides to the apex; see apex_of().
class HoleGuide {
 public:
  /// None where the hole lies over no plane, or is not seen whole from its middle.
  static std::optional<HoleGuide> of(const Hole& hole);

  /// Where in the plane places of a side lie.
  std::vector<glm::dvec2> border(const HoleSide& side, std::span<const double> s) const;

  /// How patches round the origin that run from corners, of a share of each side, leave side i in the plane; or the second
  /// derivative there.
  std::vector<glm::dvec2> across(const Hole& hole, std::size_t i, std::span<const double> s, int order) const;

  /// How the surface then leaves it.
  std::vector<glm::dvec3> across_on_surface(const Hole& hole, std::size_t i, std::span<const double> s, int order) const;

  glm::dvec3 at(const glm::dvec2& place) const;

 private:
  HoleGuide(const Apex& apex, const glm::dvec3& x, const glm::dvec3& y) : apex_(apex), x_(x), y_(y) {}

  void fit(const Hole& hole);
  glm::dvec3 derivative(const glm::dvec2& p, const std::array<int, 2>& by) const;
  glm::dvec2 place_of(const HolePlace& place) const;
  glm::dvec2 speed_along(const HoleSide& side, bool is_end, int order) const;

  Apex apex_;
  glm::dvec3 x_;
  glm::dvec3 y_;
  double size_ = 1.0;  ///< of the places in the plane
  std::vector<glm::dvec3> factors_;  ///< of plane_terms()
};

}  // namespace splinecore
#pragma GCC visibility pop
