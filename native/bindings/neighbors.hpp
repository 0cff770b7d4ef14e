#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "splinecore/surface/loft.hpp"

// Patches that a surface goes on from, as arguments.
namespace bindings {

namespace py = pybind11;

/// 'G0' to 'G3'
int continuity_of(const py::object& word, const char* name);

/// (patch, side, 'G0' to 'G3'), and the strength where it is not 1; none for None.
std::optional<splinecore::LoftNeighbor> neighbor_of(const py::object& value, const char* name);

}  // namespace bindings
