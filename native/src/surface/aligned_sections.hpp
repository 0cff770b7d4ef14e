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
/// Nearest is the angle between their points at equal parts of the domains, which does not change where a curve is moved. A
/// periodic curve begins by 1/512 of its period beside that at most, where its knots are then those of others.
/// @param curves  about 1 large
std::vector<SectionTurn> turns_of(const std::vector<NurbsCurve>& curves);

/// By which part of its domain the first of sections that go round would have to begin later to run as the last one does,
/// from -1/2 to 1/2; 0 where it does.
/// @throws InvalidShape if it would have to begin at another corner, or to run the other way
double turn_left(const NurbsCurve& last, const NurbsCurve& first);

/// Periodic curves that go round and come back turned by this part of their domains: begun so that each has its share of that.
std::vector<NurbsCurve> turned_evenly(const std::vector<NurbsCurve>& curves, double share);

}  // namespace splinecore
#pragma GCC visibility pop
