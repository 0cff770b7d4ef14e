#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A stretch of the border of a region in the plane: homogeneous Bezier pieces (wx, wy, w), from one corner to the next.
struct RegionSide {
  std::vector<std::vector<glm::dvec3>> pieces;
  std::size_t from;  ///< corners
  std::size_t to;

  bool is_straight() const { return pieces.size() == 1 && pieces[0].size() == 2; }
};

/// A side of a part of a region, and whether it is run the other way.
struct PartSide {
  std::size_t side;
  bool is_reversed;
};

/// A part of a region that is seen whole from a point.
struct SeenPart {
  std::vector<PartSide> sides;
  glm::dvec2 from;
};

/// The sides of a region, the border of which runs to the left, cut in parts. Chords between corners are more sides.
struct CutRegion {
  std::vector<RegionSide> sides;  ///< of the region, and then chords
  std::vector<SeenPart> parts;
};

/// Whether closed polygons have a point in common.
bool do_cross(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b);

/// A region within loops of sides, so many in each, the outer border first, and borders of holes, which run the other way; cut by
/// chords between corners into few parts each of which is seen whole from a point; none if these corners do not do, as where a
/// border crosses itself.
std::optional<CutRegion> cut_into_seen(std::vector<RegionSide> sides, std::span<const std::size_t> counts);

}  // namespace splinecore
#pragma GCC visibility pop
