#pragma once

#include <algorithm>
#include <array>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Functions of a degree at parameters of which one lies near each control point, as rows of a band matrix: row i is for
/// a parameter from knot i + 1 on and before knot i + degree. Of kBlock rows at a time the steps between knots are
/// divided out once, for functions share them.
template <int kDegree>
class PointRows {
 public:
  static constexpr int kReach = kDegree - 1;
  static constexpr int kWidth = 2 * kReach + 1;
  static constexpr long kBlock = 64;

  /// @param knots  that are kept: kDegree + 1 more than `count`
  PointRows(const double* knots, long count) : knots_(knots), count_(count) {}

  /// Before rows begin … begin + kBlock - 1 are written.
  void prepare(long begin) {
    begin_ = begin;
    for (int level = 1; level <= kDegree; ++level) {
      const long first = std::max(begin + 1, level - 1L);
      const long last = std::min(begin + kBlock + 2 * kDegree - 3, count_ + kDegree - 1);
      double* const steps = steps_[level - 1].data() - begin - 1;
      for (long k = first; k <= last; ++k) steps[k] = 1.0 / (knots_[k + 1] - knots_[k + 1 - level]);
    }
  }

  /// Writes the kDegree + 1 functions that are not zero (The NURBS Book, A2.2).
  /// @returns how far behind i - kReach the first of them is
  int functions(long i, double u, double* out) const {
    const double* const near = knots_ + i;
    int later = 0;
    for (int k = 2; k < kDegree; ++k) later += u >= near[k] ? 1 : 0;
    const double* const start = near + 1 + later;
    out[0] = 1.0;
    for (int level = 1; level <= kDegree; ++level) {
      const double* const steps = steps_[level - 1].data() + (i - begin_ + later);
      double carried = 0.0;
      for (int r = 0; r < level; ++r) {
        const double share = out[r] * steps[r];
        out[r] = carried + share * (start[1 + r] - u);
        carried = share * (u - start[1 - level + r]);
      }
      out[level] = carried;
    }
    return later;
  }

  /// Writes kWidth numbers, from column i - kReach on. Where they begin is decided by products, for branches would be
  /// as good as random.
  /// @returns whether the parameter lies where it should
  bool write(long i, double u, double* row) const {
    functions(i, u, row);
    for (int j = kDegree + 1; j < kWidth; ++j) row[j] = 0.0;
    const double* const near = knots_ + i;
    for (int k = 2; k < kDegree; ++k) {
      const double later = u >= near[k] ? 1.0 : 0.0;
      for (int j = kDegree + k - 1; j > 0; --j) row[j] = later * row[j - 1] + (1.0 - later) * row[j];
      row[0] *= 1.0 - later;
    }
    return near[1] <= u && u < near[kDegree];
  }

 private:
  const double* knots_;
  long count_;
  long begin_ = 0;
  std::array<std::array<double, kBlock + 2 * kDegree>, kDegree> steps_{};
};

}  // namespace splinecore
#pragma GCC visibility pop
