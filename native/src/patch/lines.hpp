#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <vector>

#include "basis/point_matrix.hpp"
#include "basis/selection.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

// A patch along one axis is a bundle of curves, the lines of its net, on the same knots.

/// The direction that is not this one.
inline Axis across(Axis axis) noexcept { return axis == Axis::u ? Axis::v : Axis::u; }

/// Where a net of rows has point i of a line.
struct Lines {
  std::size_t count;  ///< of lines
  std::size_t size;   ///< points of a line
  std::size_t step;   ///< from one point of a line to the next
  std::size_t next;   ///< from one line to the next

  Lines(Axis axis, std::size_t lines, std::size_t points)
      : count(lines), size(points), step(axis == Axis::u ? lines : 1), next(axis == Axis::u ? 1 : points) {}

  std::size_t at(std::size_t line, std::size_t i) const noexcept { return line * next + i * step; }
};

/// The lines of a patch along an axis.
Lines lines_of(const NurbsPatch& patch, Axis axis);

/// The same lines among its homogeneous points, which are unrolled.
Lines homogeneous_lines_of(const NurbsPatch& patch, Axis axis);

/// A patch with other knots along an axis, and with the points that belong to them.
NurbsPatch with_axis(const NurbsPatch& patch, Axis axis, const KnotVector& knots, std::vector<glm::dvec4> points);

/// The points that a matrix makes of every line, on its new knots; what stays is copied bit for bit.
NurbsPatch applied(const PointMatrix& matrix, const NurbsPatch& patch, Axis axis);

NurbsPatch selected(const NurbsPatch& patch, Axis axis, const Selection& selection);

/// With u of multiplicity degree + 1, so that the patch falls apart there.
NurbsPatch cut(const NurbsPatch& patch, Axis axis, double u);

/// The patch whose every line is what a verb makes of it.
///
/// The verb sees polynomial curves, of (wx, wy, wz) and of w as x, because a line may lie at infinity
/// altogether; so it must be linear in homogeneous points and tell the new knots from the old ones alone.
/// Points that come out as they went in keep every digit.
NurbsPatch along(const NurbsPatch& patch, Axis axis, const std::function<NurbsCurve(const NurbsCurve&)>& verb);

/// The Bezier patch with the net of a patch, and the Bezier curve with the points of a line.
BezierPatch as_bezier(const NurbsPatch& patch);
BezierCurve as_bezier(const NurbsCurve& line);

}  // namespace splinecore
#pragma GCC visibility pop
