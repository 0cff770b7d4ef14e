#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Writes the points of a surface at every pair of parameters, v fastest.
using SurfaceFunction =
    std::function<void(std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> points)>;

/// A surface that so many control points do not come near to.
struct SurfaceMissed : ToleranceNotReached {
  SurfaceMissed(const std::string& what, double tolerance, double error, double u, double v);

  double u;  ///< where most is missed
  double v;
};

/// The patch through a surface with the weights, degrees and knots of a model, with as many knots more as the tolerance
/// needs: spans in which it misses the surface are halved, after degrees below 3 have been raised to that. Surfaces with
/// such weights and knots come out as they are.
/// @param model  about 1 large, as the surface; without gaps
/// @returns the patch, and the largest distance between the places at which it was made to meet the surface: that found, and a
///          quarter of it more
/// @param most  control points
/// @throws SurfaceMissed if so many do not come within it; InvalidShape if the model has a gap.
Approximation<NurbsPatch> fitted_patch(const NurbsPatch& model, const SurfaceFunction& surface, double tolerance,
                                       std::size_t most = std::size_t{1} << 18);

}  // namespace splinecore
#pragma GCC visibility pop
