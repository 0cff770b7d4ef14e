#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/curve/power_curve.hpp"

namespace splinecore {

/// The curve under an affine or projective map; the weights stay where it is affine (S9, S15).
///
/// A perspective projection of a rational curve is a rational curve with other weights; a point that
/// comes to lie at infinity has weight 0 and is a direction.
/// @param matrix  maps columns (x, y, z, w); affine if its last row is 0, 0, 0, 1
/// @throws InvalidShape if a number is not finite or every point goes to infinity.
NurbsCurve transformed(const NurbsCurve& curve, const glm::dmat4& matrix);
BezierCurve transformed(const BezierCurve& curve, const glm::dmat4& matrix);
PowerCurve transformed(const PowerCurve& curve, const glm::dmat4& matrix);

/// @throws InvalidShape if the map is not affine: the image is no Hermite curve.
HermiteCurve transformed(const HermiteCurve& curve, const glm::dmat4& matrix);

/// The same of control points, as they were given.
std::vector<glm::dvec4> transformed(std::span<const glm::dvec4> points, const glm::dmat4& matrix);

}  // namespace splinecore
