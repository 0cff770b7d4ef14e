#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "splinecore/measure/area.hpp"

namespace splinecore {

/// Writes the vectors of a field at points.
using VectorField = std::function<void(std::span<const glm::dvec3> points, std::span<glm::dvec3> vectors)>;

/// The flux of a field through a patch: the integral of F(S) · (S_u x S_v), positive where it flows to the side of the
/// normals. No surface need be closed; of one that is, with normals outwards, it is the integral of the divergence
/// (Gauss).
///
/// On every piece between knots the rules of Gauss and Kronrod of 10 and 21 nodes, halved where they differ, along the
/// direction where they do more. The field is asked for up to 28 224 points at once; it is taken to be smooth between
/// nodes.
/// @param tolerance  The flux is off by at most so much of the integral of |F · n|, all that flows through to either side,
///                   or by rounding of the coordinates and of the field where that is more, and the error says so.
/// @throws InvalidShape if the tolerance is not positive, a vector of the field is not finite, or weights differ too much
///         in size; PointAtInfinity if the patch runs to infinity; ToleranceNotReached if that takes more than 16 000
///         pieces and 4 for each pair of spans.
Approximation<double> flux(const NurbsPatch& patch, const VectorField& field, double tolerance = kAreaTolerance);

/// The sum of the fluxes through all patches, each to the side of its normals.
Approximation<double> flux(const PatchSet& set, const VectorField& field, double tolerance = kAreaTolerance);

}  // namespace splinecore
