#pragma once

#include <array>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The faces of a rectangle with more vertices on its sides: quads as far as they go, triangles elsewhere.
///
/// @param corners  counter-clockwise
/// @param inside   of the sides from each corner to the next, in this order
/// @param middle   a vertex that is used where no other pattern fits
template <class Spot>
std::vector<std::vector<Spot>> face_pattern(const std::array<Spot, 4>& corners,
                                            const std::array<std::vector<Spot>, 4>& inside, const Spot& middle) {
  std::array<int, 4> has{};
  int count = 0;
  bool is_simple = true;
  for (int k = 0; k < 4; ++k) {
    has[k] = inside[k].empty() ? 0 : 1;
    count += has[k];
    is_simple = is_simple && inside[k].size() < 2;
  }
  const auto turned = [&](int k) {
    const auto c = [&, k](int i) { return corners[(k + i) % 4]; };
    const auto h = [&, k](int i) { return inside[(k + i) % 4].front(); };
    return std::pair{c, h};
  };
  if (is_simple && count == 0) return {{corners[0], corners[1], corners[2], corners[3]}};
  for (int k = 0; is_simple && k < 4; ++k) {
    const auto [c, h] = turned(k);
    const std::array<int, 4> now{has[k], has[(k + 1) % 4], has[(k + 2) % 4], has[(k + 3) % 4]};
    if (now == std::array{1, 0, 0, 0}) return {{c(0), h(0), c(3)}, {h(0), c(2), c(3)}, {h(0), c(1), c(2)}};
    if (now == std::array{1, 0, 1, 0}) return {{c(0), h(0), h(2), c(3)}, {h(0), c(1), c(2), h(2)}};
    if (now == std::array{1, 1, 0, 0}) return {{c(0), h(0), h(1), c(3)}, {h(0), c(1), h(1)}, {h(1), c(2), c(3)}};
    if (now == std::array{1, 1, 1, 0}) {
      return {{c(0), h(0), h(2), c(3)}, {h(0), c(1), h(1)}, {h(1), c(2), h(2)}, {h(0), h(1), h(2)}};
    }
  }
  std::vector<Spot> ring;
  for (int k = 0; k < 4; ++k) {
    ring.push_back(corners[k]);
    ring.insert(ring.end(), inside[k].begin(), inside[k].end());
  }
  std::vector<std::vector<Spot>> faces;
  for (std::size_t i = 0; i < ring.size(); ++i) faces.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
  return faces;
}

}  // namespace splinecore
#pragma GCC visibility pop
