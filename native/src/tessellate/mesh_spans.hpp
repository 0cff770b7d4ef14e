#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/patch/patch_set.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A span that a mesh tells apart. Spans shorter than 1e-9 of the domain, on which the patch stands still but for
/// rounding, are joints between knots that should have been one: nothing is drawn there.
struct MeshSpan {
  Interval range;
  int number = 0;          ///< of KnotVector::spans()
  bool is_crease = false;  ///< at its start, where the first derivative may jump
  bool is_gap = false;     ///< at its start, where the patch itself may
  bool is_sliver = false;  ///< so short that rounding of a parameter may reach across it
};

/// The spans of a direction, growing.
std::vector<MeshSpan> mesh_spans(const NurbsPatch& patch, Axis axis);

/// Of u and v of every patch.
std::vector<std::array<std::vector<MeshSpan>, 2>> mesh_spans(const PatchSet& set);

/// A parameter of one direction of a patch: the number of its mesh span times kSpan, and a part of it.
using Place = std::int64_t;
inline constexpr Place kSpan = Place{1} << 30;

/// The parameter of a place, at a joint the one behind it; the end of the domain is at the number of spans.
double parameter_at(const std::vector<MeshSpan>& spans, Place place);

/// At a joint the parameter before it.
double parameter_before(const std::vector<MeshSpan>& spans, Place place);

/// The place nearest to a parameter of the domain.
Place place_of(const std::vector<MeshSpan>& spans, double u);

}  // namespace splinecore
#pragma GCC visibility pop
