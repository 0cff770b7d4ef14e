#include "splinecore/patch/panels.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "basis/gaps.hpp"
#include "side_curve.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

/// A side of a panel that is no point.
struct PlacedSide {
  std::size_t panel;
  int side;
  SideCurve curve;
  SideMiddle middle;

  double reach() const { return curve.tolerance + middle.spread; }
};

/// The parameters where a direction begins, has a gap, or ends.
std::vector<double> panel_ends(const KnotVector& knots) {
  const Interval domain = knots.domain();
  std::vector<double> found{domain.start};
  for (const double u : gaps(knots)) {
    if (u > domain.start) found.push_back(u);
  }
  found.push_back(domain.end);
  return found;
}

/// Of the patch alone, wherever others are: a part of its extent, and what rounding leaves of coordinates far out.
double tolerance_of(const NurbsPatch& patch) {
  constexpr double kUlps = 0x1p-48;
  return std::max(kOneCurve * extent(patch.points()), kUlps * largest_coordinate(patch.points()));
}

/// Of each side, in an order by their middles, those before it that may be the same curve, the nearest first. Each side
/// looks as far as its own reach, so that a large one among many small ones costs the others nothing.
std::vector<std::vector<std::size_t>> candidates(const std::vector<PlacedSide>& sides,
                                                 const std::vector<std::pair<double, std::size_t>>& order) {
  std::vector<std::vector<std::size_t>> found(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double reach = sides[order[i].second].reach();
    for (std::size_t k = i; k-- > 0 && order[i].first - order[k].first <= reach;) found[i].push_back(k);
    for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= reach; ++k) {
      if (!(order[k].first - order[i].first <= sides[order[k].second].reach())) found[k].push_back(i);
    }
  }
  for (std::vector<std::size_t>& before : found) std::ranges::sort(before, std::greater());
  return found;
}

/// Numbers the edges: each side takes the edge of the first side before it that is the same curve.
void match(std::vector<Panel>& panels, const std::vector<PlacedSide>& sides) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < sides.size(); ++i) order.emplace_back(sides[i].middle.place, i);
  std::ranges::sort(order);
  const auto before = candidates(sides, order);
  int edges = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const PlacedSide& side = sides[order[i].second];
    PanelSide& found = panels[side.panel].sides[side.side];
    for (std::size_t n = 0; n < before[i].size() && found.edge < 0; ++n) {
      const PlacedSide& other = sides[order[before[i][n]].second];
      const PanelSide& known = panels[other.panel].sides[other.side];
      for (const bool reversed : {false, true}) {
        if (found.edge >= 0 || !is_one_curve(other.curve, side.curve, reversed)) continue;
        found = {known.edge, known.reversed != reversed};
      }
    }
    if (found.edge < 0) found = {edges++, false};
  }
}

}  // namespace

std::vector<Panel> panels_of(const PatchSet& set) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& patch = nurbs_of(set.patch(i));
    const std::vector<double> u = panel_ends(patch.knot_vector(Axis::u));
    const std::vector<double> v = panel_ends(patch.knot_vector(Axis::v));
    for (std::size_t j = 1; j < u.size(); ++j) {
      for (std::size_t k = 1; k < v.size(); ++k) panels.push_back({i, {u[j - 1], u[j]}, {v[k - 1], v[k]}, {}});
    }
  }
  std::vector<double> tolerances;
  for (std::size_t i = 0; i < set.patches().size(); ++i) tolerances.push_back(tolerance_of(nurbs_of(set.patch(i))));
  std::vector<PlacedSide> sides;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t patch = panels[i].patch;
    for (int side = 0; side < 4; ++side) {
      auto curve = side_curve(nurbs_of(set.patch(patch)), panels[i], static_cast<Border>(side), tolerances[patch]);
      if (!curve) continue;
      const SideMiddle at = middle(*curve);
      sides.push_back({i, side, std::move(*curve), at});
    }
  }
  match(panels, sides);
  return panels;
}

std::vector<int> side_counts(const std::vector<Panel>& panels) {
  std::vector<int> counts;
  for (const Panel& panel : panels) {
    for (const PanelSide& side : panel.sides) {
      if (side.edge < 0) continue;
      counts.resize(std::max(counts.size(), static_cast<std::size_t>(side.edge) + 1), 0);
      ++counts[side.edge];
    }
  }
  return counts;
}

std::vector<SharedEdge> shared_edges(const PatchSet& set) {
  struct Known {
    std::size_t patch;
    int side;
    bool reversed;
  };
  std::map<int, Known> last;
  std::vector<SharedEdge> found;
  for (const Panel& panel : panels_of(set)) {
    const NurbsPatch& patch = nurbs_of(set.patch(panel.patch));
    for (int side = 0; side < 4; ++side) {
      const PanelSide& own = panel.sides[side];
      const bool is_whole = (side < 2 ? panel.v : panel.u) == patch.knot_vector(side < 2 ? Axis::v : Axis::u).domain();
      const Interval domain = patch.knot_vector(side < 2 ? Axis::u : Axis::v).domain();
      const Interval& across = side < 2 ? panel.u : panel.v;
      const bool is_outer = side % 2 == 0 ? across.start == domain.start : across.end == domain.end;
      if (own.edge < 0 || !is_whole || !is_outer) continue;
      const auto before = last.find(own.edge);
      if (before != last.end()) {
        const Known& first = before->second;
        found.push_back({first.patch, static_cast<Border>(first.side), panel.patch, static_cast<Border>(side),
                         first.reversed != own.reversed});
      }
      last[own.edge] = {panel.patch, side, own.reversed};
    }
  }
  return found;
}

}  // namespace splinecore
