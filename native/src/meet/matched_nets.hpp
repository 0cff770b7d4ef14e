#pragma once

#include <glm/vec4.hpp>

#include "basis/bernstein_net.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A net whose parameters are exchanged, or go the other way.
BernsteinNet<glm::dvec4> turned(const BernsteinNet<glm::dvec4>& net, bool is_exchanged, bool is_u_reversed,
                                bool is_v_reversed);

/// Whether points of two pieces by the same parameters are nowhere farther apart: by the control points of what
/// cross-multiplying leaves, so that it does not depend on how both are written.
bool are_within(const BernsteinNet<glm::dvec4>& a, const BernsteinNet<glm::dvec4>& b, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
