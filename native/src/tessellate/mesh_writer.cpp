#include "mesh_writer.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "splinecore/base/errors.hpp"

namespace splinecore {

std::int32_t MeshWriter::add_vertex(std::size_t sample) {
  mesh_.vertex_samples.push_back(sample);
  return static_cast<std::int32_t>(mesh_.vertex_samples.size()) - 1;
}

std::size_t MeshWriter::SampleHash::operator()(const SampleKey& key) const noexcept {
  std::size_t mixed = key.patch * 4 + (key.side_u == Side::left ? 2 : 0) + (key.side_v == Side::left ? 1 : 0);
  for (const double number : {key.u, key.v}) {
    mixed = (mixed ^ std::hash<double>()(number)) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 32;
  }
  return mixed;
}

std::size_t MeshWriter::new_sample(std::size_t patch, double u, double v, Side side_u, Side side_v) {
  const std::size_t kind = 4 * patch + (side_u == Side::left ? 2 : 0) + (side_v == Side::left ? 1 : 0);
  int& scatter = scatter_of_[kind];
  if (scatter < 0) {
    scatter = static_cast<int>(mesh_.scatters.size());
    mesh_.scatters.push_back({patch, {side_u, side_v, AtInfinity::raise}, {}, {}, 0});
  }
  MeshParts::Scatter& samples = mesh_.scatters[scatter];
  sample_places_.emplace_back(scatter, samples.u.size());
  samples.u.push_back(u);
  samples.v.push_back(v);
  return first_ + sample_places_.size() - 1;
}

std::size_t MeshWriter::sample_at(std::size_t patch, double u, double v, Side side_u, Side side_v) {
  const auto [found, is_new] = samples_.try_emplace({patch, u, v, side_u, side_v}, 0);
  if (is_new) found->second = new_sample(patch, u, v, side_u, side_v);
  return found->second;
}

void MeshWriter::reserve_faces(std::size_t count) {
  mesh_.face_starts.reserve(count);
  mesh_.face_patches.reserve(count);
  mesh_.corner_vertices.reserve(4 * count);
  mesh_.corner_samples.reserve(4 * count);
  mesh_.corner_uvs.reserve(8 * count);
  mesh_.vertex_samples.reserve(count);
  sample_places_.reserve(count);
}

void MeshWriter::add_face(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border) {
  const std::size_t count = corners.size();
  std::array<std::size_t, 4> kept;
  std::size_t kept_count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (corners[k].vertex != corners[(k + 1) % count].vertex) kept[kept_count++] = k;
  }
  if (kept_count < 3) return;
  if (kept_count == 4 && (corners[0].vertex == corners[2].vertex || corners[1].vertex == corners[3].vertex)) return;
  const auto first = static_cast<std::int32_t>(mesh_.corner_vertices.size());
  mesh_.face_starts.push_back(first);
  mesh_.face_patches.push_back(static_cast<std::int32_t>(patch));
  if (domain_patch_ != patch) {
    const NurbsPatch& form = nurbs_of(set_.patch(patch));
    domains_ = {form.knot_vector(Axis::u).domain(), form.knot_vector(Axis::v).domain()};
    domain_patch_ = patch;
  }
  const auto scaled = [](const Interval& range, double u) {
    return static_cast<float>((u - range.start) / range.length());
  };
  for (std::size_t k = 0; k < kept_count; ++k) {
    const FaceCorner& corner = corners[kept[k]];
    mesh_.corner_vertices.push_back(corner.vertex);
    mesh_.corner_samples.push_back(corner.sample);
    mesh_.corner_uvs.push_back(scaled(domains_[0], corner.u));
    mesh_.corner_uvs.push_back(scaled(domains_[1], corner.v));
  }
  for (std::size_t k = 0; k < kept_count; ++k) {
    if (!is_border[kept[k]]) continue;
    std::int32_t a = first + static_cast<std::int32_t>(k);
    std::int32_t b = first + static_cast<std::int32_t>((k + 1) % kept_count);
    if (mesh_.corner_vertices[a] > mesh_.corner_vertices[b]) std::swap(a, b);
    mesh_.seams.push_back({mesh_.corner_vertices[a], mesh_.corner_vertices[b], a, b});
  }
}

void MeshWriter::add_face_once(std::size_t patch, std::span<const FaceCorner> corners,
                               std::span<const char> is_border) {
  std::vector<std::int32_t> vertices;
  for (const FaceCorner& corner : corners) vertices.push_back(corner.vertex);
  std::ranges::sort(vertices);
  if (known_faces_.insert(std::move(vertices)).second) add_face(patch, corners, is_border);
}

void MeshWriter::finish() {
  drop_unused_vertices();
  place_samples();
  std::ranges::sort(mesh_.seams, {}, [](const Seam& seam) { return std::pair{seam.low_vertex, seam.high_vertex}; });
  if (mesh_.face_starts.empty()) {
    throw InvalidShape("the mesh would have no face: raise the resolution, or move points apart");
  }
}

void MeshWriter::drop_unused_vertices() {
  std::vector<std::int32_t> new_index(mesh_.vertex_samples.size(), -1);
  for (const std::int32_t vertex : mesh_.corner_vertices) new_index[vertex] = 0;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] < 0) continue;
    new_index[i] = static_cast<std::int32_t>(kept.size());
    kept.push_back(mesh_.vertex_samples[i]);
  }
  if (kept.size() == new_index.size()) return;
  mesh_.vertex_samples = std::move(kept);
  for (std::int32_t& vertex : mesh_.corner_vertices) vertex = new_index[vertex];
  for (Seam& seam : mesh_.seams) {
    seam.low_vertex = new_index[seam.low_vertex];
    seam.high_vertex = new_index[seam.high_vertex];
  }
}

void MeshWriter::place_samples() {
  for (MeshParts::Scatter& scatter : mesh_.scatters) {
    scatter.first_sample = mesh_.sample_count;
    mesh_.sample_count += scatter.u.size();
  }
  const auto place = [&](std::size_t& sample) {
    if (sample < first_) return;
    const auto [scatter, number] = sample_places_[sample - first_];
    sample = mesh_.scatters[scatter].first_sample + number;
  };
  std::ranges::for_each(mesh_.vertex_samples, place);
  std::ranges::for_each(mesh_.corner_samples, place);
}

}  // namespace splinecore
