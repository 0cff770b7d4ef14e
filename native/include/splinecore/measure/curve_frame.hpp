#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Curvature |C' x C''| / |C'|³ at each parameter; out.size() == parameters.size() (S15, S16).
///
/// Where C' falls to zero it is the limit, infinite at a sharp cusp; NaN where the curve is a point.
/// At a knot the right-hand value unless the side is left.
/// A periodic curve takes any parameter, modulo its period.
/// @throws InvalidShape for a parameter outside the domain of a plain curve; PointAtInfinity.
void curvature(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out,
               Side side = Side::right);

/// Curvature with a sign, (C' x C'') · normal / |C'|³: positive where the curve bends to its left, seen against the
/// normal.
/// Of a curve that lies in no plane at right angles to the normal it is the part of the curvature about the normal.
/// Limits as those of curvature(). @throws also InvalidShape if the normal is zero or not finite.
void signed_curvature(const NurbsCurve& curve, std::span<const double> parameters, const glm::dvec3& normal,
                      std::span<double> out, Side side = Side::right);

/// Torsion det(C', C'', C''') / |C' x C''|², positive for a right-handed screw.
///
/// Where C' x C'' falls to zero, at an inflection or a cusp, it is the limit. NaN on a straight line, which has
/// no osculating plane.
void torsion(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out,
             Side side = Side::right);

/// Three unit vectors, binormal = tangent x normal.
struct MovingFrame {
  glm::dvec3 tangent;
  glm::dvec3 normal;
  glm::dvec3 binormal;
};

/// Frenet's frame at each parameter, also as a limit. Normal and binormal are NaN where the curve is straight, and all
/// three where it is a point. At a cusp the tangent is that of the way on; with the side left, of the way in.
void frenet_frames(const NurbsCurve& curve, std::span<const double> parameters, std::span<MovingFrame> out,
                   Side side = Side::right);

}  // namespace splinecore
