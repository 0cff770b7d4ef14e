#pragma once

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a curve along which surfaces touch, or have a border in common, on the way that it came.
/// @returns none where they are not one up to the tolerance, or nothing tells where the curve goes
std::optional<SectionPlace> touching_place(const TwoPatches& patches, const PatchSpots& at, const PatchContact& contact,
                                           const glm::dvec3& way, double tolerance);

/// A border may run along that of the other patch, or along a side of a piece: what is beside a side by rounding is on it.
void settle_on_sides(const TwoPatches& patches, PatchSpots& at, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
