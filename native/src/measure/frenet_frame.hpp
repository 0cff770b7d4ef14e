#pragma once

#include "rounded_jet.hpp"
#include "splinecore/measure/curve_frame.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// frenet_frames() at an admitted parameter of a curve near the origin.
MovingFrame frenet_frame(const NurbsCurve& near, const SlowPlaces& slow, double u, Side side);

}  // namespace splinecore
#pragma GCC visibility pop
