#pragma once

#include <span>

#include "splinecore/base/interval.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// How jumps and points at infinity are taken, one side for each direction; threads as of EvaluateOptions.
struct PatchOptions {
  Side side_u = Side::right;
  Side side_v = Side::right;
  AtInfinity at_infinity = AtInfinity::raise;
  int threads = 0;
};

/// x, y, z at each pair (u[i], v[i]); out.size() == 3 * u.size() (lecture rows S19, S20). float32 as of a curve.
///
/// A pair has the same bits whatever else is in the batch, in any order, in a grid of any shape and on any number of
/// threads. The functions along u are summed before those along v: of a patch with both exchanged, swapped(), the last
/// bits may differ.
/// A periodic direction takes any parameter, modulo its period.
/// @throws InvalidShape for a parameter outside the domain of a plain direction, or that is not finite; PointAtInfinity
///         unless NaN is asked for.
void evaluate(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
              std::span<double> out, PatchOptions options = {});
void evaluate(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
              std::span<float> out, PatchOptions options = {});

/// The points, and unit normals as of evaluate_grid_with_normals().
void evaluate_with_normals(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                           std::span<double> points, std::span<double> normals, PatchOptions options = {});

/// x, y, z at every pair of the grid, v fastest; out.size() == 3 * u.size() * v.size().
void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<double> out, PatchOptions options = {});
void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<float> out, PatchOptions options = {});

/// The grid's points, and unit normals along S_u x S_v.
///
/// Where S_u x S_v vanishes (a pole, a collapsed edge) the normal is its limit when approached
/// from inside the domain; NaN where derivatives up to the third have none, as where the patch is a curve or a point.
/// A patch no wider than some roundings of its length is a curve: a rounding is one of the largest coordinate, however
/// the patch is turned.
void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<double> points,
                                std::span<double> normals, PatchOptions options = {});
void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<float> points,
                                std::span<float> normals, PatchOptions options = {});

/// The grid's points on samples computed before.
void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<double> points,
                   AtInfinity at_infinity = AtInfinity::raise, int threads = 0);
void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<float> points,
                   AtInfinity at_infinity = AtInfinity::raise, int threads = 0);

/// The same with normals; the samples must hold first derivatives.
void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<double> points, std::span<double> normals,
                                AtInfinity at_infinity = AtInfinity::raise, int threads = 0);
void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<float> points, std::span<float> normals,
                                AtInfinity at_infinity = AtInfinity::raise, int threads = 0);

/// The point and the derivatives along u and v at each pair; out.size() == 9 * u.size().
void first_derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                       std::span<double> out, PatchOptions options = {});

/// All mixed derivatives k along u and l along v with k, l <= order at each pair;
/// out.size() == 3 * (order + 1)² * u.size() (The NURBS Book, A4.4).
void derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                 int order, std::span<double> out, PatchOptions options = {});

}  // namespace splinecore
