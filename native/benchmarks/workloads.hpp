#pragma once

#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

// The inputs of the benchmarks, the same on every machine.
namespace benchmarks {

using Numbers = std::vector<double>;

/// W1: rational cubic of 64 points, a helix with noise, weights from 0.5 to 2, uneven knots on [0, 1].
splinecore::NurbsCurve helix();

/// W3: rational bicubic of 32 x 32 points, a wavy sheet with noise, uneven knots on [0, 1]².
splinecore::NurbsPatch sheet();

/// `count` parameters of [0, 1) in random order.
Numbers random_parameters(std::size_t count);

/// `count` parameters from 0 to 1, both included, evenly spaced.
Numbers even_parameters(std::size_t count);

}  // namespace benchmarks
