#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where two curves that are near along an interval have most derivatives in common: the place at which rounding, which
/// parts a contact of order k into up to k + 1 crossings, leaves their mean.
/// @param along  where curves are near: all of it, and a part in which the gap is smooth
/// @param gap    from the first curve to the second one
/// @returns none where no power of the distance from a place is most of the gap
std::optional<double> contact_place(const std::array<Interval, 2>& along,
                                    const std::function<glm::dvec3(double)>& gap);

}  // namespace splinecore
#pragma GCC visibility pop
