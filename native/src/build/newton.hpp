#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/double_double.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/build/polynomial.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A polynomial by divided differences: sum a_k (x - z_0) … (x - z_{k-1}), with 32 digits.
///
/// The parameter is moved to [-2, 2], an interval of capacity 1, so that products of many differences
/// neither overflow nor vanish.
class NewtonForm {
 public:
  /// @param data  at least two, of increasing parameters, with one derivative or more each
  explicit NewtonForm(std::span<const Osculation> data);

  int degree() const noexcept { return static_cast<int>(nodes_.size()) - 1; }

  glm::dvec3 value(double u) const;

  /// Bernstein coefficients on a part of the domain.
  std::vector<glm::dvec3> bernstein(Interval range) const;

 private:
  using Vector = std::array<DoubleDouble, 3>;

  DoubleDouble moved(double u) const;
  void take_differences(std::span<const Osculation* const> places);

  Interval domain_;
  std::vector<DoubleDouble> nodes_;
  std::vector<Vector> coefficients_;
};

}  // namespace splinecore
#pragma GCC visibility pop
