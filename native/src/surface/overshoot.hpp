#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How far control points of the rows beside a side lie off the straight ways out of it, at most, by how far the ways to
/// them are on average.
/// @param across  clamped at its start
/// @param rows    homogeneous with positive weights, row 0 along the side
/// @param out     the derivative across the side
/// @param count   of rows that are looked at, row 0 among them
double overshoot(const KnotVector& across, std::span<const std::vector<glm::dvec4>> rows, const std::vector<glm::dvec4>& out,
                 std::size_t count);

}  // namespace splinecore
#pragma GCC visibility pop
