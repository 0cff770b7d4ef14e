#pragma once

#include "driver.hpp"

namespace benchmarks {

/// The teapot meshed by BRepMesh to a deflection of 1e-3.
void mesh_teapot(const Run& run);

/// Where two zigzag curves cross, and the curves of two waves.
void cross_zigzags(const Run& run);
void cross_waves(const Run& run);

/// Where rays meet the two faces of a lens.
void first_hits(const Run& run);
void all_hits(const Run& run);

/// Surfaces from curves and from others.
void loft(const Run& run);
void sweep(const Run& run);
void pipe(const Run& run);
void coons(const Run& run);
void fill_four(const Run& run);
void fill_five(const Run& run);
void offset(const Run& run);

}  // namespace benchmarks
