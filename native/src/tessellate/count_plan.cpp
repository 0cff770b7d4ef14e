#include "count_plan.hpp"

#include <algorithm>
#include <cmath>

#include "strip.hpp"

namespace splinecore {

CountPlan::CountPlan(const PatchSet& set, const std::vector<Panel>& panels, int resolution_u, int resolution_v)
    : panels_(panels), spans_(mesh_spans(set)), resolutions_(set.patches().size(), {resolution_u, resolution_v}) {
  constexpr int kLeastAround = 3;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (const int axis : {0, 1}) {
      const PanelSide& start = panels[i].sides[2 * axis];
      if (start.edge < 0 || start.edge != panels[i].sides[2 * axis + 1].edge) continue;
      // A closed direction of fewer strips would fold onto itself.
      const auto [from, to] = this->spans(i, axis);
      int& resolution = resolutions_[panels[i].patch][axis];
      resolution = std::max(resolution, (kLeastAround - 1 + to - from) / (to - from));
    }
  }
  do {
    choose_edge_places();
  } while (raise_narrow_panels());
}

std::pair<int, int> CountPlan::spans(std::size_t panel, int axis) const {
  const Panel& own = panels_[panel];
  const Interval& range = axis == 0 ? own.u : own.v;
  const std::vector<MeshSpan>& all = spans_[own.patch][axis];
  const auto number = [&](double u) { return static_cast<int>((place_of(all, u) + kSpan / 2) / kSpan); };
  return {number(range.start), number(range.end)};
}

int CountPlan::strips(std::size_t panel, int axis) const {
  const auto [from, to] = spans(panel, axis);
  return (to - from) * resolutions_[panels_[panel].patch][axis];
}

/// Where the lines of the panel's grid meet a side, in the direction of its edge.
std::vector<double> CountPlan::places(std::size_t panel, int side) const {
  const int axis = side_runs_along(side);
  const Panel& own = panels_[panel];
  const Interval& range = axis == 0 ? own.u : own.v;
  const int resolution = resolutions_[own.patch][axis];
  const auto [from, to] = spans(panel, axis);
  std::vector<double> found;
  for (int i = from; i < to; ++i) {
    const Interval& span = spans_[own.patch][axis][i].range;
    for (int k = 0; k < resolution; ++k) {
      found.push_back((span.start + span.length() * (static_cast<double>(k) / resolution) - range.start) / range.length());
    }
  }
  found.push_back(1.0);
  if (own.sides[side].reversed) {
    std::ranges::reverse(found);
    for (double& t : found) t = 1.0 - t;
  }
  return found;
}

bool CountPlan::has_places_of_edge(std::size_t panel, int side) const {
  const int edge = panels_[panel].sides[side].edge;
  if (edge < 0) return true;
  return std::ranges::equal(places(panel, side), edges_[edge],
                            [](double a, double b) { return std::abs(a - b) <= kOneStep; });
}

/// An edge has the places of the side that has most.
void CountPlan::choose_edge_places() {
  edges_.assign(side_counts(panels_).size(), {});
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panels_[panel].sides[side].edge;
      if (edge < 0) continue;
      std::vector<double>& known = edges_[edge];
      if (known.size() < static_cast<std::size_t>(strips(panel, side_runs_along(side))) + 1) known = places(panel, side);
    }
  }
}

/// Beside a side whose edge has other places a panel needs two strips both ways; whether one had fewer.
bool CountPlan::raise_narrow_panels() {
  bool is_any_raised = false;
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    if (strips(panel, 0) > 1 && strips(panel, 1) > 1) continue;
    bool fits = true;
    for (int side = 0; side < 4; ++side) fits = fits && has_places_of_edge(panel, side);
    if (fits) continue;
    for (const int axis : {0, 1}) {
      if (strips(panel, axis) == 1) resolutions_[panels_[panel].patch][axis] = 2;
    }
    is_any_raised = true;
  }
  return is_any_raised;
}

}  // namespace splinecore
