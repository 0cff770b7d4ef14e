#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Products of powers of x and y up to a degree; or a derivative of them.
/// @param by  how often by x and by y
inline std::vector<double> plane_terms(int degree, const glm::dvec2& p, const std::array<int, 2>& by = {0, 0}) {
  const auto power = [](double x, int exponent, int times) {
    double value = 1.0;
    for (int k = 0; k < times; ++k) value *= exponent - k;
    for (int k = times; k < exponent; ++k) value *= x;
    return value;
  };
  std::vector<double> terms;
  terms.reserve(static_cast<std::size_t>((degree + 1) * (degree + 2) / 2));
  for (int sum = 0; sum <= degree; ++sum) {
    for (int k = 0; k <= sum; ++k) terms.push_back(power(p.x, sum - k, by[0]) * power(p.y, k, by[1]));
  }
  return terms;
}

}  // namespace splinecore
#pragma GCC visibility pop
