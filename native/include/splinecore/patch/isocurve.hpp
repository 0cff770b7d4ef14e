#pragma once

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The curve on a patch along which the parameter of `axis` is constant (rows S18, S20; The NURBS Book, §3.4).
///
/// Exact and homogeneous: on the knots of the other direction, periodic where that is. Where a control point of
/// the patch alone sets one of the curve, it is copied bit for bit. At a knot Side::right takes the patch's
/// value from there on, at the end of the domain from before. A periodic axis takes any parameter, modulo its period.
/// @throws InvalidShape if the parameter is outside the domain of a plain axis, or the curve lies at infinity
///         altogether.
NurbsCurve isocurve(const NurbsPatch& patch, Axis axis, double at, Side side = Side::right);
BezierCurve isocurve(const BezierPatch& patch, Axis axis, double at);

/// The sides of a patch, in the order of Panel.
enum class Border { u_start, u_end, v_start, v_end };

/// The direction whose parameter is constant along a side.
inline Axis axis_of(Border border) noexcept {
  return border == Border::u_start || border == Border::u_end ? Axis::u : Axis::v;
}

/// Whether a side is where its parameter ends.
inline bool is_at_end(Border border) noexcept { return border == Border::u_end || border == Border::v_end; }

/// The curve of a side; of a periodic direction that of its seam.
/// @throws InvalidShape if the side lies at infinity altogether.
NurbsCurve boundary(const NurbsPatch& patch, Border border);
BezierCurve boundary(const BezierPatch& patch, Border border);

}  // namespace splinecore
