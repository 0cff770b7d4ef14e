#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore::testing {

/// A tessellation with its positions and normals.
struct Mesh {
  Tessellation topology;
  std::vector<float> positions;
  std::vector<float> normals;

  Mesh(const PatchSet& set, int resolution_u, int resolution_v)
      : topology(Tessellation::make(set, resolution_u, resolution_v)), positions(3 * topology.vertex_count()),
        normals(3 * topology.corner_vertices().size()) {
    topology.evaluate(set, positions, normals);
  }
  std::size_t faces() const { return topology.face_starts().size(); }
  std::span<const std::int32_t> face(std::size_t i) const {
    const auto corners = topology.corner_vertices();
    const std::size_t start = topology.face_starts()[i];
    return corners.subspan(start, (i + 1 < faces() ? topology.face_starts()[i + 1] : corners.size()) - start);
  }
  glm::dvec3 position(std::int32_t i) const { return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}; }
  glm::dvec3 normal(std::size_t i) const { return {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}; }

  /// How many faces lie on each edge.
  std::map<std::pair<std::int32_t, std::int32_t>, int> edges() const {
    std::map<std::pair<std::int32_t, std::int32_t>, int> found;
    for (std::size_t i = 0; i < faces(); ++i) {
      for (std::size_t k = 0; k < face(i).size(); ++k)
        ++found[std::minmax(face(i)[k], face(i)[(k + 1) % face(i).size()])];
    }
    return found;
  }
  long euler() const { return static_cast<long>(topology.vertex_count() - edges().size() + faces()); }
  bool is_closed() const {
    return std::ranges::all_of(edges(), [](const auto& edge) { return edge.second == 2; });
  }
};

inline glm::dvec3 face_normal(const Mesh& mesh, std::size_t i) {
  glm::dvec3 sum(0.0);
  const auto face = mesh.face(i);
  for (std::size_t k = 0; k < face.size(); ++k)
    sum += glm::cross(mesh.position(face[k]), mesh.position(face[(k + 1) % face.size()]));
  return sum;
}

inline void expect_faces_along_normals(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const std::size_t start = mesh.topology.face_starts()[i];
    for (std::size_t k = 0; k < mesh.face(i).size(); ++k)
      EXPECT_GT(glm::dot(face_normal(mesh, i), mesh.normal(start + k)), 0.0) << i;
  }
}

}  // namespace splinecore::testing
