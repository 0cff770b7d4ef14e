#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point of a patch beside which its normals turn round, or where that could not be ruled out; at a crease, beside which they do so
/// more sharply than its borders. None where they are shown not to: on every part of every span both derivatives, as their control
/// points bound them, turn the same way from one to the other, and normals nowhere turn by a right angle within a tolerance or two
/// where borders do not; but for what lies within a tolerance of a corner, which says nothing where borders go straight on within
/// that.
std::optional<glm::dvec3> fold_of(const NurbsPatch& patch, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
