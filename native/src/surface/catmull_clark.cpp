#include "splinecore/surface/catmull_clark.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "extraordinary_fan.hpp"
#include "folds.hpp"
#include "measure/seam_angle.hpp"
#include "meet/near_space.hpp"
#include "mesh_topology.hpp"
#include "regular_net.hpp"

namespace splinecore {

namespace {

bool can_be_patches(const ControlMesh& mesh, const MeshTopology& topology) {
  return std::ranges::all_of(mesh.faces, [&](const std::vector<int>& face) {
    return face.size() == 4 && std::ranges::count_if(face, [&](int point) { return !topology.is_regular(point); }) < 2;
  });
}

/// The patches of a mesh that has one for each face.
class FacePatches {
 public:
  explicit FacePatches(const ControlMesh& mesh)
      : mesh_(mesh), topology_(mesh), patches_(mesh.faces.size()), first_(mesh.faces.size(), 0), is_regular_(mesh.faces.size(), true) {}

  SubdivisionPatches made() {
    write_irregular();
    SubdivisionPatches made;
    for (int f = 0; f < static_cast<int>(patches_.size()); ++f) {
      const auto face = static_cast<std::size_t>(f);
      if (is_regular_[face]) patches_[face] = regular_patch(mesh_, topology_, topology_.first_side(f));
    }
    for (int i = 0; i < static_cast<int>(topology_.sides().size()); ++i) made.angle = std::max(made.angle, angle_across(i));
    made.irregular = static_cast<std::size_t>(std::ranges::count(is_regular_, false));
    for (auto& patch : patches_) made.patches.push_back(std::move(*patch));
    return made;
  }

 private:
  void write_irregular() {
    std::optional<ControlMesh> finer;
    std::optional<MeshTopology> finer_topology;
    for (int point = 0; point < static_cast<int>(mesh_.points.size()); ++point) {
      if (topology_.fan(point).empty() || topology_.is_regular(point)) continue;
      if (!finer) {
        finer = subdivided(mesh_);
        finer_topology.emplace(*finer);
      }
      std::vector<NurbsPatch> fan = extraordinary_fan(mesh_, topology_, *finer, *finer_topology, point);
      for (std::size_t k = 0; k < fan.size(); ++k) {
        const int across = topology_.next(topology_.next(topology_.fan(point)[k]));
        const auto face = static_cast<std::size_t>(topology_.side(across).face);
        patches_[face] = std::move(fan[k]);
        first_[face] = topology_.side(across).corner;
        is_regular_[face] = false;
      }
    }
  }

  Border border_of(int side) const {
    constexpr std::array<Border, 4> kBorders{Border::v_start, Border::u_end, Border::v_end, Border::u_start};
    const FaceSide& one = topology_.side(side);
    return kBorders[static_cast<std::size_t>((one.corner + 4 - first_[static_cast<std::size_t>(one.face)]) % 4)];
  }

  /// Between tangent planes of both patches, where one of them is not the surface itself.
  double angle_across(int side) const {
    const FaceSide& one = topology_.side(side);
    if (one.twin < side) return 0.0;
    const auto face = static_cast<std::size_t>(one.face);
    const auto other = static_cast<std::size_t>(topology_.side(one.twin).face);
    if (is_regular_[face] && is_regular_[other]) return 0.0;
    return seam_angle(*patches_[face], border_of(side), *patches_[other], border_of(one.twin));
  }

  const ControlMesh& mesh_;
  MeshTopology topology_;
  std::vector<std::optional<NurbsPatch>> patches_;
  std::vector<int> first_;  ///< of the corners of each face that at which its patch begins
  std::vector<bool> is_regular_;
};

ControlMesh entered(const ControlMesh& mesh, const NearSpace& space) {
  ControlMesh near = mesh;
  for (glm::dvec3& point : near.points) point = space.enter(point).at;
  return near;
}

/// Those that faces have.
std::vector<glm::dvec4> used_points(const ControlMesh& mesh) {
  std::vector<glm::dvec4> points;
  for (const auto& face : mesh.faces) {
    for (const int corner : face) points.emplace_back(mesh.points[static_cast<std::size_t>(corner)], 1.0);
  }
  return points;
}

}  // namespace

SubdivisionPatches catmull_clark(const ControlMesh& mesh) {
  MeshTopology topology(mesh);
  const NearSpace space(used_points(mesh));
  ControlMesh near = entered(mesh, space);
  int rounds = 0;
  for (; has_folds(topology) || !can_be_patches(near, topology); ++rounds) {
    near = subdivided(near);
    topology = MeshTopology(near);
    if (!has_folds(topology)) continue;
    near = without_folds(near, topology);
    topology = MeshTopology(near);
  }
  SubdivisionPatches made = FacePatches(near).made();
  made.rounds = rounds;
  for (NurbsPatch& patch : made.patches) patch = patch.with_points(space.leave(patch.points()));
  return made;
}

}  // namespace splinecore
