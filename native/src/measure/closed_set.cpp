#include "closed_set.hpp"

#include <array>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/patch/panels.hpp"

namespace splinecore {

std::string side_name(std::size_t patch, int side) {
  constexpr std::array<const char*, 4> kNames{"u = start", "u = end", "v = start", "v = end"};
  return "the side " + std::string(kNames[side]) + " of patches" + index_text(patch);
}

int turn_of(int side, const PanelSide& found) {
  const int turn = side == 1 || side == 2 ? 1 : -1;
  return found.reversed ? -turn : turn;
}

std::vector<const NurbsPatch*> patches_of(const PatchSet& set) {
  std::vector<const NurbsPatch*> patches;
  for (std::size_t i = 0; i < set.patches().size(); ++i) patches.push_back(&nurbs_of(set.patch(i)));
  return patches;
}

void require_closed(const PatchSet& set) {
  const std::vector<Panel> panels = panels_of(set);
  const std::vector<int> counts = side_counts(panels);
  std::vector<int> turns(counts.size(), 0);
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      const PanelSide& found = panel.sides[side];
      if (found.edge < 0) continue;
      if (counts[found.edge] == 1) {
        throw InvalidShape(side_name(panel.patch, side) + " meets no other: the patches enclose no volume");
      }
      turns[found.edge] += turn_of(side, found);
    }
  }
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      if (panel.sides[side].edge < 0 || turns[panel.sides[side].edge] == 0) continue;
      throw InvalidShape("normals point to the other side beyond " + side_name(panel.patch, side) +
                         ": flip one of both patches, or orient all of them");
    }
  }
}

}  // namespace splinecore
