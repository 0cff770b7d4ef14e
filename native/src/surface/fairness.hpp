#pragma once

#include <span>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How patches bend: the same however they are run through, moved or scaled.
struct SurfaceBending {
  double whole = 0.0;   ///< the integral of the sum of both squared principal curvatures
  double uneven = 0.0;  ///< of that what a sphere with the same area and the same mean curvature has less; 0 for parts of spheres
};

SurfaceBending bending_of(std::span<const NurbsPatch> patches);

}  // namespace splinecore
#pragma GCC visibility pop
