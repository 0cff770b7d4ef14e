#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Gaussian elimination without exchanges, from one end of a band matrix that reaches kReach columns to each side.
/// Rows are taken as they are made, and of those before only what the next one needs is kept, in registers.
template <int kReach, bool kForward>
class BandSweep {
 public:
  static constexpr int kWidth = 2 * kReach + 1;

  /// Takes the next row; what is left of it is x + Σ factor[j] x[j + 1 rows ahead] = value.
  /// @param row      kWidth numbers, in the order of the columns
  /// @param point    the value and the first factor
  /// @param factors  the others
  void take(const double* row, const glm::dvec3& right, double* factors, glm::dvec4& point) {
    std::array<double, kWidth> left;
    for (int j = 0; j < kWidth; ++j) left[j] = row[kForward ? j : kWidth - 1 - j];
    glm::dvec3 value = right;
    for (int back = kReach; back >= 1; --back) {
      const double share = left[kReach - back];
      for (int j = 0; j < kReach; ++j) left[kReach - back + 1 + j] -= share * factors_[back - 1][j];
      value -= share * values_[back - 1];
    }
    for (int back = kReach - 1; back >= 1; --back) {
      factors_[back] = factors_[back - 1];
      values_[back] = values_[back - 1];
    }
    const double inverse = 1.0 / left[kReach];
    for (int j = 0; j < kReach; ++j) factors_[0][j] = left[kReach + 1 + j] * inverse;
    for (int j = 1; j < kReach; ++j) factors[j - 1] = factors_[0][j];
    values_[0] = value * inverse;
    point = {values_[0], factors_[0][0]};
  }

 private:
  std::array<std::array<double, kReach>, kReach> factors_{};  ///< of the row before, then of the one before that
  std::array<glm::dvec3, kReach> values_{};
};

}  // namespace splinecore
#pragma GCC visibility pop
