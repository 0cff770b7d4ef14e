#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "kernels/kernels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point, what it is minus a given one, and derivatives by the parameters of a piece.
template <int kAxes>
struct Slopes {
  glm::dvec3 point;
  glm::dvec3 offset;
  std::array<glm::dvec3, kAxes> first;
  std::array<glm::dvec3, kAxes == 1 ? 1 : 3> second;  ///< uu, vv, uv
};

/// A derivative of a quotient from that of the numerator, less what the lower ones take away.
inline glm::dvec3 quotient_slope(const glm::dvec4& h, const glm::dvec3& point, double inverse) noexcept {
  return (glm::dvec3(h) - h.w * point) * inverse;
}

/// Of a piece of so many homogeneous control points along u and v; a curve has one column.
template <int kAxes>
Slopes<kAxes> slopes_of(const Kernels& kernels, const glm::dvec4* net, std::size_t rows, std::size_t columns,
                        const std::array<double, kAxes>& at, const glm::dvec3& from) noexcept {
  std::array<glm::dvec4, kAxes == 1 ? 3 : 6> h;
  kernels.piece_slopes({static_cast<int>(rows), static_cast<int>(columns), &net->x}, at.data(), &h[0].x);
  const double inverse = 1.0 / h[0].w;
  const glm::dvec3 point = glm::dvec3(h[0]) * inverse;
  Slopes<kAxes> found;
  found.point = point;
  found.offset = point - from;
  const glm::dvec3 u = quotient_slope(h[1], point, inverse);
  const glm::dvec3 uu = quotient_slope(h[2], point, inverse) - (2.0 * h[1].w * inverse) * u;
  if constexpr (kAxes == 1) {
    found.first = {u};
    found.second = {uu};
  } else {
    const glm::dvec3 v = quotient_slope(h[3], point, inverse);
    found.first = {u, v};
    found.second = {uu, quotient_slope(h[5], point, inverse) - (2.0 * h[3].w * inverse) * v,
                    quotient_slope(h[4], point, inverse) - inverse * (h[1].w * v + h[3].w * u)};
  }
  return found;
}

}  // namespace splinecore
#pragma GCC visibility pop
