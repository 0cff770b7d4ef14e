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

/// What fills a rim: patches with normals on the side from which it runs to the left, and how far it is from a plane.
struct FilledRim {
  std::vector<NurbsPatch> patches;
  double bend;
};

/// Of sides that go round, each from where the one before it ends; none if no chords between their ends cut what lies within into
/// parts that are seen whole.
/// @throws InvalidShape as rim_filling()
std::optional<FilledRim> filled_rim(std::span<const RimSide> rim);

/// Whether a side is a segment, which need not be cut.
bool is_segment(const NurbsCurve& curve);

std::array<glm::dvec3, 2> end_points(const NurbsCurve& curve);

/// Which side comes next round a rim, and how.
struct RimOrder {
  std::size_t side;
  bool is_reversed;
};

/// The order in which sides go round, from the first as it is. @throws InvalidShape if they do not
std::vector<RimOrder> rim_order(std::span<const NurbsCurve> sides);

}  // namespace splinecore
#pragma GCC visibility pop
