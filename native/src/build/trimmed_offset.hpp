#pragma once

#include <vector>

#include "bezier_runs.hpp"
#include "meet/near_space.hpp"
#include "offset_piece.hpp"
#include "sharp_tips.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The parts of an offset that are as far from the curve as the distance, up to the tolerance, and not under the tip of a sharp
/// corner, those that meet joined.
/// @param curve   out of the space
/// @param runs    its offset, in the space, within half the tolerance
/// @param others  curves at the same distance that are cut with, too: on the other side, and about ends
/// @param tips    of the offset, where its corners are sharp
std::vector<BezierPieces> trimmed_offset(const NurbsCurve& curve, const NearSpace& space, const SideStep& step,
                                         const std::vector<BezierPieces>& runs,
                                         const std::vector<BezierPieces>& others, std::vector<SharpTip> tips);

}  // namespace splinecore
#pragma GCC visibility pop
