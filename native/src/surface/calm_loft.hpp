#pragma once

#include <functional>

#include "splinecore/surface/loft.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

using MadeLoft = std::function<Approximation<NurbsPatch>(const LoftOptions&)>;

/// A loft that follows its neighbors as far as the options say, or, if they allow that, less: where neighbors bend so sharply beside their
/// sides that what goes on from there would shoot out, or their weights fall so fast that some would not stay positive.
LoftSurface calm_loft(LoftOptions options, const MadeLoft& make);

}  // namespace splinecore
#pragma GCC visibility pop
