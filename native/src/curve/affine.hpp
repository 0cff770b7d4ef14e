#pragma once

#include <glm/mat4x4.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

bool is_affine(const glm::dmat4& matrix) noexcept;

/// @throws InvalidShape if a map would make something else than a Hermite curve, or patch, of one.
void require_affine(const glm::dmat4& matrix, const char* what);

}  // namespace splinecore
#pragma GCC visibility pop
