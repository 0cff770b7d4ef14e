#pragma once

#include <span>

#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// How parameters at a jump and at infinity are taken, and on how many threads: 0 for one on each core where a batch is
/// worth it. The numbers are the same, bit for bit, and no thread outlives its call.
struct EvaluateOptions {
  Side side = Side::right;
  AtInfinity at_infinity = AtInfinity::raise;
  int threads = 0;
};

/// x, y, z at each parameter; out.size() == 3 * parameters.size(). float32 is the last store only: a coordinate
/// above its range, 3.4e38, becomes infinite there.
///
/// Horner's scheme in Bernstein's form from the nearer end of the span (Volk and Schumaker 1990): as stable as
/// de Casteljau's algorithm at any degree (S6, S14, S15). Every parameter has the same bits whatever
/// else is in the batch, in any order and on any number of threads.
/// A periodic curve takes any parameter, modulo its period.
/// @throws InvalidShape for a parameter outside the domain of a plain curve, or that is not finite; PointAtInfinity
///         unless asked for NaN.
void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out,
              EvaluateOptions options = {});
void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<float> out,
              EvaluateOptions options = {});

/// The point and its derivatives up to `order`; out.size() == 3 * (order + 1) * parameters.size().
///
/// Derivatives of the homogeneous curve, then the quotient rule (The NURBS Book, A4.2).
void derivatives(const NurbsCurve& curve, std::span<const double> parameters, int order,
                 std::span<double> out, EvaluateOptions options = {});

/// The homogeneous point at each parameter, divided as homogeneous_points() are: defined also where the curve is at
/// infinity.
void evaluate_homogeneous(const NurbsCurve& curve, std::span<const double> parameters,
                          std::span<glm::dvec4> out, Side side = Side::right);

}  // namespace splinecore
