#pragma once

#include <array>
#include <optional>

#include "network_curves.hpp"
#include "paced_family.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The patch whose sides are the outermost curves of families on its knots: what curves pass one another by moves these no more.
NurbsPatch with_outermost(const NurbsPatch& patch, const PacedFamily& u, const PacedFamily& v);

/// How far the sides u_start, u_end, v_start, v_end are from the outermost curves as they are given, both run through at one pace;
/// none where a direction is closed.
std::array<std::optional<double>, 4> distances_of_paces(const NurbsPatch& patch, const PacedFamily& u, const PacedFamily& v);

/// A patch that is closed in a direction begins where the outermost curve that keeps its pace did.
NurbsPatch begun_as_given(const NurbsPatch& patch, const NetworkCurves& curves);

}  // namespace splinecore
#pragma GCC visibility pop
