#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The part of a curve between two parameters.
NurbsCurve part_of(const NurbsCurve& curve, const Interval& range);

/// Places of all spans of a curve, their ends among them.
std::vector<glm::dvec3> samples_of(const NurbsCurve& curve);

/// Whether a curve lies within a tolerance of others, as far as its samples say.
bool is_covered(const NurbsCurve& curve, std::span<const NurbsCurve> others, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
