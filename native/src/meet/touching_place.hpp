#pragma once

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a curve along which surfaces touch, or have a border in common, on the way that it came.
/// @returns none where they are not one up to the tolerance, or nothing tells where the curve goes
std::optional<SectionPlace> touching_place(const TwoPatches& patches, const PatchSpots& at, const PatchContact& contact,
                                           const glm::dvec3& way, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
