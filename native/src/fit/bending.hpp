#pragma once

#include <array>
#include <span>
#include <vector>

#include "derivative_products.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The integral of the squared second derivative of a curve, as its control points feel it.
class Bending {
 public:
  /// @param shortest  spans that are shorter count for nothing
  explicit Bending(const KnotVector& knots, double shortest = 0.0);

  /// Half the slope of the integral. Of a straight line at an even pace it is zero, up to rounding of the differences.
  /// @param controls  `columns` numbers for each control point, as in what is returned
  std::vector<double> slope(std::span<const double> controls, std::size_t columns) const;

  /// Integrals of products of second derivatives, by their slopes: where knots lie near each other, what is straight is
  /// not bent by rounding. Row i: of function i with itself and the next `degree` ones.
  std::vector<double> products() const;

  /// Whether products() can tell functions apart: around a period there are enough of them.
  bool has_products() const;

 private:
  std::size_t degree_;
  bool is_periodic_;
  std::size_t count_;
  ProductBand between_;
  std::array<std::vector<double>, 2> steps_;
};

}  // namespace splinecore
#pragma GCC visibility pop
