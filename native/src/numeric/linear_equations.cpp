#include "linear_equations.hpp"

#include <Eigen/QR>
#include <numeric>

namespace splinecore {

namespace {

using RowsOfNumbers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowsOfNumbers> rows_of(const std::vector<double>& numbers, std::size_t width) {
  return {numbers.data(), static_cast<Eigen::Index>(numbers.size() / width), static_cast<Eigen::Index>(width)};
}

}  // namespace

void LinearEquations::add(std::span<const double> factors, std::span<const double> right, double weight) {
  for (const double factor : factors) left_.push_back(weight * factor);
  for (const double value : right) right_.push_back(weight * value);
}

/// By a complete orthogonal decomposition, with pivots; one equation by its factors, which costs no rounding where they are simple.
std::vector<double> LinearEquations::least_squares(double dependent) const {
  if (left_.size() == unknowns_) return along_factors();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(dependent);
  solver.compute(rows_of(left_, unknowns_));
  const RowsOfNumbers found = solver.solve(Eigen::MatrixXd(rows_of(right_, columns_)));
  return {found.data(), found.data() + found.size()};
}

/// The shortest solution of the only equation.
std::vector<double> LinearEquations::along_factors() const {
  const double squares = std::inner_product(left_.begin(), left_.end(), left_.begin(), 0.0);
  std::vector<double> found;
  for (const double factor : left_) {
    for (const double value : right_) found.push_back(squares > 0.0 ? factor * value / squares : 0.0);
  }
  return found;
}

}  // namespace splinecore
