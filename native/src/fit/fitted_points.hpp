#pragma once

#include "splinecore/fit/approximate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A curve by least squares, and how far from it points lie.
struct FittedPoints {
  KnotVector knots;
  std::vector<glm::dvec3> controls;
  std::vector<double> span_errors;  ///< the largest of each span
  double error;

  NurbsCurve curve() const;
};

/// @throws InvalidShape as approximate() does where points, parameters or options cannot be.
void require_approximation(std::span<const glm::dvec3> points, std::span<const double> parameters, Closing closing,
                           const ApproximationOptions& options);

/// @throws InvalidShape as approximate() does where knots do not belong to parameters and options.
void require_approximation_knots(const KnotVector& knots, std::span<const double> parameters,
                                 const ApproximationOptions& options);

/// The curve on these knots.
/// @param parameters  of the points; where closed without the return
FittedPoints fitted_points(std::span<const glm::dvec3> points, std::span<const double> parameters,
                           const KnotVector& knots, const ApproximationOptions& options);

/// And the parameters are moved as often as the options ask for.
FittedPoints corrected_fit(std::span<const glm::dvec3> points, std::vector<double>& parameters, const KnotVector& knots,
                           const ApproximationOptions& options);

}  // namespace splinecore
#pragma GCC visibility pop
