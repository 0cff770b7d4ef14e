#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The same patch over another interval of one direction: the knots are mapped, the points stay (S20).
/// @throws InvalidShape unless start < end, both finite, and the mapped knots stay apart.
NurbsPatch with_domain(const NurbsPatch& patch, Axis axis, Interval domain);

/// The same patch, plain in one direction, with both ends of that direction in its outer control points.
NurbsPatch clamped(const NurbsPatch& patch, Axis axis);

/// The same patch on knots of one direction that continue outside the domain, as wide as the spans beside it (The
/// NURBS Book, A12.1). A periodic direction is unrolled.
/// @throws InvalidShape if weights at an end are so different that rounding would move the patch.
NurbsPatch unclamped(const NurbsPatch& patch, Axis axis);

/// The patch that is closed in one direction as a periodic one, as smooth at its seam as it is.
/// @param tolerance  how far closing the ends and removing knots at the seam may move the patch; by default a
///                   few roundings of the largest coordinate
/// @throws ToleranceNotReached if the ends lie farther apart; InvalidShape if the weights along them differ.
Approximation<NurbsPatch> made_periodic(const NurbsPatch& patch, Axis axis, std::optional<double> tolerance = {});

}  // namespace splinecore
