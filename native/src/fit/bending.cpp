#include "bending.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace splinecore {

Bending::Bending(const KnotVector& knots, double shortest)
    : degree_(static_cast<std::size_t>(knots.degree())), is_periodic_(knots.periodic()),
      count_(static_cast<std::size_t>(knots.count())), between_(difference_products_from(knots, 2, shortest)),
      steps_{difference_steps(knots, 0), difference_steps(knots, 1)} {}

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

bool Bending::has_products() const { return !is_periodic_ || count_ > 2 * degree_; }

std::vector<double> Bending::products() const {
  // Functions of one column are so far from each other that they have no other in common.
  const std::size_t rounds = std::max<std::size_t>(1, count_ / (2 * degree_ + 1));
  const auto begin = [&](std::size_t round) { return round * count_ / rounds; };
  std::vector<std::size_t> column(count_);
  std::size_t columns = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t i = begin(round); i < begin(round + 1); ++i) column[i] = i - begin(round);
    columns = std::max(columns, begin(round + 1) - begin(round));
  }
  std::vector<double> units(count_ * columns, 0.0);
  for (std::size_t i = 0; i < count_; ++i) units[i * columns + column[i]] = 1.0;
  const std::vector<double> found = slope(units, columns);
  std::vector<double> rows(count_ * (degree_ + 1), 0.0);
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t k = 0; k <= degree_ && (is_periodic_ || i + k < count_); ++k) {
      rows[i * (degree_ + 1) + k] = found[i * columns + column[(i + k) % count_]];
    }
  }
  return rows;
}

}  // namespace splinecore
