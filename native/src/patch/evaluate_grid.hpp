#pragma once

#include <span>

#include "grid.hpp"
#include "splinecore/patch/evaluate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

// The grids of evaluate.hpp, for parameters that many patches have in common.

void evaluate_grid(const NurbsPatch& patch, const GridPlan& plan, std::span<double> points, AtInfinity at_infinity,
                   int threads);
void evaluate_grid(const NurbsPatch& patch, const GridPlan& plan, std::span<float> points, AtInfinity at_infinity,
                   int threads);
void evaluate_grid_with_normals(const NurbsPatch& patch, const GridPlan& plan, std::span<double> points,
                                std::span<double> normals, AtInfinity at_infinity, int threads);
void evaluate_grid_with_normals(const NurbsPatch& patch, const GridPlan& plan, std::span<float> points,
                                std::span<float> normals, AtInfinity at_infinity, int threads);

}  // namespace splinecore
#pragma GCC visibility pop
