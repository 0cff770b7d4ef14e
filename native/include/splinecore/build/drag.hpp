#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// Which control points follow where a point of a shape is dragged.
struct Following {
  /// How readily each may move, 0: not at all; empty: all alike. Tangents and twists count as points, in the order
  /// in which dragged() names them.
  std::vector<double> factors;
  /// 0: all that the point depends on move, each by its influence. The larger, the fewer: factors are multiplied by
  /// the influence to this power.
  double locality = 0.0;
};

/// How a point of a curve is dragged.
struct Drag {
  glm::dvec3 by;
  /// The change of the derivative there; zero keeps it. None: it goes as it does.
  std::optional<glm::dvec3> tangent_by;
  /// The change of the second derivative there, the tangent being chosen, too. None: it goes as it does.
  std::optional<glm::dvec3> second_by = {};
};

/// The curve with control points moved as little as can be so that its point at u moves by `drag.by`.
///
/// Least is the sum of the squares of their motions, each divided by its factor. Weights, knots and points at infinity
/// stay. The ends of a curve that closes in one point move as one (The NURBS Book, 11.5, constraint-based modification).
/// @throws InvalidShape if u is outside the domain, a number is not finite, a factor is below 0, or no point that the
///         curve has there may move; with a tangent or second derivative also if too few may, or it comes without tangent.
/// @throws PointAtInfinity if the weight at u is zero.
NurbsCurve dragged(const NurbsCurve& curve, double u, const Drag& drag, const Following& following = {});
BezierCurve dragged(const BezierCurve& curve, double u, const Drag& drag, const Following& following = {});

/// The same for points, incoming tangents, outgoing tangents, in this order. The motion of a tangent is measured at the
/// end of its handle, a third of the span away; tangents that are equal at a point remain so.
HermiteCurve dragged(const HermiteCurve& curve, double u, const Drag& drag, const Following& following = {});

/// How a point of a patch is dragged.
struct PatchDrag {
  glm::dvec3 by;
  /// The change of the derivatives along u and v there; zero keeps one. None: it goes as it does.
  std::optional<glm::dvec3> tangent_u_by = {};
  std::optional<glm::dvec3> tangent_v_by = {};
};

/// The same in the pool of one of many patches: rows that patches share are moved once, and the neighbors go along.
/// Points that lie in one place move as one. A tangent or twist that serves several corners stays.
PatchSet dragged(const PatchSet& set, std::size_t patch, double u, double v, const PatchDrag& drag,
                 const Following& following = {});

/// The same for a patch alone: its points row after row; of a Hermite patch points, tangents along u, along v, twists.
NurbsPatch dragged(const NurbsPatch& patch, double u, double v, const PatchDrag& drag, const Following& following = {});
BezierPatch dragged(const BezierPatch& patch, double u, double v, const PatchDrag& drag, const Following& following = {});
HermitePatch dragged(const HermitePatch& patch, double u, double v, const PatchDrag& drag,
                     const Following& following = {});

}  // namespace splinecore
