#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "bytes.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore::fuzz {

// Shapes out of bytes: valid ones as a rule, otherwise the library refuses them with InvalidShape.

/// More points than this are not walked on with: a walk could double them at every step.
inline constexpr std::size_t kManyPoints = 500;

/// 1 to 8 as a rule, up to 32 now and then and up to `most` rarely: most of what is done takes the square of it.
int degree(Bytes& bytes, int most);

/// Of any kind: one span, clamped, uniform, periodic, or steps of which many are 0.
KnotVector knots(Bytes& bytes, int most_degree);

glm::dvec3 vector(Bytes& bytes);
std::vector<glm::dvec3> vectors(Bytes& bytes, std::size_t count);

/// With weights of 1, positive ones, or any.
std::vector<glm::dvec4> points(Bytes& bytes, std::size_t count);

std::vector<double> numbers(Bytes& bytes, std::size_t count);
std::vector<double> increasing(Bytes& bytes, std::size_t count);
std::vector<double> parameters(Bytes& bytes, Interval range, std::size_t count);

/// A parameter of the domain, often a knot.
double parameter(Bytes& bytes, const KnotVector& knots);

NurbsCurve nurbs_curve(Bytes& bytes);
NurbsPatch nurbs_patch(Bytes& bytes);

/// Affine as a rule.
glm::dmat4 matrix(Bytes& bytes);

}  // namespace splinecore::fuzz
