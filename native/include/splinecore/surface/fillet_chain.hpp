#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splinecore/surface/fillet_patches.hpp"

namespace splinecore {

/// An edge that two patches have in common.
struct PatchEdge {
  NurbsPatch first;
  Border first_side;
  NurbsPatch second;
  Border second_side;
};

/// The edges of a chain rounded by one ball that rolls on from each to the next: the first patches, in the order of the edges, continue
/// each other across their joints, and so do the second ones. A chain that ends where it begins, without a corner, is rounded as a loop.
///
/// The trimmed patches, and the fillets, share their sides along the chain and at its joints: the same control points on the
/// same knots. Each patch keeps its sides' names; along the edge all have one degree, and across it those of either kind.
/// @param radii  at places along the chain: k and a share of edge k
/// @throws InvalidShape if edges do not follow each other, meet in a corner, or patches do not continue each other; as fillet()
std::vector<RoundedEdge> fillet_chain(std::span<const PatchEdge> edges, std::span<const RailNumber> radii,
                                      std::optional<double> tolerance = {});

}  // namespace splinecore
