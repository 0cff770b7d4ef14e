#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace splinecore {

/// Whether a chain returns to its first point.
enum class Closing { open, closed };

/// Steps of the parameter from one point to the next: 1, the root of their distance, or their distance.
enum class Parameterization { uniform, centripetal, chordal };

/// Parameters 0, … of the points; where closed one more, of the return to the first (Lee 1989; row S5).
/// @throws InvalidShape if a coordinate is not finite, or a step is zero: the message has its point's index.
std::vector<double> parameters_of(std::span<const glm::dvec3> points, Parameterization kind,
                                  Closing closing = Closing::open);

}  // namespace splinecore
