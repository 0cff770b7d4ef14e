#pragma once

#include <pybind11/pybind11.h>

#include "splinecore/patch/join.hpp"

// What joins of curves and of patches are asked for.
namespace bindings {

/// 'C0', 'G1', 'C1', 'G2' or 'C2'
splinecore::PatchSmoothness smoothness_of(const pybind11::object& value);

/// 'second', 'first' or 'both'
splinecore::JoinMoves moves_of(const pybind11::object& value);

}  // namespace bindings
