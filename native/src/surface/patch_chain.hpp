#pragma once

#include <string>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Patches that follow each other along u, each over [0, 1]², as one over [0, 1]².
struct PatchChain {
  NurbsPatch patch;
  std::vector<double> joints;  ///< from 0 to 1
};

/// @param lengths  how long each is along u
/// @param name     of the patches, for sentences
/// @throws InvalidShape if one does not begin with the side across in which the one before it ends
PatchChain chained(std::vector<NurbsPatch> patches, const std::vector<double>& lengths, const std::string& name);

}  // namespace splinecore
#pragma GCC visibility pop
