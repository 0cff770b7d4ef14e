#pragma once

#include <algorithm>
#include <glm/vec4.hpp>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

inline bool have_positive_weights(std::span<const glm::dvec4> points) {
  return std::ranges::all_of(points, [](const glm::dvec4& p) { return p.w > 0.0; });
}

}  // namespace splinecore
#pragma GCC visibility pop
