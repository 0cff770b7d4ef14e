#pragma once

#include "driver.hpp"

namespace benchmarks {

/// The teapot meshed by BRepMesh to a deflection of 1e-3.
void mesh_teapot(const Run& run);

}  // namespace benchmarks
