#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Control points of what runs from 0 to 1 over the domain of plain knots at an even pace: Greville's abscissae.
std::vector<double> straight_controls(const KnotVector& knots);

/// How much of what bends nowhere may be lost in a system that is to be believed. Beside an energy that is 1e16 times as
/// large, what points ask for is rounded away: corrections are small then without being right. Otherwise errors halve with
/// each.
constexpr double kMostLost = 0.5;

}  // namespace splinecore
#pragma GCC visibility pop
