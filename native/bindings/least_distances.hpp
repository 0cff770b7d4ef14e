#pragma once

#include <pybind11/pybind11.h>

namespace bindings {

/// The least distance of two shapes: to be called when all their classes are there.
void bind_least_distances(pybind11::module_& module);

}  // namespace bindings
