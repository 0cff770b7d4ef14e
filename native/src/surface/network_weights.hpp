#pragma once

#include "paced_family.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Lets rational curves meet at the same parameters with the same weights, so that the outermost ones that keep their pace stay as
/// they are, but for a factor of their weights that is the same everywhere or linear. The weights of the others lie between theirs.
/// @returns whether that can be done: not where there are no outermost curves, or weights are not positive
/// @throws ToleranceNotReached
bool let_meet_with_weights(PacedFamily& u, PacedFamily& v, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
