#include "mesh_checks.hpp"

#include <numbers>

#include "finding.hpp"

namespace splinecore::fuzz {

namespace {

/// Larger meshes are not evaluated: that takes ten times as long as to make them.
constexpr std::size_t kManyVertices = 5000;

void check_indices(const Tessellation& mesh, const PatchSet& set) {
  const auto starts = mesh.face_starts();
  const auto corners = mesh.corner_vertices();
  demand(!starts.empty() && starts.front() == 0, "the first face does not start at 0");
  demand(static_cast<std::size_t>(starts.back()) <= corners.size(), "a face starts behind the corners");
  for (std::size_t i = 1; i < starts.size(); ++i) demand(starts[i] >= starts[i - 1] + 3, "a face has two corners");
  for (const std::int32_t vertex : corners) {
    demand(vertex >= 0 && static_cast<std::size_t>(vertex) < mesh.vertex_count(), "a corner names no vertex");
  }
  for (const std::int32_t patch : mesh.face_patches()) {
    demand(patch >= 0 && static_cast<std::size_t>(patch) < set.patches().size(), "a face names no patch");
  }
  demand(mesh.corner_uvs().size() == 2 * corners.size(), "uvs and corners differ in number");
  for (const float uv : mesh.corner_uvs()) demand(uv >= 0.0F && uv <= 1.0F, "a uv lies outside [0, 1]");
}

}  // namespace

void check_mesh(const Tessellation& mesh, const PatchSet& set) {
  check_indices(mesh, set);
  demand(mesh.fits(set), "a mesh does not fit what it was made for");
  if (mesh.vertex_count() > kManyVertices) return;
  std::vector<float> positions(3 * mesh.vertex_count());
  std::vector<float> normals(3 * mesh.corner_vertices().size());
  mesh.evaluate(set, positions, normals);
  std::vector<float> again(positions.size());
  mesh.evaluate_positions(set, again);
  demand(positions == again, "positions without normals are others");
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const float size = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
    demand(size == 0.0F || std::abs(size - 1.0F) < 1e-3F, "a normal has length " + std::to_string(size));
  }
  for (const std::int32_t vertex : mesh.sharp_edges(normals, 0.5)) {
    demand(vertex >= 0 && static_cast<std::size_t>(vertex) < mesh.vertex_count(), "a sharp edge names no vertex");
  }
}

void check_small_meshes(const PatchSet& set, bool is_adaptive) {
  attempt([&] { check_mesh(Tessellation::make(set, 2, 3), set); });
  if (is_adaptive) attempt([&] { check_mesh(Tessellation::adaptive(set, {0.5, std::numbers::pi / 6}), set); });
}

}  // namespace splinecore::fuzz
