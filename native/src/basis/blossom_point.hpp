#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <glm/vec4.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A homogeneous point while it is computed with: two numbers at a time.
struct PairedPoint {
  using Pair = double __attribute__((vector_size(2 * sizeof(double))));
  Pair xy;
  Pair zw;

  static PairedPoint of(const glm::dvec4& point) noexcept {
    PairedPoint made;
    std::memcpy(&made, &point.x, sizeof made);
    return made;
  }

  glm::dvec4 point() const noexcept { return {xy[0], xy[1], zw[0], zw[1]}; }

  friend PairedPoint operator*(double share, const PairedPoint& p) noexcept {
    const Pair both{share, share};
    return {both * p.xy, both * p.zw};
  }
  friend PairedPoint operator+(const PairedPoint& a, const PairedPoint& b) noexcept {
    return {a.xy + b.xy, a.zw + b.zw};
  }
};

/// A point of the line between two. Each share is divided out by itself: that of the farther one keeps its digits.
inline PairedPoint between(const PairedPoint& a, const PairedPoint& b, double low, double high, double u) noexcept {
  const PairedPoint::Pair ways{high - u, u - low};
  const PairedPoint::Pair width{high - low, high - low};
  const PairedPoint::Pair shares = ways / width;
  return shares[0] * a + shares[1] * b;
}

/// The blossom whose weights blossom_weights() tells, of the points themselves.
/// @param points   number + 1 of them, from the one whose knots are t[1] … t[degree]
/// @param scratch  room for as many, where there are more than two arguments
inline PairedPoint blossom_point(const double* t, int degree, const double* arguments, int number,
                                 const glm::dvec4* points, PairedPoint* scratch) noexcept {
  const double* const high = t + degree + 1;
  const PairedPoint first = PairedPoint::of(points[0]);
  if (number == 0) return first;
  const PairedPoint second = PairedPoint::of(points[1]);
  if (number == 1) return between(first, second, t[1], high[0], arguments[0]);
  if (number == 2) {
    const double u = arguments[1];
    return between(between(first, second, t[1], high[0], u),
                   between(second, PairedPoint::of(points[2]), t[2], high[1], u), t[2], high[0], arguments[0]);
  }
  std::transform(points, points + number + 1, scratch, PairedPoint::of);
  for (int level = number; level >= 1; --level) {
    const double* const low = t + number - level + 1;
    for (int r = 0; r < level; ++r) {
      scratch[r] = between(scratch[r], scratch[r + 1], low[r], high[r], arguments[level - 1]);
    }
  }
  return scratch[0];
}

}  // namespace splinecore
#pragma GCC visibility pop
