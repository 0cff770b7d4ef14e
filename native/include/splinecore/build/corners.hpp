#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The curve with an arc of a circle in place of each of its corners, at which its tangent turns; also of those at the
/// seam of a closed one. Its runs between corners are shortened to where the arcs touch them. Without corners as it is.
/// S18.
/// @throws InvalidShape naming the corner's place if no arc of that radius fits between its neighbors, or the curve
///         turns back or is not plane there; unless the radius is above 0.
/// @param shrinks  whether an arc that does not fit has the largest radius that does: of a run between two corners each
///         takes no more than half, of one up to an end all. Where the curve turns back its corner stays.
NurbsCurve rounded(const NurbsCurve& curve, double radius, bool shrinks = false);

/// The same with a line between the places at a length before and behind each corner.
NurbsCurve chamfered(const NurbsCurve& curve, double length, bool shrinks = false);

/// Two curves up to what joins them; one of which nothing is left is none.
struct CornerBetween {
  std::optional<NurbsCurve> a;
  NurbsCurve bridge;  ///< from a to b
  std::optional<NurbsCurve> b;
};

/// Two curves with the arc of a radius that touches both, each shortened to it: of those that leave the parts about
/// `kept` the one that is nearest to them, or that takes a curve whole. Open curves that have none are extended straight up to it.
/// Closed ones are not cut.
/// @param kept  a parameter of each
/// @throws InvalidShape if there is none; and as fillets().
CornerBetween filleted(const NurbsCurve& a, const NurbsCurve& b, double radius, const std::array<double, 2>& kept,
                       const glm::dvec3& normal);

/// The same with a line between the places at two lengths from where the curves meet: nearest to `kept`, and where open
/// curves would straight on, if they do not meet.
/// @throws InvalidShape if they do not, a length is below 0, both are 0, or a curve is too short.
CornerBetween chamfered(const NurbsCurve& a, const NurbsCurve& b, const std::array<double, 2>& lengths,
                        const std::array<double, 2>& kept);

}  // namespace splinecore
