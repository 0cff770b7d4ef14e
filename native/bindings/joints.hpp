#pragma once

#include <pybind11/pybind11.h>

namespace bindings {

void bind_joints(pybind11::module_& build);

}  // namespace bindings
