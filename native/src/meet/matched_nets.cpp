#include "matched_nets.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

using Net = BernsteinNet<glm::dvec4>;

/// Control points times their binomials.
std::vector<glm::dvec4> scaled(const Net& net) {
  std::vector<glm::dvec4> found;
  found.reserve(net.values.size());
  const int p = static_cast<int>(net.rows) - 1;
  const int q = static_cast<int>(net.columns) - 1;
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= q; ++j) {
      found.push_back(binomial(p, i) * binomial(q, j) * net.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
    }
  }
  return found;
}

double least_weight(const Net& net) {
  const auto [low, high] = net.range([](const glm::dvec4& h) { return std::abs(h.w); });
  return low;
}

/// A bound of how far points are apart.
double largest_gap(const Net& a, const Net& b) {
  breathe(8 * a.values.size() * b.values.size());
  const std::size_t rows = a.rows + b.rows - 1;
  const std::size_t columns = a.columns + b.columns - 1;
  const std::vector<glm::dvec4> of_a = scaled(a);
  const std::vector<glm::dvec4> of_b = scaled(b);
  std::vector<glm::dvec3> sums(rows * columns, glm::dvec3(0.0));
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < a.columns; ++j) {
      const glm::dvec4& one = of_a[i * a.columns + j];
      for (std::size_t k = 0; k < b.rows; ++k) {
        for (std::size_t l = 0; l < b.columns; ++l) {
          const glm::dvec4& other = of_b[k * b.columns + l];
          sums[(i + k) * columns + j + l] += other.w * glm::dvec3(one) - one.w * glm::dvec3(other);
        }
      }
    }
  }
  double most = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double choices = binomial(static_cast<int>(rows) - 1, static_cast<int>(i)) *
                             binomial(static_cast<int>(columns) - 1, static_cast<int>(j));
      most = std::max(most, glm::length(sums[i * columns + j]) / choices);
    }
  }
  return most / (least_weight(a) * least_weight(b));
}

class GapSearch {
 public:
  explicit GapSearch(double distance) : distance_(distance) {}

  bool is_within(const Net& a, const Net& b, int depth) const {
    constexpr int kDeepest = 5;
    if (!has_one_sign(a.values, &glm::dvec4::w) || !has_one_sign(b.values, &glm::dvec4::w)) return false;
    if (largest_gap(a, b) <= distance_) return true;
    const std::array<glm::dvec4, 4> of_a = a.corners();
    const std::array<glm::dvec4, 4> of_b = b.corners();
    for (std::size_t i = 0; i < 4; ++i) {
      if (glm::distance(project(of_a[i]), project(of_b[i])) > distance_) return false;
    }
    if (depth == kDeepest) return false;
    const Axis axis = depth % 2 == 0 ? Axis::u : Axis::v;
    Net first_a = a;
    Net first_b = b;
    Net second_a;
    Net second_b;
    first_a.halve(axis, second_a);
    first_b.halve(axis, second_b);
    return is_within(first_a, first_b, depth + 1) && is_within(second_a, second_b, depth + 1);
  }

 private:
  double distance_;
};

}  // namespace

Net turned(const Net& net, bool is_exchanged, bool is_u_reversed, bool is_v_reversed) {
  Net found{is_exchanged ? net.columns : net.rows, is_exchanged ? net.rows : net.columns, {}};
  found.values.reserve(net.values.size());
  for (std::size_t i = 0; i < found.rows; ++i) {
    for (std::size_t j = 0; j < found.columns; ++j) {
      const std::size_t row = is_u_reversed ? found.rows - 1 - i : i;
      const std::size_t column = is_v_reversed ? found.columns - 1 - j : j;
      found.values.push_back(is_exchanged ? net.at(column, row) : net.at(row, column));
    }
  }
  return found;
}

bool are_within(const Net& a, const Net& b, double distance) { return GapSearch(distance).is_within(a, b, 0); }

}  // namespace splinecore
