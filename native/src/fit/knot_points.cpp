#include "knot_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <memory_resource>

#include "base/call_memory.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kEnd = 2;  // rows at each end
constexpr std::size_t kFewestRows = 16;
constexpr std::size_t kFewest = 2 * kFewestRows;

/// Whether a row says where the first control point is, or where the last one.
bool is_point(const EndRow& row, std::size_t which) {
  for (std::size_t k = 0; k < row.functions.size(); ++k) {
    if (row.functions[k] != (k == which ? 1.0 : 0.0)) return false;
  }
  return row.order == 0;
}

bool are_at_knots(const NearPoints& system) {
  if (system.degree != 3 || system.start.size() != kEnd || system.end.size() != kEnd) return false;
  const std::size_t inner = system.points.size();
  return inner >= kFewest && is_point(system.start.front(), 0) && is_point(system.end.back(), 3) &&
         std::memcmp(system.parameters.data(), &system.knots[4], inner * sizeof(double)) == 0;
}

TridiagonalRows moved(const TridiagonalRows& rows, std::ptrdiff_t by) {
  return {rows.before + by, rows.at + by, rows.after + by};
}

/// So many rows of one after the other: to make them again takes less time than to keep more of them.
class KnotRowBlock {
 public:
  static constexpr std::size_t kMost = 256;

  /// Rows first … first + count - 1 of points, and where they are few those before them, too.
  TridiagonalRows write(const NearPoints& system, std::size_t first, std::size_t count) {
    breathe(32 * kMost);
    const std::size_t before = count < kFewestRows ? kFewestRows - count : 0;
    const TridiagonalRows all = from(0);
    kernels().knot_rows(&system.knots[4 + first - before], count + before, all);
    return from(before);
  }

 private:
  TridiagonalRows from(std::size_t i) { return {&numbers_[i], &numbers_[i + kMost], &numbers_[i + 2 * kMost]}; }

  alignas(64) std::array<double, 3 * kMost> numbers_;
};

class KnotSystem {
 public:
  explicit KnotSystem(const NearPoints& given)
      : given_(given), inner_(given.points.size()), count_(inner_ + 2 * kEnd), factors_(numbers(count_)), points_(count_) {
    if (inner_ > kMostKept) return;
    rows_ = {numbers(inner_), numbers(inner_), numbers(inner_)};
    kernels().knot_rows(&given_.knots[4], inner_, rows_);
  }

  std::optional<NearSolution> solution() {
    eliminate();
    substitute();
    const double error = largest_distance();
    if (!std::isfinite(error)) return {};
    return NearSolution{std::move(points_), error};
  }

 private:
  static constexpr std::size_t kMostKept = 2048;  // rows

  double* numbers(std::size_t count) { return std::pmr::polymorphic_allocator<double>(memory_.resource()).allocate(count); }

  /// Of points; those that are not kept are written into the block.
  TridiagonalRows rows(KnotRowBlock& block, std::size_t first, std::size_t count) const {
    if (inner_ > kMostKept) return block.write(given_, first, count);
    return moved(rows_, static_cast<std::ptrdiff_t>(first));
  }

  void eliminate() {
    points_.front() = {given_.start.front().value, 1.0};
    points_.back() = {given_.end.back().value, 1.0};
    factors_[0] = factors_[count_ - 1] = 0.0;
    KnotRowBlock at_start;
    KnotRowBlock at_end;
    const std::size_t half = inner_ / 2;
    for (std::size_t i = 0; i < half; i += KnotRowBlock::kMost) {
      const std::size_t count = std::min(KnotRowBlock::kMost, half - i);
      const std::size_t last = inner_ - 1 - i;
      const TridiagonalRows low = rows(at_start, i, count);
      const TridiagonalRows high = moved(rows(at_end, last + 1 - count, count), count - 1);
      if (i == 0) take_start(low);
      if (i == 0) take_end(high);
      kernels().eliminate(end_at(low, i), end_at(high, last), count);
    }
    if (inner_ % 2 == 0) return;
    const TridiagonalRows middle = rows(at_start, half, 1);
    take_after(half + kEnd, *middle.before, *middle.at, *middle.after, given_.points[half]);
  }

  TridiagonalEnd end_at(const TridiagonalRows& rows, std::size_t i) {
    return {rows, &given_.points[i].x, &factors_[i + kEnd], &points_[i + kEnd].x};
  }

  /// Takes the second row, which four functions may be in: a multiple of the next one is taken away.
  void take_start(const TridiagonalRows& next) {
    const std::vector<double>& row = given_.start.back().functions;
    const double share = row[3] / *next.after;
    take_after(1, row[0], row[1] - share * *next.before, row[2] - share * *next.at,
               given_.start.back().value - share * given_.points.front());
  }

  void take_end(const TridiagonalRows& next) {
    const std::vector<double>& row = given_.end.front().functions;
    const double share = row[0] / *next.before;
    take_before(count_ - kEnd, row[1] - share * *next.at, row[2] - share * *next.after, row[3],
                given_.end.front().value - share * given_.points.back());
  }

  void take_after(std::size_t i, double before, double at, double after, const glm::dvec3& value) {
    const double inverse = 1.0 / (at - before * factors_[i - 1]);
    factors_[i] = after * inverse;
    points_[i] = {inverse * (value - before * glm::dvec3(points_[i - 1])), 1.0};
  }

  void take_before(std::size_t i, double before, double at, double after, const glm::dvec3& value) {
    const double inverse = 1.0 / (at - after * factors_[i + 1]);
    factors_[i] = before * inverse;
    points_[i] = {inverse * (value - after * glm::dvec3(points_[i + 1])), 1.0};
  }

  /// The last row that was taken from the start and the first from the end hold two points.
  void substitute() {
    const std::size_t middle = kEnd + inner_ - inner_ / 2;
    const double low = factors_[middle - 1];
    const double high = factors_[middle];
    glm::dvec4& before = points_[middle - 1];
    glm::dvec4& after = points_[middle];
    after = {(glm::dvec3(after) - high * glm::dvec3(before)) / (1.0 - high * low), 1.0};
    before = {glm::dvec3(before) - low * glm::dvec3(after), 1.0};
    kernels().substitute(&factors_[middle], &after.x, kEnd + inner_ / 2 - 1);
  }

  double largest_distance() const {
    const double scale = scale_of_distances(given_.largest);
    double square = 0.0;
    KnotRowBlock block;
    for (std::size_t i = 0; i < inner_; i += KnotRowBlock::kMost) {
      const std::size_t count = std::min(KnotRowBlock::kMost, inner_ - i);
      // Few rows are looked at together with those before them.
      const std::size_t more = count < kernels().lanes ? kernels().lanes - count : 0;
      const TridiagonalRows some = moved(rows(block, i, count), -static_cast<std::ptrdiff_t>(more));
      const double found = kernels().largest_left(some, count + more, &points_[i + kEnd - more].x,
                                                  &given_.points[i - more].x, scale);
      square = std::max(square, found);
    }
    const auto compare = [&](const EndRow& row, const glm::dvec4* first) {
      glm::dvec3 left = row.value;
      for (std::size_t k = 0; k < row.functions.size(); ++k) left -= row.functions[k] * glm::dvec3(first[k]);
      left *= scale;
      if (row.order == 0) square = std::max(square, glm::dot(left, left));
    };
    for (const EndRow& row : given_.start) compare(row, points_.data());
    for (const EndRow& row : given_.end) compare(row, &points_[count_ - 4]);
    return std::sqrt(square) / scale;
  }

  const NearPoints& given_;
  std::size_t inner_;
  std::size_t count_;
  CallMemory memory_;
  double* factors_;
  TridiagonalRows rows_{};  ///< of all points, where they are few
  std::vector<glm::dvec4> points_;
};

}  // namespace

std::optional<NearSolution> solve_at_knots(const NearPoints& system) {
  if (!are_at_knots(system)) return {};
  return KnotSystem(system).solution();
}

}  // namespace splinecore
