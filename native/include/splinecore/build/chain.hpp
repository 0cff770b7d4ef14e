#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"

namespace splinecore {

/// The m cubic Bezier curves of the C2 chain that a polygon d_0 … d_{m+2} and parameters u_3 … u_{m+3} give
/// (lecture row S8, with its points f, g and e; The NURBS Book, 5.3).
///
/// It is the cubic B-spline on these knots with its ends fourfold.
/// @param parameters  m + 1 of them, increasing; empty means 0, 1, 2, …
/// @throws InvalidShape if there are fewer than 4 points, counts disagree, a number is not finite or the
///         parameters do not increase.
std::vector<BezierCurve> chain_from_polygon(std::span<const glm::dvec3> points, std::vector<double> parameters = {});

/// The polygon of a C2 chain of cubic Bezier curves: chain_from_polygon() undone.
///
/// At each joint with intervals a before and b after it, q and r the curves, three places are compared that
/// are one if the chain is C2: q_3 with r_0, (b q_2 + a r_1) / (a + b) with q_3, and q_2 + (b/a)(q_2 - q_1)
/// with r_1 + (a/b)(r_1 - r_2), which is the point of the polygon.
/// @param lengths    of the intervals, one for each curve; empty means 1
/// @param tolerance  how far they may lie apart; none means rounding: 1e-12 of the largest coordinate,
///                   in the last of the three times 1 + the larger one of a/b and b/a
/// @throws InvalidShape if the chain is empty, a curve is not a polynomial cubic, a length is not positive,
///         or a joint is not C2: the message has its number, from 1.
std::vector<glm::dvec3> polygon_of_chain(std::span<const BezierCurve> chain, std::vector<double> lengths = {},
                                         std::optional<double> tolerance = {});

/// The two cubics q and r that meet with C2 continuity, on intervals of lengths a and b (lecture row S7):
/// from q_0, q_1 and r_2, r_3 and the point d where the legs q_1 q_2 and r_2 r_1 meet when prolonged,
/// q_2 = (b q_1 + a d) / (a + b), r_1 = (b d + a r_2) / (a + b), q_3 = r_0 = (b q_2 + a r_1) / (a + b).
/// @throws InvalidShape if a or b is not positive and finite, or a coordinate is not finite.
std::pair<BezierCurve, BezierCurve> c2_pair(const glm::dvec3& q0, const glm::dvec3& q1, const glm::dvec3& d,
                                            const glm::dvec3& r2, const glm::dvec3& r3, double a = 1.0,
                                            double b = 1.0);

}  // namespace splinecore
