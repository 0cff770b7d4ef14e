#pragma once

#include "driver.hpp"

namespace benchmarks {

/// The teapot meshed by BRepMesh to a deflection of 1e-3.
void mesh_teapot(const Run& run);

/// Where two zigzag curves cross, and the curves of two waves.
void cross_zigzags(const Run& run);
void cross_waves(const Run& run);

}  // namespace benchmarks
