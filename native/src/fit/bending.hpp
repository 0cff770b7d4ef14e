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
  explicit Bending(const KnotVector& knots);

  /// Half the slope of the integral. Of a straight line at an even pace it is zero, up to rounding of the differences.
  /// @param controls  `columns` numbers for each control point, as in what is returned
  std::vector<double> slope(std::span<const double> controls, std::size_t columns) const;

 private:
  ProductBand between_;
  std::array<std::vector<double>, 2> steps_;
};

}  // namespace splinecore
#pragma GCC visibility pop
