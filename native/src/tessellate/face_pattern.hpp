#pragma once

#include <array>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The faces of a rectangle with more vertices on its sides: quads as far as they go, triangles elsewhere.
///
/// @param corners  counter-clockwise
/// @param inside   of the sides from each corner to the next, in this order
/// @param middle   a vertex that is used where no other pattern fits
/// @param add      takes the corners of each face, three or four
template <class Spot, class Add>
void face_pattern(const std::array<Spot, 4>& corners, const std::array<std::span<const Spot>, 4>& inside,
                  const Spot& middle, Add add) {
  std::array<int, 4> has{};
  int count = 0;
  bool is_simple = true;
  for (int k = 0; k < 4; ++k) {
    has[k] = inside[k].empty() ? 0 : 1;
    count += has[k];
    is_simple = is_simple && inside[k].size() < 2;
  }
  const auto triangle = [&](const Spot& a, const Spot& b, const Spot& c) { add(std::array{a, b, c}); };
  const auto quad = [&](const Spot& a, const Spot& b, const Spot& c, const Spot& d) { add(std::array{a, b, c, d}); };
  if (is_simple && count == 0) return quad(corners[0], corners[1], corners[2], corners[3]);
  for (int k = 0; is_simple && k < 4; ++k) {
    const auto c = [&](int i) { return corners[(k + i) % 4]; };
    const auto h = [&](int i) { return inside[(k + i) % 4].front(); };
    const std::array<int, 4> now{has[k], has[(k + 1) % 4], has[(k + 2) % 4], has[(k + 3) % 4]};
    if (now == std::array{1, 0, 0, 0}) {
      triangle(c(0), h(0), c(3));
      triangle(h(0), c(2), c(3));
      return triangle(h(0), c(1), c(2));
    }
    if (now == std::array{1, 0, 1, 0}) {
      quad(c(0), h(0), h(2), c(3));
      return quad(h(0), c(1), c(2), h(2));
    }
    if (now == std::array{1, 1, 0, 0}) {
      quad(c(0), h(0), h(1), c(3));
      triangle(h(0), c(1), h(1));
      return triangle(h(1), c(2), c(3));
    }
    if (now == std::array{1, 1, 1, 0}) {
      quad(c(0), h(0), h(2), c(3));
      triangle(h(0), c(1), h(1));
      triangle(h(1), c(2), h(2));
      return triangle(h(0), h(1), h(2));
    }
  }
  Spot last = corners[0];
  const Spot first = corners[0];
  const auto step = [&](const Spot& next) {
    triangle(middle, last, next);
    last = next;
  };
  for (int k = 0; k < 4; ++k) {
    if (k > 0) step(corners[k]);
    for (const Spot& spot : inside[k]) step(spot);
  }
  step(first);
}

}  // namespace splinecore
#pragma GCC visibility pop
