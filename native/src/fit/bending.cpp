#include "bending.hpp"

#include <utility>

namespace splinecore {

Bending::Bending(const KnotVector& knots)
    : between_(difference_products(knots, 2)), steps_{difference_steps(knots, 0), difference_steps(knots, 1)} {}

std::vector<double> Bending::slope(std::span<const double> controls, std::size_t columns) const {
  std::vector<double> from(controls.begin(), controls.end());
  std::vector<double> to(from.size());
  for (const std::vector<double>& steps : steps_) {
    write_differences(steps, columns, from, to);
    std::swap(from, to);
  }
  write_products(between_, columns, from, to);
  std::swap(from, to);
  for (auto steps = steps_.rbegin(); steps != steps_.rend(); ++steps) {
    write_sums_of_differences(*steps, columns, from, to);
    std::swap(from, to);
  }
  return from;
}

}  // namespace splinecore
