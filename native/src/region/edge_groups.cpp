#include "edge_groups.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "build/curve_parts.hpp"
#include "splinecore/meet/nearest.hpp"

namespace splinecore {

namespace {

bool are_one(const NurbsCurve& a, const NurbsCurve& b, double tolerance) {
  return is_covered(a, {&b, 1}, tolerance) && is_covered(b, {&a, 1}, tolerance);
}

/// Whether a curve that lies on another one goes the other way.
bool is_against(const NurbsCurve& curve, const NurbsCurve& other) {
  const std::vector<glm::dvec3> places = places_along(curve, 3);
  std::vector<NearestOnCurve> found(places.size());
  nearest(other, places, found, 1);
  return found.back().parameter < found.front().parameter;
}

}  // namespace

std::vector<EdgeGroup> edge_groups(const Arrangement& arrangement, double tolerance) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between;
  std::vector<EdgeGroup> groups;
  for (std::size_t i = 0; i < arrangement.edges.size(); ++i) {
    const ArrangedEdge& edge = arrangement.edges[i];
    std::vector<std::size_t>& known = between[std::minmax(edge.from, edge.to)];
    const auto same = std::ranges::find_if(known, [&](std::size_t g) {
      return are_one(arrangement.edges[groups[g][0].edge].curve, edge.curve, kVertex * tolerance);
    });
    if (same != known.end()) {
      groups[*same].push_back({i, is_against(edge.curve, arrangement.edges[groups[*same][0].edge].curve)});
      continue;
    }
    known.push_back(groups.size());
    groups.push_back({{i, false}});
  }
  return groups;
}

}  // namespace splinecore
