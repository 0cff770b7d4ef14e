#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Scaled parameters nearer than this are one.
inline constexpr double kOneStep = 1e-9;

/// A face between two lines of vertices: from i to i_end of the outer, back from j_end to j of the inner one.
struct StripFace {
  std::size_t i, i_end;
  std::size_t j, j_end;
};

/// The faces between two lines at growing parameters: quads where both have the same steps, else triangles with the
/// shorter of two diagonals.
inline std::vector<StripFace> strip_faces(std::span<const double> outer, std::span<const double> inner) {
  std::vector<StripFace> faces;
  const auto apart = [&](std::size_t i, std::size_t j) { return std::abs(outer[i] - inner[j]); };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i + 1 < outer.size() || j + 1 < inner.size()) {
    const bool can_i = i + 1 < outer.size();
    const bool can_j = j + 1 < inner.size();
    const bool is_quad = can_i && can_j && apart(i, j) <= kOneStep && apart(i + 1, j + 1) <= kOneStep;
    const bool is_outer = is_quad || !can_j || (can_i && apart(i + 1, j) <= apart(i, j + 1));
    const bool is_inner = is_quad || !is_outer;
    faces.push_back({i, i + is_outer, j, j + is_inner});
    i += is_outer;
    j += is_inner;
  }
  return faces;
}

}  // namespace splinecore
#pragma GCC visibility pop
