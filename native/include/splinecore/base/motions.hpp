#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

// Affine maps of columns (x, y, z, 1), as transformed() takes them.
namespace splinecore {

/// @throws InvalidShape if a number is not finite, here and below.
glm::dmat4 translation(const glm::dvec3& by);

/// By an angle in radians, counterclockwise seen from the tip of the axis (Rodrigues). @throws InvalidShape if that is zero
glm::dmat4 rotation(double angle, const glm::dvec3& axis, const glm::dvec3& about);

/// By a factor along each axis of coordinates. @throws InvalidShape if one is zero: nothing could be told from the image.
glm::dmat4 scaling(const glm::dvec3& factors, const glm::dvec3& about);

}  // namespace splinecore
