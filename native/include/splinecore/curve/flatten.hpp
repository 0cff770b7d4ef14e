#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"

namespace splinecore {

/// A polyline on a curve: a point of it at each parameter, ends included.
struct Flattened {
  std::vector<double> parameters;
  std::vector<glm::dvec3> points;
};

/// The curve as a polyline that it leaves nowhere by more than `tolerance`, nor the polyline it.
///
/// Halves (M01, M12, M23; M012, M123; M0123: lecture row S6) until the control points of each part lie that
/// close to its chord and all its weights have one sign: then the part lies in their hull, rational or not.
/// @throws InvalidShape unless the tolerance is positive, finite and reached with 2^18 points.
/// @throws PointAtInfinity if the curve passes through infinity.
Flattened flattened(const BezierCurve& curve, double tolerance);

}  // namespace splinecore
