#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Linear equations for a few unknowns, each of which is a number or a row of some numbers.
class LinearEquations {
 public:
  explicit LinearEquations(std::size_t unknowns, std::size_t columns = 1) : unknowns_(unknowns), columns_(columns) {}

  /// The sum of factors times unknowns is `right`; it counts as often as its weight, squared.
  void add(std::span<const double> factors, std::span<const double> right, double weight = 1.0);
  void add(std::span<const double> factors, double right, double weight = 1.0) { add(factors, std::span(&right, 1), weight); }

  /// The unknowns, one after the other, by which the sum of squares of what is left is least; of several such the shortest.
  /// @param dependent  what counts as 0 of the largest pivot: equations that nearly agree then leave their difference open
  /// @return           columns of the first unknown, of the second one, and so on
  std::vector<double> least_squares(double dependent = std::numeric_limits<double>::epsilon()) const;

 private:
  std::vector<double> along_factors() const;

  std::size_t unknowns_;
  std::size_t columns_;
  std::vector<double> left_;  ///< row by row
  std::vector<double> right_;
};

}  // namespace splinecore
#pragma GCC visibility pop
