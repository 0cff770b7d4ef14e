#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Three directions at right angles from an origin; heights are along the last one.
struct HeightFrame {
  glm::dvec3 origin;
  std::array<glm::dvec3, 3> axes;

  glm::dvec2 flat(const glm::dvec3& v) const noexcept { return {glm::dot(axes[0], v), glm::dot(axes[1], v)}; }
};

/// A quadratic polynomial in the plane of a frame, about a place of its own.
struct QuadraticHeights {
  glm::dvec2 at{0.0};
  double height = 0.0;
  glm::dvec2 slope{0.0};
  std::array<double, 3> bend{};  ///< second derivatives xx, xy, yy

  glm::dvec2 slope_at(const glm::dvec2& place) const noexcept;
  double height_at(const glm::dvec2& place) const noexcept;
};

/// The directions of vectors in a plane: a unit vector, and the largest angle with it.
struct FlatCone {
  glm::dvec2 along{1.0, 0.0};
  double spread = 0.0;
};

/// Seen along the heights.
FlatCone flat_cone(const HeightFrame& frame, const VectorCone& cone);

/// The least sine of an angle between vectors of two cones, with the sign of their cross products; 0 if some are parallel.
double least_cross(const FlatCone& a, const FlatCone& b);

/// A part of a patch as a graph over a plane: nearly what a quadratic polynomial is.
struct PartHeights {
  glm::dvec2 low;  ///< a box about the part in the plane
  glm::dvec2 high;
  QuadraticHeights nearly;
  std::array<FlatCone, 2> tangents;
  double off = 0.0;    ///< how far heights are from those of the polynomial
  double steep = 0.0;  ///< what heights and those of the polynomial may change by differently on a way 1 long
};

/// All but how far they are off. @returns none where it is no graph
std::optional<PartHeights> nearly_heights(const PatchPart& part, const HeightFrame& frame);

/// Adds how far they are off. @returns whether that is known
bool add_bounds(PartHeights& heights, const PatchPart& part, const HeightFrame& frame);

}  // namespace splinecore
#pragma GCC visibility pop
