#pragma once

#include <Eigen/Core>
#include <array>
#include <glm/vec2.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Products of powers of x and y up to a degree, as a row; or a derivative of them.
/// @param by  how often by x and by y
inline Eigen::RowVectorXd plane_terms(int degree, const glm::dvec2& p, const std::array<int, 2>& by = {0, 0}) {
  const auto power = [](double x, int exponent, int times) {
    double value = 1.0;
    for (int k = 0; k < times; ++k) value *= exponent - k;
    for (int k = times; k < exponent; ++k) value *= x;
    return value;
  };
  Eigen::RowVectorXd terms((degree + 1) * (degree + 2) / 2);
  Eigen::Index next = 0;
  for (int sum = 0; sum <= degree; ++sum) {
    for (int k = 0; k <= sum; ++k) terms[next++] = power(p.x, sum - k, by[0]) * power(p.y, k, by[1]);
  }
  return terms;
}

}  // namespace splinecore
#pragma GCC visibility pop
