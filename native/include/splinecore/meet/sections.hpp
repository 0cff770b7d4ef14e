#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/conic/plane.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// What two shapes do at a curve that they have in common.
enum class SectionKind {
  crossing,  ///< they go through each other
  touching,  ///< they touch, and part to both sides, also at a crease: a ridge or a valley of one lies on the other
  border,    ///< they are one up to it: one ends there, or leaves the other
};

/// A curve that two shapes have in common, and its images: the points (u, v, 0) of both by the same parameter, which is
/// nearly the length. Over the seam of a closed patch an image continues beyond the domain.
struct SectionCurve {
  NurbsCurve curve;
  NurbsCurve on_a;
  NurbsCurve on_b;
  bool is_closed;  ///< whether it ends where it begins
  SectionKind kind = SectionKind::crossing;
};

/// A place where two shapes touch.
struct SectionPoint {
  std::array<double, 2> a;
  std::array<double, 2> b;
  glm::dvec3 point;
};

struct Sections {
  std::vector<SectionCurve> curves;
  std::vector<SectionPoint> points;  ///< that are on none of the curves
  bool are_one = false;              ///< whether the shapes are one in a part, up to the tolerance
};

/// The curves along which two patches cross or touch, cubics that are within the tolerance of both, and the points where
/// they touch. A curve ends at borders, at poles, where patches that cross touch and where one is folded. Of parts that
/// are one the borders that are borders of one of the patches.
///
/// Pairs of Bernstein pieces on two trees of boxes are halved until their hulls are apart, or their normals differ (Sinha,
/// Klassen, Wang 1985; Sederberg and Meyers 1988) and one of the four parameters goes one way along what they have in
/// common, so that each of its values has one place at most. Where patches nearly touch, the difference of their heights
/// over a plane tells the same of larger parts: a quadratic polynomial, and bounds of what it leaves. What known curves
/// leave of the range of that parameter is looked at until hulls are apart there or Newton's method finds a place, from
/// which a curve is followed, so that nothing is left. A border that lies on the other patch up to rounding is followed by
/// nearest places, and ends where the patches touch and part to the other side from there on. Where they touch the second derivatives of their distance tell along
/// which way that stays, and whether all of a pair of parts lies beside a curve that is known. Curves also end where they
/// come to others; those that continue each other within the tolerance are one. Patches that match by parameters, copies
/// however refined, elevated, reversed or weighted and parts of them, are one where control points prove that they are within
/// the tolerance, or, where those prove but 128 times as much, they are across at 7 x 7 places of each span; copies that part
/// farther there are looked at by a smaller tolerance. Which patch is given first changes nothing but images. Where patches are within the tolerance of each other about a point at which they touch, the
/// point says so. S18.
/// @param tolerance  none: 2^-20 of the size of both
/// @throws InvalidShape if the tolerance is below 0 or no number, or after 3 * 2^17 pairs, as where patches are nearly one,
///         or run through infinity together; after 2^24 control points of pairs, as of wild patches of degrees above 25.
Sections sections(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance = {});

/// The same with a plane; on_b and b have its coordinates. Of a patch that runs through infinity, with weights of both signs,
/// parts farther from its control points than their size is left out.
Sections sections(const NurbsPatch& patch, const Plane& plane, std::optional<double> tolerance = {});

}  // namespace splinecore
