#include "folds.hpp"

#include <algorithm>

namespace splinecore {

namespace {

bool is_fold(const MeshTopology& topology, int point) {
  return !topology.is_on_border(point) && topology.fan(point).size() == 2;
}

}  // namespace

bool has_folds(const MeshTopology& topology) {
  return std::ranges::any_of(topology.sides(), [&](const FaceSide& side) { return is_fold(topology, side.from); });
}

ControlMesh without_folds(const ControlMesh& mesh, const MeshTopology& topology) {
  ControlMesh made{mesh.points, {}};
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
    std::vector<int> corners = mesh.faces[static_cast<std::size_t>(f)];
    const auto fold = std::ranges::find_if(corners, [&](int point) { return is_fold(topology, point); });
    if (fold == corners.end()) {
      made.faces.push_back(std::move(corners));
      continue;
    }
    const std::vector<int>& fan = topology.fan(*fold);
    const int own = topology.side(fan[0]).face == f ? fan[0] : fan[1];
    const int other = own == fan[0] ? fan[1] : fan[0];
    const int opposite = topology.to(topology.next(other));
    if (topology.side(other).face < f) continue;  // it has become one with this one
    *fold = opposite;
    made.faces.push_back(std::move(corners));
  }
  return made;
}

}  // namespace splinecore
