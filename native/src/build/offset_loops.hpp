#pragma once

#include "bezier_runs.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A run without the loops and folds that all lie within the tolerance of the rest of it: where pieces of an offset go on
/// as one another but for their approximation, the one may begin before the other ends.
BezierPieces without_loops(const BezierPieces& run, double tolerance);

/// A run without pieces that are next to nothing long beside the tolerance and may lead back; their neighbors meet.
BezierPieces without_specks(const BezierPieces& run, double tolerance);

/// A run that ends where it begins up to rounding, in every bit.
BezierPieces ended_at_start(BezierPieces run);

}  // namespace splinecore
#pragma GCC visibility pop
