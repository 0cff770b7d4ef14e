#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/measure/curve_frame.hpp"

namespace splinecore {

/// How a frame is carried along a curve.
struct CarriedFrame {
  /// Where the normal points at the start of the domain, as far as it is at right angles to the tangent. Without one it
  /// is Frenet's, or on a straight start the axis that is most at right angles.
  std::optional<glm::dvec3> start;
  /// What the frame has turned by at the end of a closed curve is taken back, evenly by length.
  bool is_closed = false;
};

/// A frame at each parameter that turns about the tangent no more than it must, from the start of the domain on.
///
/// By double reflection (Wang, Jüttler, Zheng and Liu 2008), each step compared with two of half its length: it is
/// halved until they agree to 1e-10, and the remaining difference is removed (Richardson 1911). The steps
/// depend on the curve alone; so does a frame, which is right to about 1e-9 for a curve that turns some hundred times.
/// Straight parts keep the frame, at corners and gaps it turns as little as it can, at a cusp the normal stays.
/// A periodic curve takes any parameter, modulo its period; at the end of its domain the frame is that carried there.
/// @throws InvalidShape for a parameter outside the domain of a plain curve, if the curve is a point, if the start is
///         zero or along the tangent, or if it is to be closed and does not close smoothly; PointAtInfinity;
///         ToleranceNotReached where a span turns so wildly that steps are halved more than 2^17 times; and as
///         lengths_at_parameters() where it is closed.
void rotation_minimizing_frames(const NurbsCurve& curve, std::span<const double> parameters,
                                std::span<MovingFrame> out, const CarriedFrame& how = {}, Side side = Side::right);

}  // namespace splinecore
