#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

/// E, F, G: products of S_u and S_v; L, M, N: those of S_uu, S_uv, S_vv with the unit normal along S_u x S_v.
struct FundamentalForms {
  double e = 0.0;
  double f = 0.0;
  double g = 0.0;
  double l = 0.0;
  double m = 0.0;
  double n = 0.0;
};

/// Both forms at each pair (u[i], v[i]); out.size() == u.size() (do Carmo 1976, 2.5 and 3.3; S19, S20).
///
/// At a pole or a collapsed edge the normal is its limit; L, M, N are NaN where it has none. At a knot values
/// are right-hand, or of the side asked for.
/// A periodic direction takes any parameter, modulo its period.
/// @throws InvalidShape for a parameter outside the domain of a plain direction; PointAtInfinity unless NaN is asked
///         for.
void fundamental_forms(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                       std::span<FundamentalForms> out, PatchOptions options = {});

/// How a surface bends at a point: positive towards its normal, so that of a sphere with its normals
/// outwards both principal curvatures are -1 / radius.
struct SurfaceCurvature {
  double gauss = 0.0;
  double mean = 0.0;
  std::array<double, 2> principal{};  ///< the larger one first
  /// Unit vectors, at right angles; the second is the normal times the first. Where all directions are
  /// principal the first is that of S_u.
  std::array<glm::dvec3, 2> directions{};
};

/// The curvatures at each pair; out.size() == u.size().
///
/// At a pole, where lines of one direction meet in a point, the normal curvatures along nine of them decide: if
/// the surface is smooth there, they are those of one form (Euler's theorem), which is found by least squares.
/// NaN where they are not (the tip of a cone), where the lines do not leave in different directions, and where
/// S_u and S_v are parallel.
void curvatures(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                std::span<SurfaceCurvature> out, PatchOptions options = {});

}  // namespace splinecore
