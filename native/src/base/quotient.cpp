#include "quotient.hpp"

#include <cmath>

namespace splinecore {

namespace {

/// C(n, k) as a running product: exact for n <= kMaxOrder up to a few ulp.
double choose(int n, int k) noexcept {
  double value = 1.0;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

}  // namespace

bool is_finite(const glm::dvec3& p) noexcept {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void quotient_derivatives(std::span<const glm::dvec4> homogeneous, std::span<glm::dvec3> out) noexcept {
  const double weight = homogeneous[0].w;
  for (std::size_t k = 0; k < homogeneous.size(); ++k) {
    glm::dvec3 value(homogeneous[k]);
    for (std::size_t i = 1; i <= k; ++i) {
      value -= choose(static_cast<int>(k), static_cast<int>(i)) * homogeneous[i].w * out[k - i];
    }
    out[k] = value / weight;
  }
}

void quotient_derivatives(std::span<const glm::dvec4> homogeneous, int order,
                          std::span<glm::dvec3> out) noexcept {
  const int width = order + 1;
  const double weight = homogeneous[0].w;
  for (int k = 0; k <= order; ++k) {
    for (int l = 0; l <= order; ++l) {
      glm::dvec3 value(homogeneous[k * width + l]);
      for (int i = 0; i <= k; ++i) {
        for (int j = i == 0 ? 1 : 0; j <= l; ++j) {
          value -= choose(k, i) * choose(l, j) * homogeneous[i * width + j].w *
                   out[(k - i) * width + (l - j)];
        }
      }
      out[k * width + l] = value / weight;
    }
  }
}

}  // namespace splinecore
