#include "near_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>

#include "base/quotient.hpp"
#include "basis/band_sweep.hpp"
#include "basis/banded.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/base/pause.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// So many rows of one after the other, and which they are.
template <int kDegree>
class NearRowBlock {
 public:
  static constexpr int kReach = kDegree - 1;
  static constexpr int kWidth = 2 * kReach + 1;
  static constexpr std::ptrdiff_t kFewest = 4;

  /// Rows first … end - 1, kNearRows at most; where they are few those before them, too.
  /// @returns whether their parameters lie near the knots of their control points
  bool write(const NearPoints& system, std::ptrdiff_t first, std::ptrdiff_t end) {
    breathe(4 * kWidth * kNearRows);
    begin_ = std::min(first, end - kFewest);
    // What lies before the first knot or behind the last is read and not taken.
    const auto count = static_cast<std::ptrdiff_t>(system.knots.size());
    const auto number = static_cast<std::ptrdiff_t>(knots_.size());
    const std::ptrdiff_t from = begin_ - kDegree;
    if (from >= 0 && from + number <= count) {
      std::copy_n(system.knots.begin() + from, number, knots_.begin());
    } else {
      for (std::ptrdiff_t k = 0; k < number; ++k) {
        knots_[k] = system.knots[std::clamp<std::ptrdiff_t>(from + k, 0, count - 1)];
      }
    }
    const double* const parameters = system.parameters.data() + begin_ - std::ssize(system.start);
    return kernels().near_rows[kDegree - 2](knots_.data() + kDegree, parameters,
                                            static_cast<std::size_t>(end - begin_), rows_.data());
  }

  std::array<double, kWidth> row(std::ptrdiff_t i) const {
    std::array<double, kWidth> row;
    for (int k = 0; k < kWidth; ++k) row[k] = rows_[k * kNearRows + static_cast<std::size_t>(i - begin_)];
    return row;
  }

 private:
  std::ptrdiff_t begin_ = 0;
  std::array<double, kNearRows + 3 * kDegree> knots_;
  std::array<double, kNearRows * kWidth> rows_;
};

/// The work of one degree: rows 0 … middle_ - 1 are swept forward, the others backward.
template <int kDegree>
class NearSystem {
  static constexpr int kReach = NearRowBlock<kDegree>::kReach;
  static constexpr int kWidth = NearRowBlock<kDegree>::kWidth;
  static constexpr std::ptrdiff_t kBlock = kNearRows;

 public:
  explicit NearSystem(const NearPoints& given)
      : given_(given), inner_(static_cast<std::ptrdiff_t>(given.start.size())),
        count_(inner_ + static_cast<std::ptrdiff_t>(given.points.size() + given.end.size())),
        outer_(inner_ + static_cast<std::ptrdiff_t>(given.points.size())), middle_(inner_ + (outer_ - inner_) / 2),
        factors_(std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(count_ * (kReach - 1)))),
        points_(static_cast<std::size_t>(count_)) {}

  std::optional<NearSolution> solution() {
    const bool is_long = outer_ - inner_ >= std::max<std::ptrdiff_t>(NearRowBlock<kDegree>::kFewest, 2 * kWidth);
    if (!is_long) return {};
    if (!sweep() || !meet()) return {};
    substitute();
    const double error = largest_distance();
    if (!std::isfinite(error)) return {};
    return NearSolution{std::move(points_), error};
  }

 private:
  /// @returns whether all parameters lie near the knots of their control points
  bool sweep() {
    BandSweep<kReach, true> forward;
    BandSweep<kReach, false> backward;
    for (std::ptrdiff_t i = 0; i < inner_; ++i) take_end(forward, i, given_.start[static_cast<std::size_t>(i)], 0);
    for (std::ptrdiff_t i = count_ - 1; i >= outer_; --i) {
      take_end(backward, i, given_.end[static_cast<std::size_t>(i - outer_)], count_ - 1 - kDegree);
    }
    NearRowBlock<kDegree> early;
    NearRowBlock<kDegree> late;
    bool fit = true;
    for (std::ptrdiff_t block = 0; block < outer_ - middle_; block += kBlock) {
      const std::ptrdiff_t first = inner_ + block;
      const std::ptrdiff_t end = std::max(std::min(first + kBlock, middle_), first);
      const std::ptrdiff_t last = outer_ - 1 - block;
      const std::ptrdiff_t begin = std::max(last + 1 - kBlock, middle_);
      if (first < end) fit &= early.write(given_, first, end);
      fit &= late.write(given_, begin, last + 1);
      for (std::ptrdiff_t step = 0; step <= last - begin; ++step) {
        if (first + step < end) take_point(forward, early, first + step);
        take_point(backward, late, last - step);
      }
    }
    return fit;
  }

  template <class Sweep>
  void take_end(Sweep& sweep, std::ptrdiff_t i, const EndRow& end, std::ptrdiff_t first) {
    std::array<double, 3 * kWidth> row{};
    std::ranges::copy(end.functions, row.begin() + kWidth + (first - i + kReach));
    sweep.take(row.data() + kWidth, end.value, factors(i), points_[static_cast<std::size_t>(i)]);
  }

  template <class Sweep>
  void take_point(Sweep& sweep, const NearRowBlock<kDegree>& rows, std::ptrdiff_t i) {
    const std::array<double, kWidth> row = rows.row(i);
    sweep.take(row.data(), given_.points[static_cast<std::size_t>(i - inner_)], factors(i),
               points_[static_cast<std::size_t>(i)]);
  }

  double* factors(std::ptrdiff_t i) { return factors_.get() + i * (kReach - 1); }
  double factor(std::ptrdiff_t i, std::ptrdiff_t j) {
    return j == 0 ? points_[static_cast<std::size_t>(i)].w : factors(i)[j - 1];
  }

  /// Decides the points next to the middle, of which each sweep has left the other's open.
  bool meet() {
    constexpr std::size_t kNumber = 2 * kReach;
    const std::ptrdiff_t first = middle_ - kReach;
    BandedRows rows{kNumber, std::vector<std::ptrdiff_t>(kNumber, 0), std::vector<double>(kNumber * kNumber, 0.0)};
    std::vector<double> right(3 * kNumber);
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(kNumber); ++i) {
      const glm::dvec4& point = points_[static_cast<std::size_t>(first + i)];
      if (!is_finite(glm::dvec3(point))) return false;
      rows.row(i)[i] = 1.0;
      for (std::ptrdiff_t j = 0; j < kReach; ++j) {
        rows.row(i)[i < kReach ? i + 1 + j : i - 1 - j] = factor(first + i, j);
      }
      std::copy_n(&point.x, 3, &right[3 * i]);
    }
    solve_banded(rows, right, 3);
    for (std::size_t i = 0; i < kNumber; ++i) {
      points_[first + i] = {right[3 * i], right[3 * i + 1], right[3 * i + 2], 1.0};
    }
    return true;
  }

  void substitute() {
    const std::ptrdiff_t steps = std::max(middle_, count_ - middle_) - kReach;
    for (std::ptrdiff_t block = 0; block < steps; block += kBlock) {
      breathe(4 * kBlock * kReach);
      for (std::ptrdiff_t step = block; step < std::min(block + kBlock, steps); ++step) {
        const std::ptrdiff_t early = middle_ - kReach - 1 - step;
        const std::ptrdiff_t late = middle_ + kReach + step;
        if (early >= 0) substitute<1>(early);
        if (late < count_) substitute<-1>(late);
      }
    }
  }

  template <int kStep>
  void substitute(std::ptrdiff_t i) {
    glm::dvec4* const point = points_.data() + i;
    glm::dvec3 value(point[0]);
    for (int j = kReach - 1; j >= 0; --j) value -= factor(i, j) * glm::dvec3(point[kStep * (j + 1)]);
    point[0] = {value, 1.0};
  }

  glm::dvec3 point_at(const double* functions, std::ptrdiff_t first, std::ptrdiff_t number) const {
    const glm::dvec4* const points = points_.data() + first;
    glm::dvec3 point(0.0);
    for (std::ptrdiff_t j = 0; j < number; ++j) point += functions[j] * glm::dvec3(points[j]);
    return point;
  }

  glm::dvec3 point_of(const std::array<double, kWidth>& row, std::ptrdiff_t i) const {
    const glm::dvec4* const points = points_.data() + (i - kReach);
    glm::dvec3 point = row[0] * glm::dvec3(points[0]);
    for (int j = 1; j < kWidth; ++j) point += row[j] * glm::dvec3(points[j]);
    return point;
  }

  /// Of a row that reaches over an end, where it is zero.
  glm::dvec3 point_near_end(const std::array<double, kWidth>& row, std::ptrdiff_t i) const {
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(i - kReach, 0);
    const std::ptrdiff_t last = std::min<std::ptrdiff_t>(i + kReach, count_ - 1);
    return point_at(row.data() + (first - i + kReach), first, last + 1 - first);
  }

  double largest_distance() const {
    const double scale = scale_of_distances(given_.largest);
    double square = 0.0;
    bool are_numbers = true;
    const auto compare = [&](const glm::dvec3& point, const glm::dvec3& wanted) {
      const glm::dvec3 left = scale * (point - wanted);
      const double found = left.x * left.x + left.y * left.y + left.z * left.z;
      are_numbers &= found < std::numeric_limits<double>::infinity();
      square = std::max(square, found);
    };
    for (const EndRow& row : given_.start) {
      if (row.order == 0) compare(point_at(row.functions.data(), 0, kDegree + 1), row.value);
    }
    for (const EndRow& row : given_.end) {
      if (row.order == 0) compare(point_at(row.functions.data(), count_ - 1 - kDegree, kDegree + 1), row.value);
    }
    NearRowBlock<kDegree> rows;
    for (std::ptrdiff_t block = inner_; block < outer_; block += kBlock) {
      const std::ptrdiff_t end = std::min(block + kBlock, outer_);
      rows.write(given_, block, end);
      for (std::ptrdiff_t i = block; i < end; ++i) {
        const std::array<double, kWidth> row = rows.row(i);
        const bool is_whole = i >= kReach && i + kReach < count_;
        const glm::dvec3& wanted = given_.points[static_cast<std::size_t>(i - inner_)];
        compare(is_whole ? point_of(row, i) : point_near_end(row, i), wanted);
      }
    }
    return are_numbers ? std::sqrt(square) / scale : std::numeric_limits<double>::infinity();
  }

  const NearPoints& given_;
  std::ptrdiff_t inner_;  ///< the first row of a point that is no end's
  std::ptrdiff_t count_;
  std::ptrdiff_t outer_;  ///< the row behind the last of them
  std::ptrdiff_t middle_;
  std::unique_ptr<double[]> factors_;  ///< of each row but the first, which stands with its point
  std::vector<glm::dvec4> points_;
};

template <int kDegree>
std::optional<NearSolution> solve_degree(const NearPoints& system) {
  return NearSystem<kDegree>(system).solution();
}

}  // namespace

double scale_of_distances(double largest) {
  return largest > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
}

std::optional<NearSolution> solve_near(const NearPoints& system) {
  switch (system.degree) {
    case 2: return solve_degree<2>(system);
    case 3: return solve_degree<3>(system);
    case 4: return solve_degree<4>(system);
    case 5: return solve_degree<5>(system);
    case 6: return solve_degree<6>(system);
    case 7: return solve_degree<7>(system);
    case 8: return solve_degree<8>(system);
    case 9: return solve_degree<9>(system);
    default: return {};
  }
}

}  // namespace splinecore
