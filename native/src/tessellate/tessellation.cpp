#include "splinecore/tessellate/tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "splinecore/patch/evaluate.hpp"

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

Tessellation::Tessellation(const PatchSet& set) : patches_(set.topology()), panels_(panels_of(set)) {}

bool Tessellation::fits(const PatchSet& set) const {
  return has_patches_of(set) && meet_alike(panels_, panels_of(set));
}

bool Tessellation::has_patches_of(const PatchSet& set) const {
  return patches_ == set.topology() || *patches_ == *set.topology();
}

bool Tessellation::still_fits(const PatchSet& set, const PatchSet& before) const {
  const auto is_loose = [&](std::size_t row) {
    return row < loose_.size() && loose_[row] &&
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
  std::vector<double> points(3 * sample_count_);
  std::vector<double> normals(3 * sample_count_);
  for (std::size_t i = 0; i < grids_.size(); ++i) {
    const Grid& grid = grids_[i];
    const std::size_t size = 3 * grid.u.samples.size() * grid.v.samples.size();
    evaluate_grid_with_normals(nurbs_of(set.patch(i)), grid.u.samples, grid.v.samples,
                               std::span(points).subspan(3 * grid.first_sample, size),
                               std::span(normals).subspan(3 * grid.first_sample, size));
  }
  for (const Scatter& scatter : scatters_) {
    const std::size_t size = 3 * scatter.u.size();
    evaluate_with_normals(nurbs_of(set.patch(scatter.patch)), scatter.u, scatter.v,
                          std::span(points).subspan(3 * scatter.first_sample, size),
                          std::span(normals).subspan(3 * scatter.first_sample, size), scatter.sides);
  }
  gather(vertex_samples_, points, positions);
  gather(corner_samples_, normals, corner_normals);
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
  // seams_ is sorted by vertices, so the sides of one edge are neighbours.
  for (std::size_t i = 1; i < seams_.size(); ++i) {
    const Seam& a = seams_[i - 1];
    const Seam& b = seams_[i];
    if (a.low_vertex != b.low_vertex || a.high_vertex != b.high_vertex) continue;
    if (!apart(a.low_corner, b.low_corner) && !apart(a.high_corner, b.high_corner)) continue;
    const bool known = sharp.size() >= 2 && sharp[sharp.size() - 2] == a.low_vertex && sharp.back() == a.high_vertex;
    if (!known) sharp.insert(sharp.end(), {a.low_vertex, a.high_vertex});
  }
  return sharp;
}

}  // namespace splinecore
