#pragma once

#include "bytes.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore::fuzz {

/// What is done to a patch, with arguments from the bytes: a verb puts its result in the patch's place.
using PatchStep = void (*)(Bytes& bytes, NurbsPatch& patch);

std::span<const PatchStep> patch_verbs();
std::span<const PatchStep> patch_measures();

inline Axis axis(Bytes& bytes) { return bytes.flag() ? Axis::v : Axis::u; }
inline Border border(Bytes& bytes) { return static_cast<Border>(bytes.integer(0, 3)); }

}  // namespace splinecore::fuzz
