#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "hole.hpp"
#include "seen_filling.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "star.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Of four sides those of one patch; of others two for each patch round a point.
std::vector<PartOfSide> star_parts(const Hole& hole);

/// Values on a side, by its number, at places of it: of order 0 its points, of others derivatives across it, into the hole.
using ValuesAlong = std::function<std::vector<glm::dvec3>(std::size_t side, std::span<const double> s, int order)>;

/// The control points of a star that its sides decide, by number.
/// @param orders  the highest for each side
std::vector<std::optional<glm::dvec3>> claimed_points(const Hole& hole, const Star& star, const ValuesAlong& values,
                                                      const std::vector<int>& orders);

std::vector<NurbsPatch> patches_of(const Star& star, const std::vector<glm::dvec3>& points);

}  // namespace splinecore
#pragma GCC visibility pop
