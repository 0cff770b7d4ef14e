#pragma once

#include <optional>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How a curve is turned so that it runs as another one does.
struct SectionTurn {
  bool is_reversed = false;
  std::optional<double> seam;  ///< where it begins then
};

NurbsCurve turned(const NurbsCurve& curve, const SectionTurn& turn);

/// For each of some curves how it runs as the one before it does, as that is turned: turned round where that is nearer, and
/// where it is periodic begun where it is nearest, at a corner if the one before it begins at one. The first stays.
///
/// Nearest is the sum of squared distances at equal parts of the domains, which does not change where a curve is moved.
/// @param curves  about 1 large
std::vector<SectionTurn> turns_of(const std::vector<NurbsCurve>& curves);

}  // namespace splinecore
#pragma GCC visibility pop
