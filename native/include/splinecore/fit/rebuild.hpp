#pragma once

#include <cstddef>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// Whether points alone or tangents, too, stay the same at the ends of an open curve that is rebuilt.
enum class KeptEnds { points, tangents };

/// A curve of this degree with this number of control points and even knots over the same domain: the one nearest in the
/// integral of the squared distance at equal parameters, periodic if the curve is (orthogonal projection: lecture row
/// S17). With degree + 1 control points it is one Bezier piece.
/// @returns the curve, polynomial, and the largest distance at equal parameters: at most 1 % above the truth
/// @throws InvalidShape if the control points are too few, or the curve is not finite everywhere.
Approximation<NurbsCurve> rebuild(const NurbsCurve& curve, int degree, std::size_t count,
                                  KeptEnds ends = KeptEnds::points);

/// The same with as few control points as come within the tolerance: found by doubling and halving.
/// @throws ToleranceNotReached if `most` do not.
Approximation<NurbsCurve> rebuild_within(const NurbsCurve& curve, int degree, double tolerance, std::size_t most,
                                         KeptEnds ends = KeptEnds::points);

/// Degree and number of control points of a rebuilt patch in one direction.
struct RebuiltDirection {
  int degree;
  std::size_t count;
};

/// The same of a patch, first along u, then along v. Its corners stay.
/// @returns the patch, and the largest distance at equal parameters: at most 2 % above the truth
Approximation<NurbsPatch> rebuild(const NurbsPatch& patch, const RebuiltDirection& u, const RebuiltDirection& v);

}  // namespace splinecore
