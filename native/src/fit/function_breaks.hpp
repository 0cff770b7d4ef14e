#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/fit/project.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws InvalidShape if one is not finite.
std::vector<glm::dvec3> values_of(const CurveFunction& function, std::span<const double> parameters);

/// The breaks and more of them, by halving, until so many nodes of Gauss and Legendre between each two tell the function
/// as far as its integrals feel: where it has a kink or jumps they crowd.
/// @throws InvalidShape for functions that are rough everywhere
std::vector<double> function_breaks(const CurveFunction& function, std::span<const double> breaks, int nodes);

}  // namespace splinecore
#pragma GCC visibility pop
