#pragma once

#include <pybind11/pybind11.h>

namespace bindings {

/// What splinecore.meshes writes files with.
void bind_mesh_files(pybind11::module_& module);

}  // namespace bindings
