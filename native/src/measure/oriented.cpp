#include "splinecore/measure/oriented.hpp"

#include <algorithm>
#include <optional>

#include "closed_set.hpp"
#include "patch/flip.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/area.hpp"
#include "splinecore/patch/panels.hpp"

namespace splinecore {

namespace {

/// The sides that lie on one edge.
struct EdgeSides {
  struct OfPatch {
    std::size_t patch;
    int side;
    int turn;
  };
  std::vector<OfPatch> sides;
};

std::vector<EdgeSides> sides_of_edges(const std::vector<Panel>& panels) {
  std::vector<EdgeSides> edges(side_counts(panels).size());
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      const PanelSide& found = panel.sides[static_cast<std::size_t>(side)];
      if (found.edge < 0) continue;
      edges[static_cast<std::size_t>(found.edge)].sides.push_back({panel.patch, side, turn_of(side, found)});
    }
  }
  return edges;
}

/// Two patches that meet, and whether their normals agree there.
struct AcrossEdge {
  std::size_t patch;
  int side;
  bool agrees;
};

/// Patches that hang together, and which of them look the other way.
class Orientation {
 public:
  explicit Orientation(const PatchSet& set) : set_(set), across_(set.patches().size()), is_open_(set.patches().size(), false) {
    for (const EdgeSides& edge : sides_of_edges(panels_of(set))) add(edge);
  }

  std::vector<bool> flips() {
    std::vector<std::optional<bool>> known(set_.patches().size());
    std::vector<bool> flips(known.size());
    for (std::size_t first = 0; first < known.size(); ++first) {
      if (known[first]) continue;
      const std::vector<std::size_t> patches = spread_from(first, known);
      const bool turns = std::ranges::none_of(patches, [&](std::size_t i) { return is_open_[i]; }) && is_inside_out(patches, known);
      for (const std::size_t i : patches) flips[i] = *known[i] != turns;
    }
    return flips;
  }

 private:
  void add(const EdgeSides& edge) {
    const auto& sides = edge.sides;
    if (sides.size() == 1) is_open_[sides[0].patch] = true;
    if (sides.size() > 2) {
      throw InvalidShape(side_name(sides[0].patch, sides[0].side) + " lies on " + std::to_string(sides.size() - 1) +
                         " others: which way their normals point cannot be told");
    }
    if (sides.size() != 2) return;
    const bool agrees = sides[0].turn + sides[1].turn == 0;
    across_[sides[0].patch].push_back({sides[1].patch, sides[0].side, agrees});
    across_[sides[1].patch].push_back({sides[0].patch, sides[1].side, agrees});
  }

  /// All that hang together with a patch, which stays; writes which ones are to be flipped.
  std::vector<std::size_t> spread_from(std::size_t first, std::vector<std::optional<bool>>& flips) const {
    std::vector<std::size_t> patches{first};
    flips[first] = false;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      for (const AcrossEdge& across : across_[patches[k]]) {
        const bool wanted = *flips[patches[k]] != !across.agrees;
        std::optional<bool>& known = flips[across.patch];
        if (!known) patches.push_back(across.patch);
        if (known.value_or(wanted) != wanted) {
          throw InvalidShape("beyond " + side_name(patches[k], across.side) +
                             " normals come back the other way: the patches have but one side");
        }
        known = wanted;
      }
    }
    return patches;
  }

  bool is_inside_out(const std::vector<std::size_t>& patches, const std::vector<std::optional<bool>>& flips) const {
    constexpr double kRoughly = 1e-3;
    std::vector<IndexedPatch> indexed;
    std::vector<bool> which;
    for (const std::size_t i : patches) {
      indexed.push_back(set_.patches()[i]);
      which.push_back(*flips[i]);
    }
    const PatchSet whole = PatchSet::make({set_.points().begin(), set_.points().end()}, std::move(indexed));
    const double found = volume(flipped(whole, which), kRoughly).value;
    if (found != 0.0) return found < 0.0;
    throw InvalidShape("patches" + index_text(patches.front()) + " and those it hangs together with enclose nothing");
  }

  const PatchSet& set_;
  std::vector<std::vector<AcrossEdge>> across_;
  std::vector<bool> is_open_;
};

}  // namespace

bool is_closed(const PatchSet& set) {
  return std::ranges::none_of(side_counts(panels_of(set)), [](int count) { return count == 1; });
}

PatchSet oriented(const PatchSet& set) {
  const std::vector<bool> flips = Orientation(set).flips();
  return std::ranges::find(flips, true) == flips.end() ? set : flipped(set, flips);
}

}  // namespace splinecore
