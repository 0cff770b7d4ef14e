#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "splinecore/surface/sweep.hpp"

namespace splinecore {

/// Where sweep() puts a section that is given in the frame of its rail, at parameters: x, y, z and the point as columns.
///
/// Of a closed rail as sweep() takes it: carried round evenly, or from its first corner on. A corner is what turns a section of
/// the size of the rail by more than is seen of the default tolerance; at it the frame is that behind it.
/// @throws InvalidShape as sweep() for frames, and for a parameter outside the rail
std::vector<glm::dmat4> rail_matrices(const NurbsCurve& rail, std::span<const double> at, const SweepOptions& options = {});

/// The same between two rails, by parameters of the first: x has length 1, and its point is that of the first rail.
/// @throws InvalidShape as sweep() where there is no frame
std::vector<glm::dmat4> rail_matrices(const NurbsCurve& rail, const NurbsCurve& second, std::span<const double> at,
                                      const TwoRailOptions& options = {});

}  // namespace splinecore
