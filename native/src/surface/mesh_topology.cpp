#include "mesh_topology.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "base/quotient.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

void require_faces(const ControlMesh& mesh) {
  if (mesh.faces.empty()) throw InvalidShape("the mesh has no face");
  const int count = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!is_finite(mesh.points[i])) throw InvalidShape("points" + index_text(i) + " is not finite");
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::string name = "faces" + index_text(f);
    std::vector<int> corners = mesh.faces[f];
    if (corners.size() < 3) throw InvalidShape(name + " has fewer than three corners");
    std::ranges::sort(corners);
    if (corners.front() < 0 || corners.back() >= count) {
      throw InvalidShape(name + " has a corner that is none of the " + std::to_string(count) + " points");
    }
    if (std::ranges::adjacent_find(corners) != corners.end()) throw InvalidShape(name + " has a corner twice");
  }
}

}  // namespace

MeshTopology::MeshTopology(const ControlMesh& mesh) {
  require_faces(mesh);
  first_.push_back(0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& corners = mesh.faces[f];
    for (std::size_t c = 0; c < corners.size(); ++c) sides_.push_back({static_cast<int>(f), static_cast<int>(c), corners[c], -1});
    first_.push_back(static_cast<int>(sides_.size()));
  }
  find_twins(mesh);
  find_fans(mesh);
}

bool MeshTopology::is_regular(int point) const {
  const std::size_t faces = fan(point).size();
  return is_on_border(point) ? faces <= 2 : faces == 4;
}

int MeshTopology::turned(int i, int by) const {
  const FaceSide& one = side(i);
  const int count = corners(one.face);
  return first_side(one.face) + (one.corner + by + count) % count;
}

void MeshTopology::find_twins(const ControlMesh& mesh) {
  std::map<std::pair<int, int>, int> known;
  const auto name = [](int face) { return "faces" + index_text(static_cast<std::size_t>(face)); };
  for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
    const auto [other, is_new] = known.try_emplace({side(i).from, to(i)}, i);
    if (is_new) continue;
    throw InvalidShape(name(side(other->second).face) + " and " + name(side(i).face) +
                       " have an edge in the same direction: they are turned differently, or it has more than two faces");
  }
  for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
    const auto found = known.find({to(i), side(i).from});
    if (found != known.end()) sides_[static_cast<std::size_t>(i)].twin = found->second;
  }
  is_on_border_.assign(mesh.points.size(), false);
  for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
    if (side(i).twin >= 0) continue;
    is_on_border_[static_cast<std::size_t>(side(i).from)] = true;
    is_on_border_[static_cast<std::size_t>(to(i))] = true;
  }
}

void MeshTopology::find_fans(const ControlMesh& mesh) {
  std::vector<int> faces(mesh.points.size(), 0);
  for (const FaceSide& one : sides_) ++faces[static_cast<std::size_t>(one.from)];
  fans_.resize(mesh.points.size());
  for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
    const auto point = static_cast<std::size_t>(side(i).from);
    std::vector<int>& fan = fans_[point];
    if (!fan.empty() || (is_on_border_[point] && side(i).twin >= 0)) continue;
    for (int at = i; at >= 0 && (fan.empty() || at != fan.front()); at = side(before(at)).twin) fan.push_back(at);
  }
  for (std::size_t point = 0; point < fans_.size(); ++point) {
    const std::string name = "points" + index_text(point);
    if (static_cast<int>(fans_[point].size()) != faces[point]) {
      throw InvalidShape("parts of the mesh meet in " + name + " alone");
    }
    if (!is_on_border_[point] && faces[point] == 1) {
      throw InvalidShape(name + " has one face around it: a point inside a mesh has two or more");
    }
  }
}

}  // namespace splinecore
