#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// Where two shapes are nearest to each other.
struct LeastDistance {
  double distance;          ///< of the points; the shapes are nowhere nearer than that less the tolerance
  std::array<double, 2> a;  ///< u and v, or of a curve its parameter alone
  std::array<double, 2> b;
  glm::dvec3 point_a;
  glm::dvec3 point_b;
  std::size_t patch_a = 0;  ///< of a set
  std::size_t patch_b = 0;
};

/// The least distance of two shapes, ends and borders included. Places are feet of each other, by nearest(), from where
/// shapes come near; then pairs of Bernstein pieces on two trees of boxes are halved until hulls show that nothing is
/// nearer by more than the tolerance (Johnson and Cohen 1998). Of places at one distance it is any. S18.
/// @param tolerance  none: 2^-33 of how far control points of both reach from the middle of them all
/// @throws InvalidShape if the tolerance is below 0 or no number, or after 2^22 pairs, as where shapes that are bent are
///         at one distance all along: a larger tolerance takes fewer; PointAtInfinity if a shape has no finite point.
LeastDistance least_distance(const NurbsCurve& a, const NurbsCurve& b, std::optional<double> tolerance = {});
LeastDistance least_distance(const NurbsCurve& a, const NurbsPatch& b, std::optional<double> tolerance = {});
LeastDistance least_distance(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance = {});

/// The same of all patches of sets. The size is that of both sets; pairs of patches whose boxes are farther apart than
/// a distance that was found are left out.
LeastDistance least_distance(const NurbsCurve& a, const PatchSet& b, std::optional<double> tolerance = {});
LeastDistance least_distance(const NurbsPatch& a, const PatchSet& b, std::optional<double> tolerance = {});
LeastDistance least_distance(const PatchSet& a, const PatchSet& b, std::optional<double> tolerance = {});

}  // namespace splinecore
