#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// How a section is turned on its way along a rail.
enum class RailFrame {
  minimal,   ///< about the rail no more than it must be, and along a closed one evenly back to where it was
  upright,   ///< its y stays as near to a direction as a right angle to the rail allows
  parallel,  ///< not at all
};

/// A section in the frame of its rail: x along the frame's normal, y along its binormal, z along the rail.
struct RailSection {
  NurbsCurve curve;
  double at;  ///< the parameter of the rail to which it belongs
};

/// A number above 0 that belongs to a parameter of a rail.
struct RailNumber {
  double at;
  double value;
};

struct SweepOptions {
  RailFrame frame = RailFrame::minimal;
  glm::dvec3 up{0.0, 0.0, 1.0};        ///< of upright frames
  std::optional<glm::dvec3> start;     ///< where x points at the start of the rail, of minimal frames; none: as of CarriedFrame
  double end_scale = 1.0;              ///< sections grow evenly by the length of the rail up to this factor
  std::vector<RailNumber> scales;      ///< and by factors between which it goes without overshoot; empty: 1
  std::optional<NurbsCurve> scale;     ///< and by what x of a curve is at the parameters of the rail; none: 1
  double twist = 0.0;                  ///< and rotation about it by this angle, in radians: 1024 turns at most
  std::optional<double> tolerance;     ///< how far the surface may be from the sweep; none: 2^-20 of the size of the rail
};

/// The surface of a section that moves along a rail, changing from one section to the next where there are several: u along
/// the sections, v along the rail, by its parameter (The NURBS Book, 10.4; row S20).
///
/// Parallel frames and straight rails are exact: a sum of both curves. Otherwise rows of control points are cubic splines
/// along v, with knots where the tolerance needs them: first those of the rail, double ones where it has no third derivative,
/// for frames depend on its tangents, and those of the scale, at whose corners rows have some; none nearer to each other than
/// 2^-48 of the larger end of a stretch. At corners of the rail rows lie in the plane that halves the corner, so that stretches
/// between are whole if they are straight; others are refused.
/// @returns the surface, and how far rows were found to be from where they should be
/// @throws InvalidShape if there is no section, their parameters do not increase or lie outside the rail, a frame does not
///         exist, the rail turns back, or at a knot so sharply that parameters cannot tell it from a corner although it is none,
///         an end scale is not above 0, or a twist is more than 1024 turns; if the curve of a scale has another domain than the
///         rail, jumps, has points or weights that are not above 0, or on a closed rail ends with another number than it begins;
///         ToleranceNotReached; as rotation_minimizing_frames().
Approximation<NurbsPatch> sweep(const NurbsCurve& rail, std::span<const RailSection> sections,
                                const SweepOptions& options = {});

struct TwoRailOptions {
  bool is_height_scaled = true;        ///< sections grow with the distance of the rails in all directions; or along it alone
  std::optional<glm::dvec3> up;        ///< y stays as near to it as the rails allow; none: at right angles to the rails, as they run
  std::optional<double> tolerance;     ///< how far the surface may be from the sweep; none: 2^-20 of the size of the rails
};

/// The surface of a section between two rails, which are run through at equal parts of their domains (row S20): u along the
/// sections, v by the parameter of the first rail.
///
/// x of a section points from the first rail to the second one, and is stretched so that it stays between them; z is at
/// right angles to it and to y. Rows are fitted as those of sweep(). Closed where both rails are, smoothly.
/// @returns the surface, and how far rows were found to be from where they should be, with what a section passes by a rail
///          where the rails are farthest apart
/// @throws InvalidShape as sweep(), or if a section touches neither rail, the rails meet, run against each other on the whole
///         or somewhere straight, have corners without an upright direction, or run along the way from one to the other;
///         ToleranceNotReached.
Approximation<NurbsPatch> sweep(const NurbsCurve& rail, const NurbsCurve& second, std::span<const RailSection> sections,
                                const TwoRailOptions& options = {});

}  // namespace splinecore
