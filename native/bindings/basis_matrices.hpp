#pragma once

#include <pybind11/pybind11.h>

namespace bindings {

/// The matrices of the lectures, in the submodule basis.
void bind_matrices(pybind11::module_& basis);

}  // namespace bindings
