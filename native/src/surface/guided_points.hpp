#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "fairness.hpp"
#include "hole_guide.hpp"
#include "star.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A guide as control points of a star, by number: patches over its plane, that leave their sides there as those on it are to do.
/// @returns none where they would fold in the plane
std::vector<glm::dvec3> guided_points(const Hole& hole, const Star& star, const HoleGuide& guide);

/// How the guide bends, seen on few patches; none where these would fold in the plane.
std::optional<SurfaceBending> guided_bending(const Hole& hole, const HoleGuide& guide);

}  // namespace splinecore
#pragma GCC visibility pop
