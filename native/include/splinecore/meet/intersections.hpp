#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/conic/plane.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// A place where two curves meet.
struct CurveIntersection {
  double a;          ///< the parameter of the first curve
  double b;          ///< and of the second one
  glm::dvec3 point;  ///< in the middle between both
  double distance;   ///< of the curves there
  bool touches;      ///< whether their tangents are parallel
};

/// A stretch along which two curves are one, up to the tolerance.
struct CurveOverlap {
  Interval a;
  Interval b;
  bool is_reversed;  ///< whether the parameter of the second one falls where that of the first rises
};

struct CurveIntersections {
  std::vector<CurveIntersection> places;    ///< in the order of the parameters of the first curve
  std::vector<CurveOverlap> overlaps;        ///< likewise
};

/// A place where a curve meets a patch.
struct PatchIntersection {
  double t;                         ///< the parameter of the curve
  std::array<double, 2> parameters; ///< u and v of the patch
  glm::dvec3 point;                 ///< in the middle between both
  double distance;                  ///< of both there
  bool touches;                     ///< whether the curve does not go through the patch
};

struct PatchIntersections {
  std::vector<PatchIntersection> places;  ///< in the order of the parameters of the curve
  std::vector<Interval> overlaps;         ///< stretches of the curve that lie on the patch, likewise; none overlap
};

/// Where two curves are at most `tolerance` apart: places where their distance is least, ends included, and stretches
/// that they have in common, one for each way that a curve which folds takes. Curves that cross are found however close
/// the crossings are; places are one only where both curves stay within the tolerance of each other from one to the
/// other. Of a curve that ends where it begins places are in [start, end). Parts farther away than 2^20 times the size,
/// where a curve runs through infinity, meets nothing.
///
/// Where curves touch with k derivatives in common they are within the tolerance of each other about as far as its
/// (k + 1)th root. That is one place, which touches: where they have the k derivatives in common, found from all of that
/// stretch, so that it is off by about the rounding of coordinates, as a part of the tolerance, of the stretch's length.
/// A contact that rounding cannot tell from one at the end of a curve is there. It is an overlap where along three quarters of it they are evenly near: at most 1/64 of the tolerance, less their least
/// distance, farther apart than where they are nearest; or where a curve ends at both of its ends, or it is closed.
///
/// Where a curve folds, overlaps continue over parts that turn back by up to 16 tolerances, as long as curves stay beside each
/// other there. Two are different only where they are farther apart along one of the curves than 64 tolerances: of others
/// the longest stays. A place no farther than that from an overlap, from where curves stay within four tolerances, is of it.
///
/// Pairs of Bernstein pieces on two trees of boxes along them (Gottschalk, Lin and Manocha 1996) are halved until hulls
/// are apart, tangents differ so that they cross once at most (Sederberg and Meyers 1988), which Newton's method finds or
/// a gap shows not to be, or they lie within the tolerance of each other. S18.
/// @param tolerance  none: 2^-33 of how far control points of both reach from the middle of them all
/// @throws InvalidShape if the tolerance is below 0 or no number, after 2^22 pairs, or 512 a span if these are more, or
/// where weights are so unlike that a curve goes much farther than the tolerance within the rounding of its parameter.
CurveIntersections intersections(const NurbsCurve& a, const NurbsCurve& b, std::optional<double> tolerance = {});

/// Where a curve meets itself: places with a < b, without those that its neighborhood is always within the tolerance
/// of, as at a cusp; where it folds it lies on itself. Of a closed curve a stretch over its end is one, whose end is a
/// turn further.
CurveIntersections self_intersections(const NurbsCurve& curve, std::optional<double> tolerance = {});

/// Where a curve and a patch are at most `tolerance` apart: places where their distance is least, the ends of the curve
/// included, and stretches that lie on the patch; by halving, as of two curves. Where the patch crosses itself there is a
/// place for each of its sheets; a stretch over the end of a closed curve is one, and its end a turn further. S18.
/// @param tolerance  none: 2^-33 of how far control points of both reach from the middle of them all
/// @throws InvalidShape if the tolerance is below 0 or no number, or after 2^20 pairs.
PatchIntersections intersections(const NurbsCurve& curve, const NurbsPatch& patch, std::optional<double> tolerance = {});

/// The same with a plane, whose coordinates are the parameters. The default tolerance is by the curve alone.
PatchIntersections intersections(const NurbsCurve& curve, const Plane& plane, std::optional<double> tolerance = {});

}  // namespace splinecore
