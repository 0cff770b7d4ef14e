#include "splinecore/tessellate/tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "mesh_parts.hpp"

namespace splinecore {

namespace {

/// x, y, z of each of the samples.
void gather(std::span<const std::size_t> samples, std::span<const double> from, std::span<float> to) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) to[3 * i + axis] = static_cast<float>(from[3 * samples[i] + axis]);
  }
}

/// Whether the sides of panels lie on one another in the same way, whatever numbers and directions their edges have.
bool meet_alike(const std::vector<Panel>& panels, const std::vector<Panel>& others) {
  const auto same_parts = [](const Panel& a, const Panel& b) { return a.patch == b.patch && a.u == b.u && a.v == b.v; };
  if (!std::ranges::equal(panels, others, same_parts)) return false;
  struct Match {
    int edge = -1;
    bool is_turned = false;
    bool operator==(const Match&) const = default;
  };
  std::vector<Match> match_of(4 * panels.size());
  std::vector<char> is_taken(4 * panels.size(), 0);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (std::size_t side = 0; side < 4; ++side) {
      const PanelSide& a = panels[i].sides[side];
      const PanelSide& b = others[i].sides[side];
      if ((a.edge < 0) != (b.edge < 0)) return false;
      if (a.edge < 0) continue;
      const Match match{b.edge, a.reversed != b.reversed};
      if (match_of[a.edge].edge < 0 && !is_taken[b.edge]) {
        match_of[a.edge] = match;
        is_taken[b.edge] = 1;
      }
      if (match_of[a.edge] != match) return false;
    }
  }
  return true;
}

}  // namespace

Tessellation::Tessellation(MeshParts parts) : parts_(std::make_shared<const MeshParts>(std::move(parts))) {}

std::size_t Tessellation::vertex_count() const noexcept { return parts_->vertex_samples.size(); }

std::span<const std::int32_t> Tessellation::face_starts() const noexcept { return parts_->face_starts; }

std::span<const std::int32_t> Tessellation::face_patches() const noexcept { return parts_->face_patches; }

std::span<const std::int32_t> Tessellation::corner_vertices() const noexcept { return parts_->corner_vertices; }

std::span<const float> Tessellation::corner_uvs() const noexcept { return parts_->corner_uvs; }

bool Tessellation::fits(const PatchSet& set) const {
  return has_patches_of(set) && meet_alike(parts_->panels, panels_of(set));
}

bool Tessellation::has_patches_of(const PatchSet& set) const {
  return parts_->patches == set.topology() || *parts_->patches == *set.topology();
}

bool Tessellation::still_fits(const PatchSet& set, const PatchSet& before) const {
  const auto is_loose = [&](std::size_t row) {
    return row < parts_->loose.size() && parts_->loose[row] &&
           std::memcmp(&set.points()[row], &before.points()[row], sizeof(glm::dvec4)) != 0;
  };
  const std::size_t count = std::min(set.points().size(), before.points().size());
  for (std::size_t row = 0; row < count; ++row) {
    if (is_loose(row)) return fits(set);
  }
  return true;
}

void Tessellation::evaluate(const PatchSet& set, std::span<float> positions,
                            std::span<float> corner_normals) const {
  std::vector<double> points(3 * parts_->sample_count);
  std::vector<double> normals(3 * parts_->sample_count);
  for (std::size_t i = 0; i < parts_->grids.size(); ++i) {
    const MeshParts::Grid& grid = parts_->grids[i];
    const std::size_t size = 3 * grid.u.samples.size() * grid.v.samples.size();
    evaluate_grid_with_normals(nurbs_of(set.patch(i)), grid.u.samples, grid.v.samples,
                               std::span(points).subspan(3 * grid.first_sample, size),
                               std::span(normals).subspan(3 * grid.first_sample, size));
  }
  for (const MeshParts::Scatter& scatter : parts_->scatters) {
    const std::size_t size = 3 * scatter.u.size();
    evaluate_with_normals(nurbs_of(set.patch(scatter.patch)), scatter.u, scatter.v,
                          std::span(points).subspan(3 * scatter.first_sample, size),
                          std::span(normals).subspan(3 * scatter.first_sample, size), scatter.sides);
  }
  gather(parts_->vertex_samples, points, positions);
  gather(parts_->corner_samples, normals, corner_normals);
  for (float& number : corner_normals) number = std::isnan(number) ? 0.0F : number;
}

std::vector<std::int32_t> Tessellation::sharp_edges(std::span<const float> corner_normals, double angle) const {
  const auto normal = [&](std::int32_t corner) {
    return glm::dvec3(corner_normals[3 * corner], corner_normals[3 * corner + 1], corner_normals[3 * corner + 2]);
  };
  const auto apart = [&](std::int32_t a, std::int32_t b) {
    const glm::dvec3 na = normal(a);
    const glm::dvec3 nb = normal(b);
    return std::atan2(glm::length(glm::cross(na, nb)), glm::dot(na, nb)) > angle;
  };
  std::vector<std::int32_t> sharp;
  // Seams are sorted by vertices, so the sides of one edge are neighbors.
  for (std::size_t i = 1; i < parts_->seams.size(); ++i) {
    const MeshParts::Seam& a = parts_->seams[i - 1];
    const MeshParts::Seam& b = parts_->seams[i];
    if (a.low_vertex != b.low_vertex || a.high_vertex != b.high_vertex) continue;
    if (!apart(a.low_corner, b.low_corner) && !apart(a.high_corner, b.high_corner)) continue;
    const bool known = sharp.size() >= 2 && sharp[sharp.size() - 2] == a.low_vertex && sharp.back() == a.high_vertex;
    if (!known) sharp.insert(sharp.end(), {a.low_vertex, a.high_vertex});
  }
  return sharp;
}

}  // namespace splinecore
