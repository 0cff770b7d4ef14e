#include <array>

#include "mesh_topology.hpp"
#include "splinecore/surface/catmull_clark.hpp"

namespace splinecore {

namespace {

/// Means of the corners of each face.
std::vector<glm::dvec3> face_points(const ControlMesh& mesh) {
  std::vector<glm::dvec3> found;
  for (const auto& face : mesh.faces) {
    glm::dvec3 sum(0.0);
    for (const int corner : face) sum += mesh.points[static_cast<std::size_t>(corner)] / static_cast<double>(face.size());
    found.push_back(sum);
  }
  return found;
}

/// What is made of a mesh, and where its points lie among the new ones: those of the mesh first, then of edges, then of faces.
class Round {
 public:
  explicit Round(const ControlMesh& mesh) : mesh_(mesh), topology_(mesh), faces_(face_points(mesh)), edges_(topology_.sides().size(), -1) {
    int count = static_cast<int>(mesh.points.size());
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i) {
      const int twin = topology_.side(i).twin;
      edges_[static_cast<std::size_t>(i)] = twin >= 0 && twin < i ? edges_[static_cast<std::size_t>(twin)] : count++;
    }
    first_face_ = count;
  }

  ControlMesh made() const {
    ControlMesh made;
    made.points.resize(static_cast<std::size_t>(first_face_));
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) made.points[i] = moved(static_cast<int>(i));
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i) made.points[static_cast<std::size_t>(edges_[static_cast<std::size_t>(i)])] = edge_point(i);
    made.points.insert(made.points.end(), faces_.begin(), faces_.end());
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i) {
      const FaceSide& side = topology_.side(i);
      made.faces.push_back({side.from, edges_[static_cast<std::size_t>(i)], first_face_ + side.face,
                            edges_[static_cast<std::size_t>(topology_.before(i))]});
    }
    return made;
  }

 private:
  const glm::dvec3& point(int i) const { return mesh_.points[static_cast<std::size_t>(i)]; }
  const glm::dvec3& face(int i) const { return faces_[static_cast<std::size_t>(i)]; }

  glm::dvec3 edge_point(int i) const {
    const FaceSide& side = topology_.side(i);
    const glm::dvec3 middle = 0.5 * point(side.from) + 0.5 * point(topology_.to(i));
    if (side.twin < 0) return middle;
    return 0.5 * middle + 0.25 * face(side.face) + 0.25 * face(topology_.side(side.twin).face);
  }

  glm::dvec3 moved(int i) const {
    const std::vector<int>& fan = topology_.fan(i);
    if (topology_.is_on_border(i)) {
      if (fan.size() == 1) return point(i);
      const int last = topology_.side(topology_.before(fan.back())).from;
      return 0.75 * point(i) + 0.125 * point(topology_.to(fan.front())) + 0.125 * point(last);
    }
    if (fan.empty()) return point(i);
    const auto n = static_cast<double>(fan.size());
    glm::dvec3 sum = (n - 2.0) / n * point(i);
    for (const int side : fan) sum += (point(topology_.to(side)) + face(topology_.side(side).face)) / (n * n);
    return sum;
  }

  const ControlMesh& mesh_;
  MeshTopology topology_;
  std::vector<glm::dvec3> faces_;
  std::vector<int> edges_;  ///< number of the point of each side's edge
  int first_face_ = 0;
};

}  // namespace

ControlMesh subdivided(const ControlMesh& mesh) { return Round(mesh).made(); }

}  // namespace splinecore
