#pragma once

#include <span>

#include "bytes.hpp"

namespace splinecore::fuzz {

/// What is fitted, with points or a shape, and arguments, from the bytes.
using FitStep = void (*)(Bytes& bytes);

/// Curves and patches near points.
std::span<const FitStep> point_fits();
/// Shapes near shapes, feet of normals, and integrals over surfaces.
std::span<const FitStep> shape_fits();

}  // namespace splinecore::fuzz
