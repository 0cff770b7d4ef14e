#include "splinecore/patch/panels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>

#include "basis/gaps.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// The curve of a side over the part of its domain that the panel has.
struct SideCurve {
  std::size_t panel;
  int side;
  NurbsCurve curve;
  Interval range;
  double tolerance;  ///< up to which points of its patch are one

  double at(double t, bool reversed) const {
    const double forward = reversed ? 1.0 - t : t;
    return forward == 1.0 ? range.end : range.start + forward * range.length();
  }
  glm::dvec3 point(double t, bool reversed = false) const {
    const double u = at(t, reversed);
    glm::dvec3 found;
    const Side from = u == range.end ? Side::left : Side::right;
    evaluate(curve, {&u, 1}, std::span(&found.x, 3), {from, AtInfinity::nan});
    return found;
  }
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

SideCurve side_curve(const PatchSet& set, const Panel& panel, std::size_t number, int side, double tolerance) {
  const bool is_u = side < 2;
  const bool is_end = side % 2 == 1;
  const Interval& across = is_u ? panel.u : panel.v;
  return {number, side,
          isocurve(nurbs_of(set.patch(panel.patch)), is_u ? Axis::u : Axis::v, is_end ? across.end : across.start,
                   is_end ? Side::left : Side::right),
          is_u ? panel.v : panel.u, tolerance};
}

std::vector<double> scaled_knots(const SideCurve& side, bool reversed) {
  std::vector<double> found{0.0, 1.0};
  for (const double u : side.curve.knot_vector().unrolled()) {
    if (u <= side.range.start || u >= side.range.end) continue;
    const double t = (u - side.range.start) / side.range.length();
    found.push_back(reversed ? 1.0 - t : t);
  }
  return found;
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) <= tolerance;
}

/// Whether two sides have the very same points on the same knots.
bool is_same(const SideCurve& a, const SideCurve& b, bool reversed) {
  const auto points = a.curve.points();
  const auto others = b.curve.points();
  if (points.size() != others.size() || a.curve.degree() != b.curve.degree() || a.range != b.range) return false;
  if (!std::ranges::equal(a.curve.knot_vector().knots(), b.curve.knot_vector().knots())) return false;
  return !reversed && std::ranges::equal(points, others);
}

bool is_one_curve(const SideCurve& a, const SideCurve& b, bool reversed) {
  if (is_same(a, b, reversed)) return true;
  constexpr double kOneKnot = 0x1p-40;
  const double tolerance = std::max(a.tolerance, b.tolerance);
  std::vector<double> knots = scaled_knots(a, false);
  const std::vector<double> others = scaled_knots(b, reversed);
  knots.insert(knots.end(), others.begin(), others.end());
  std::ranges::sort(knots);
  const int count = a.curve.degree() + b.curve.degree() + 1;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double length = knots[i] - knots[i - 1];
    if (length <= kOneKnot) continue;
    for (int k = 0; k < count; ++k) {
      const double t = knots[i - 1] + length * (k + 0.5) / count;
      if (!near(a.point(t), b.point(t, reversed), tolerance)) return false;
    }
  }
  return near(a.point(0), b.point(0, reversed), tolerance) && near(a.point(1), b.point(1, reversed), tolerance);
}

/// Whether the side is a point: all that it depends on lies in one place.
bool is_point(const SideCurve& side) {
  const auto points = side.curve.points();
  const bool has_directions = std::ranges::any_of(points, [](const glm::dvec4& p) { return p.w == 0.0; });
  return !has_directions && extent(points) <= side.tolerance;
}

/// Where the middle of a side lies along a direction in which few have the same place.
double middle(const SideCurve& side) {
  constexpr glm::dvec3 kDirection(0.71, 0.53, 0.46);
  const double at = glm::dot(kDirection, side.point(0.5));
  return std::isnan(at) ? std::numeric_limits<double>::infinity() : at;
}

/// Of each side, in an order by their middles, those before it that may be the same curve, the nearest first. Each side
/// looks as far as its own tolerance reaches, so that a large one among many small ones costs the others nothing.
std::vector<std::vector<std::size_t>> candidates(const std::vector<SideCurve>& sides,
                                                 const std::vector<std::pair<double, std::size_t>>& order) {
  std::vector<std::vector<std::size_t>> found(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double tolerance = sides[order[i].second].tolerance;
    for (std::size_t k = i; k-- > 0 && order[i].first - order[k].first <= tolerance;) found[i].push_back(k);
    for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= tolerance; ++k) {
      if (!(order[k].first - order[i].first <= sides[order[k].second].tolerance)) found[k].push_back(i);
    }
  }
  for (std::vector<std::size_t>& before : found) std::ranges::sort(before, std::greater());
  return found;
}

/// Numbers the edges: each side takes the edge of the first side before it that is the same curve.
void match(std::vector<Panel>& panels, const std::vector<SideCurve>& sides) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < sides.size(); ++i) order.emplace_back(middle(sides[i]), i);
  std::ranges::sort(order);
  const auto before = candidates(sides, order);
  int edges = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const SideCurve& side = sides[order[i].second];
    PanelSide& found = panels[side.panel].sides[side.side];
    for (std::size_t n = 0; n < before[i].size() && found.edge < 0; ++n) {
      const SideCurve& other = sides[order[before[i][n]].second];
      const PanelSide& known = panels[other.panel].sides[other.side];
      for (const bool reversed : {false, true}) {
        if (found.edge < 0 && is_one_curve(other, side, reversed)) found = {known.edge, known.reversed != reversed};
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
  std::vector<SideCurve> sides;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      SideCurve curve = side_curve(set, panels[i], i, side, tolerances[panels[i].patch]);
      if (!is_point(curve)) sides.push_back(std::move(curve));
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
