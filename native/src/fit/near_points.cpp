#include "near_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/quotient.hpp"
#include "basis/band_sweep.hpp"
#include "basis/banded.hpp"
#include "point_rows.hpp"
#include "splinecore/base/pause.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// The work of one degree: rows 0 … middle_ - 1 are swept forward, the others backward.
template <int kDegree>
class NearSystem {
  static constexpr int kReach = PointRows<kDegree>::kReach;
  static constexpr int kWidth = PointRows<kDegree>::kWidth;
  static constexpr long kBlock = PointRows<kDegree>::kBlock;

 public:
  explicit NearSystem(const NearPoints& given)
      : given_(given), inner_(static_cast<long>(given.start.size())),
        count_(inner_ + static_cast<long>(given.points.size() + given.end.size())),
        outer_(inner_ + static_cast<long>(given.points.size())), middle_(inner_ + (outer_ - inner_) / 2),
        factors_(std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(count_ * kReach))),
        points_(static_cast<std::size_t>(count_)) {}

  std::optional<NearSolution> solution() {
    if (middle_ < kReach || count_ - middle_ < kReach) return {};
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
    PointRows<kDegree> early(given_.knots.data(), count_);
    PointRows<kDegree> late(given_.knots.data(), count_);
    bool fit = true;
    const long steps = middle_ - inner_;
    for (long block = 0; block < steps; block += kBlock) {
      breathe(8 * kBlock * kWidth * kReach);
      early.prepare(inner_ + block);
      late.prepare(outer_ - block - kBlock);
      const long end = std::min(block + kBlock, steps);
      for (long step = block; step < end; ++step) {
        fit &= take_point(forward, early, inner_ + step);
        fit &= take_point(backward, late, outer_ - 1 - step);
      }
    }
    if (outer_ - middle_ > steps) {
      late.prepare(middle_);
      fit &= take_point(backward, late, middle_);
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
  bool take_point(Sweep& sweep, const PointRows<kDegree>& rows, long i) {
    std::array<double, kWidth> row;
    const auto point = static_cast<std::size_t>(i - inner_);
    const bool fits = rows.write(i, given_.parameters[point], row.data());
    sweep.take(row.data(), given_.points[point], factors(i), points_[static_cast<std::size_t>(i)]);
    return fits;
  }

  double* factors(long i) { return factors_.get() + i * kReach; }

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
      for (long j = 0; j < kReach; ++j) rows.row(i)[i < kReach ? i + 1 + j : i - 1 - j] = factors(first + i)[j];
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
    for (int j = kReach - 1; j >= 0; --j) value -= factors(i)[j] * glm::dvec3(point[kStep * (j + 1)]);
    point[0] = {value, 1.0};
  }

  double largest_distance() const {
    // Squares stay in the range of numbers beside those of the largest coordinate.
    const double largest = given_.largest;
    const double scale = largest > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
    double square = 0.0;
    bool are_numbers = true;
    const auto take = [&](const double* functions, int number, long first, const glm::dvec3& wanted) {
      glm::dvec3 left = wanted;
      for (int j = 0; j < number; ++j) left -= functions[j] * glm::dvec3(points_[static_cast<std::size_t>(first + j)]);
      left *= scale;
      const double found = left.x * left.x + left.y * left.y + left.z * left.z;
      are_numbers &= found < std::numeric_limits<double>::infinity();
      square = std::max(square, found);
    };
    for (const EndRow& row : given_.start) {
      if (row.order == 0) take(row.functions.data(), kDegree + 1, 0, row.value);
    }
    for (const EndRow& row : given_.end) {
      if (row.order == 0) take(row.functions.data(), kDegree + 1, count_ - 1 - kDegree, row.value);
    }
    PointRows<kDegree> rows(given_.knots.data(), count_);
    for (long block = inner_; block < outer_; block += kBlock) {
      breathe(4 * kBlock * kWidth);
      rows.prepare(block);
      for (long i = block; i < std::min(block + kBlock, outer_); ++i) {
        const auto point = static_cast<std::size_t>(i - inner_);
        std::array<double, kDegree + 1> functions;
        const int later = rows.functions(i, given_.parameters[point], functions.data());
        take(functions.data(), kDegree + 1, i - kReach + later, given_.points[point]);
      }
    }
    return are_numbers ? std::sqrt(square) / scale : std::numeric_limits<double>::infinity();
  }

  const NearPoints& given_;
  long inner_;  ///< the first row of a point that is no end's
  long count_;
  long outer_;  ///< the row behind the last of them
  long middle_;
  std::unique_ptr<double[]> factors_;
  std::vector<glm::dvec4> points_;
};

template <int kDegree>
std::optional<NearSolution> solve_degree(const NearPoints& system) {
  return NearSystem<kDegree>(system).solution();
}

}  // namespace

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
