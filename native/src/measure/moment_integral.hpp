#pragma once

#include <array>
#include <functional>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Volume; first moments; second moments xx, xy, xz, yy, yz, zz.
inline constexpr int kMoments = 10;
using MomentValues = std::array<double, kMoments>;

/// Moments about the origin, how far they may be off by the rule, and the size of the terms, to which their rounding is
/// relative.
struct MomentSums {
  MomentValues values{};
  std::array<MomentValues, 2> errors{};  ///< along u and along v
  MomentValues terms{};

  double error(int i) const { return errors[0][i] + errors[1][i]; }
  double rounding(int i) const { return 0x1p-50 * terms[i]; }
};

/// What each moment may be off by, given those found so far.
using MomentTargets = std::function<MomentValues(const MomentSums&)>;

/// The moments of what closed patches enclose, and how often the worst is off by what it may, by the rule, where that
/// is more than rounding. Pieces are halved until none is, or until there are too many.
struct FoundMoments {
  MomentSums sums;
  double excess = 0.0;
};

/// @throws InvalidShape where weights or sizes differ too much, as a sentence that begins with what.
FoundMoments moments_of(const std::vector<NurbsPatch>& patches, const MomentTargets& targets, const char* what);

}  // namespace splinecore
#pragma GCC visibility pop
