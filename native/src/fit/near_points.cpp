#include "near_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
  static constexpr long kFewest = 4;

  /// Rows first … end - 1, kNearRows at most; where they are few those before them, too.
  /// @returns whether their parameters lie near the knots of their control points
  bool write(const NearPoints& system, long first, long end) {
    breathe(4 * kWidth * kNearRows);
    begin_ = std::min(first, end - kFewest);
    // What lies before the first knot or behind the last is read and not taken.
    const auto count = static_cast<long>(system.knots.size());
    const auto number = static_cast<long>(knots_.size());
    const long from = begin_ - kDegree;
    if (from >= 0 && from + number <= count) {
      std::copy_n(system.knots.begin() + from, number, knots_.begin());
    } else {
      for (long k = 0; k < number; ++k) knots_[k] = system.knots[std::clamp(from + k, 0L, count - 1)];
    }
    const double* const parameters = system.parameters.data() + begin_ - static_cast<long>(system.start.size());
    return kernels().near_rows[kDegree - 2](knots_.data() + kDegree, parameters,
                                            static_cast<std::size_t>(end - begin_), rows_.data());
  }

  std::array<double, kWidth> row(long i) const {
    std::array<double, kWidth> row;
    for (int k = 0; k < kWidth; ++k) row[k] = rows_[k * kNearRows + static_cast<std::size_t>(i - begin_)];
    return row;
  }

 private:
  long begin_ = 0;
  std::array<double, kNearRows + 3 * kDegree> knots_;
  std::array<double, kNearRows * kWidth> rows_;
};

/// The work of one degree: rows 0 … middle_ - 1 are swept forward, the others backward.
template <int kDegree>
class NearSystem {
  static constexpr int kReach = NearRowBlock<kDegree>::kReach;
  static constexpr int kWidth = NearRowBlock<kDegree>::kWidth;
  static constexpr long kBlock = kNearRows;

 public:
  explicit NearSystem(const NearPoints& given)
      : given_(given), inner_(static_cast<long>(given.start.size())),
        count_(inner_ + static_cast<long>(given.points.size() + given.end.size())),
        outer_(inner_ + static_cast<long>(given.points.size())), middle_(inner_ + (outer_ - inner_) / 2),
        factors_(std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(count_ * (kReach - 1)))),
        points_(static_cast<std::size_t>(count_)) {}

  std::optional<NearSolution> solution() {
    const bool is_long = outer_ - inner_ >= std::max<long>(NearRowBlock<kDegree>::kFewest, 2 * kWidth);
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
    for (long i = 0; i < inner_; ++i) take_end(forward, i, given_.start[static_cast<std::size_t>(i)], 0);
    for (long i = count_ - 1; i >= outer_; --i) {
      take_end(backward, i, given_.end[static_cast<std::size_t>(i - outer_)], count_ - 1 - kDegree);
    }
    NearRowBlock<kDegree> early;
    NearRowBlock<kDegree> late;
    bool fit = true;
    for (long block = 0; block < outer_ - middle_; block += kBlock) {
      const long first = inner_ + block;
      const long end = std::max(std::min(first + kBlock, middle_), first);
      const long last = outer_ - 1 - block;
      const long begin = std::max(last + 1 - kBlock, middle_);
      if (first < end) fit &= early.write(given_, first, end);
      fit &= late.write(given_, begin, last + 1);
      for (long step = 0; step <= last - begin; ++step) {
        if (first + step < end) take_point(forward, early, first + step);
        take_point(backward, late, last - step);
      }
    }
    return fit;
  }

  template <class Sweep>
  void take_end(Sweep& sweep, long i, const EndRow& end, long first) {
    std::array<double, 3 * kWidth> row{};
    std::ranges::copy(end.functions, row.begin() + kWidth + (first - i + kReach));
    sweep.take(row.data() + kWidth, end.value, factors(i), points_[static_cast<std::size_t>(i)]);
  }

  template <class Sweep>
  void take_point(Sweep& sweep, const NearRowBlock<kDegree>& rows, long i) {
    const std::array<double, kWidth> row = rows.row(i);
    sweep.take(row.data(), given_.points[static_cast<std::size_t>(i - inner_)], factors(i),
               points_[static_cast<std::size_t>(i)]);
  }

  double* factors(long i) { return factors_.get() + i * (kReach - 1); }
  double factor(long i, long j) { return j == 0 ? points_[static_cast<std::size_t>(i)].w : factors(i)[j - 1]; }

  /// Decides the points next to the middle, of which each sweep has left the other's open.
  bool meet() {
    constexpr std::size_t kNumber = 2 * kReach;
    const long first = middle_ - kReach;
    BandedRows rows{kNumber, std::vector<long>(kNumber, 0), std::vector<double>(kNumber * kNumber, 0.0)};
    std::vector<double> right(3 * kNumber);
    for (long i = 0; i < static_cast<long>(kNumber); ++i) {
      const glm::dvec4& point = points_[static_cast<std::size_t>(first + i)];
      if (!is_finite(glm::dvec3(point))) return false;
      rows.row(i)[i] = 1.0;
      for (long j = 0; j < kReach; ++j) rows.row(i)[i < kReach ? i + 1 + j : i - 1 - j] = factor(first + i, j);
      std::copy_n(&point.x, 3, &right[3 * i]);
    }
    solve_banded(rows, right, 3);
    for (std::size_t i = 0; i < kNumber; ++i) {
      points_[first + i] = {right[3 * i], right[3 * i + 1], right[3 * i + 2], 1.0};
    }
    return true;
  }

  void substitute() {
    const long steps = std::max(middle_, count_ - middle_) - kReach;
    for (long block = 0; block < steps; block += kBlock) {
      breathe(4 * kBlock * kReach);
      for (long step = block; step < std::min(block + kBlock, steps); ++step) {
        const long early = middle_ - kReach - 1 - step;
        const long late = middle_ + kReach + step;
        if (early >= 0) substitute<1>(early);
        if (late < count_) substitute<-1>(late);
      }
    }
  }

  template <int kStep>
  void substitute(long i) {
    glm::dvec4* const point = points_.data() + i;
    glm::dvec3 value(point[0]);
    for (int j = kReach - 1; j >= 0; --j) value -= factor(i, j) * glm::dvec3(point[kStep * (j + 1)]);
    point[0] = {value, 1.0};
  }

  glm::dvec3 point_at(const double* functions, long first, long number) const {
    const glm::dvec4* const points = points_.data() + first;
    glm::dvec3 point(0.0);
    for (long j = 0; j < number; ++j) point += functions[j] * glm::dvec3(points[j]);
    return point;
  }

  glm::dvec3 point_of(const std::array<double, kWidth>& row, long i) const {
    const glm::dvec4* const points = points_.data() + (i - kReach);
    glm::dvec3 point = row[0] * glm::dvec3(points[0]);
    for (int j = 1; j < kWidth; ++j) point += row[j] * glm::dvec3(points[j]);
    return point;
  }

  /// Of a row that reaches over an end, where it is zero.
  glm::dvec3 point_near_end(const std::array<double, kWidth>& row, long i) const {
    const long first = std::max(i - kReach, 0L);
    const long last = std::min<long>(i + kReach, count_ - 1);
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
    for (long block = inner_; block < outer_; block += kBlock) {
      const long end = std::min(block + kBlock, outer_);
      rows.write(given_, block, end);
      for (long i = block; i < end; ++i) {
        const std::array<double, kWidth> row = rows.row(i);
        const bool is_whole = i >= kReach && i + kReach < count_;
        const glm::dvec3& wanted = given_.points[static_cast<std::size_t>(i - inner_)];
        compare(is_whole ? point_of(row, i) : point_near_end(row, i), wanted);
      }
    }
    return are_numbers ? std::sqrt(square) / scale : std::numeric_limits<double>::infinity();
  }

  const NearPoints& given_;
  long inner_;  ///< the first row of a point that is no end's
  long count_;
  long outer_;  ///< the row behind the last of them
  long middle_;
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
