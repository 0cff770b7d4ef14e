#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A curve of a rim, and whether that is run the other way.
struct RimSide {
  NurbsCurve curve;
  bool is_reversed;
};

/// Sides that go round, each from where the one before it ends.
using RimLoop = std::vector<RimSide>;

/// What lies within a loop and outside of those in it, filled.
struct FilledRegion {
  std::vector<std::size_t> loops;   ///< the border, and then holes
  std::vector<NurbsPatch> patches;  ///< with normals on the side from which the widest of all loops runs to the left
};

struct FilledRim {
  std::vector<FilledRegion> regions;
  std::vector<bool> is_turned;  ///< of each loop, whether its region lies to the right of it, seen from there
  double bend;                  ///< how far it is from a plane
};

/// Of loops that have each other as holes or lie apart; none if no chords between the ends of their sides cut what lies within into
/// parts that are seen whole. @throws InvalidShape as rim_filling()
std::optional<FilledRim> filled_rim(std::span<const RimLoop> loops);

/// Whether a side is a segment, which need not be cut.
bool is_segment(const NurbsCurve& curve);

std::array<glm::dvec3, 2> end_points(const NurbsCurve& curve);

/// Which side comes next round a rim, and how.
struct RimOrder {
  std::size_t side;
  bool is_reversed;
};

/// The orders in which sides go round, once or several times, each from its first side as that is. @throws InvalidShape if they do not
std::vector<std::vector<RimOrder>> rim_orders(std::span<const NurbsCurve> sides);

}  // namespace splinecore
#pragma GCC visibility pop
