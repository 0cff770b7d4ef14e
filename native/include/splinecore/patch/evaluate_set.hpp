#pragma once

#include <span>

#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// evaluate_grid() of every patch of a set at the same parameters, patch after patch; what patches have in common is
/// computed once. @throws InvalidShape naming a patch with a plain direction whose domain has not all parameters.
void evaluate_grid(const PatchSet& set, std::span<const double> u, std::span<const double> v, std::span<double> out,
                   PatchOptions options = {});
void evaluate_grid(const PatchSet& set, std::span<const double> u, std::span<const double> v, std::span<float> out,
                   PatchOptions options = {});

/// evaluate_grid_with_normals() of every patch.
void evaluate_grid_with_normals(const PatchSet& set, std::span<const double> u, std::span<const double> v,
                                std::span<double> points, std::span<double> normals, PatchOptions options = {});
void evaluate_grid_with_normals(const PatchSet& set, std::span<const double> u, std::span<const double> v,
                                std::span<float> points, std::span<float> normals, PatchOptions options = {});

}  // namespace splinecore
