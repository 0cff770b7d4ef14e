#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// New knots, and for each of their control points the old one that it is.
///
/// The verbs that only move points about, for a curve and for either direction of a patch.
struct Selection {
  KnotVector knots;
  std::vector<int> indices;
};

/// How many copies of u must be inserted until a curve falls apart there.
int missing_for_cut(const KnotVector& knots, double u) noexcept;

/// The parts on either side of u, which has multiplicity degree + 1 inside a plain vector.
Selection part_before(const KnotVector& knots, double u);
Selection part_after(const KnotVector& knots, double u);

/// One period of a periodic vector from u on, which has multiplicity degree + 1, as a plain one.
Selection opened_at(const KnotVector& knots, double u);

/// A vector clamped at both ends as a periodic one whose seam has `degree` equal knots; the last point, which
/// lies on the first, is left out. The inverse of opened_at().
Selection closed_up(const KnotVector& knots);

/// The plain vector with unrolled() knots.
Selection unrolled(const KnotVector& knots);

/// Increasing numbers mirrored in the middle of the domain, as start + end - u. Where its rounding would change the
/// lengths of up to `window` steps in a row by more than some roundings of their own, short steps far from zero, they
/// are mirrored at zero, which is exact: then the domain is [-end, -start].
std::vector<double> mirrored(std::span<const double> knots, const Interval& domain, std::size_t window);

/// The knots mirrored, as mirrored() says.
Selection reversed(const KnotVector& knots);

/// @throws InvalidShape unless u lies strictly inside the domain of a plain vector.
void require_inside(const KnotVector& knots, double u);

}  // namespace splinecore
#pragma GCC visibility pop
