#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The point that a homogeneous point stands for.
inline glm::dvec3 project(const glm::dvec4& h) noexcept { return glm::dvec3(h) / h.w; }

bool is_finite(const glm::dvec3& p) noexcept;

/// Derivatives 0 … n of X/W, Y/W, Z/W from those of X, Y, Z, W (The NURBS Book, A4.2).
void quotient_derivatives(std::span<const glm::dvec4> homogeneous, std::span<glm::dvec3> out) noexcept;

/// The same for all mixed derivatives k, l <= order, row after row (A4.4).
void quotient_derivatives(std::span<const glm::dvec4> homogeneous, int order,
                          std::span<glm::dvec3> out) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
