#include "linear_equations.hpp"

#include <Eigen/QR>

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

/// By a complete orthogonal decomposition, with pivots.
std::vector<double> LinearEquations::least_squares(double dependent) const {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(dependent);
  solver.compute(rows_of(left_, unknowns_));
  const RowsOfNumbers found = solver.solve(Eigen::MatrixXd(rows_of(right_, columns_)));
  return {found.data(), found.data() + found.size()};
}

}  // namespace splinecore
