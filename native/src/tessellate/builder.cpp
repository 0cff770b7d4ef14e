#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "splinecore/base/errors.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {

/// Numbers the vertices of one patch after the other and lays faces between them.
class TessellationBuilder {
 public:
  TessellationBuilder(const PatchSet& set, Tessellation& mesh)
      : set_(set), mesh_(mesh), sides_(mesh.sides_) {}

  void add_patch(std::size_t patch);

  /// Where faces fell away, coarse meshes have vertices that no face needs.
  void drop_unused_vertices();

 private:
  using Grid = Tessellation::Grid;

  /// Rows and columns of vertex lines of the patch at hand.
  struct Lines {
    int rows;
    int columns;
    std::vector<std::int32_t> vertices;
    std::int32_t& at(int i, int j) { return vertices[i * columns + j]; }
  };

  std::optional<int> corner_row(std::size_t patch, bool end_u, bool end_v) const;
  std::size_t sample_on(const Grid& grid, int row, int column) const;
  std::int32_t new_vertex(const Grid& grid, int row, int column);
  void number_corners(std::size_t patch, const Grid& grid, Lines& lines);
  void number_side(std::size_t patch, int side, const Grid& grid, Lines& lines);
  std::int32_t add_corner(std::size_t patch, int i, int j, std::int32_t vertex);
  bool is_new_face(const Lines& lines, std::array<std::int32_t, 4> vertices);
  void add_face(std::size_t patch, Lines& lines, int i, int j);
  void add_faces(std::size_t patch, Lines& lines);
  void add_seam(std::int32_t corner_a, std::int32_t corner_b);

  const PatchSet& set_;
  Tessellation& mesh_;
  const std::vector<std::array<PatchSide, 4>>& sides_;
  std::map<int, std::int32_t> corner_vertices_;
  std::set<std::array<std::int32_t, 4>> coarse_faces_;
  /// By edge and number of vertices: an edge that has two resolutions has its corners in common.
  std::map<std::pair<int, int>, std::vector<std::int32_t>> edge_vertices_;
};

/// The pool row that a corner of the patch lies on, if it lies on one.
std::optional<int> TessellationBuilder::corner_row(std::size_t patch, bool end_u, bool end_v) const {
  const PatchSide& side_u = sides_[patch][end_u ? 1 : 0];
  const PatchSide& side_v = sides_[patch][end_v ? 3 : 2];
  if (side_u.kind == EdgeKind::open || side_v.kind == EdgeKind::open) return std::nullopt;
  const IndexedPatch& indexed = set_.patches()[patch];
  // A pole is one vertex: its first point stands for both of its corners.
  const int i = end_u && side_v.kind != EdgeKind::pole ? indexed.count_u - 1 : 0;
  const int j = end_v && side_u.kind != EdgeKind::pole ? indexed.count_v - 1 : 0;
  return mesh_.first_equal_[indexed.indices[i * indexed.count_v + j]];
}

/// The first sample on a pair of lines.
std::size_t TessellationBuilder::sample_on(const Grid& grid, int row, int column) const {
  const auto i = std::ranges::find(grid.u.line, row) - grid.u.line.begin();
  const auto j = std::ranges::find(grid.v.line, column) - grid.v.line.begin();
  return grid.first_sample + i * grid.v.samples.size() + j;
}

std::int32_t TessellationBuilder::new_vertex(const Grid& grid, int row, int column) {
  mesh_.vertex_samples_.push_back(sample_on(grid, row, column));
  return static_cast<std::int32_t>(mesh_.vertex_samples_.size()) - 1;
}

void TessellationBuilder::number_corners(std::size_t patch, const Grid& grid, Lines& lines) {
  for (const bool end_u : {false, true}) {
    for (const bool end_v : {false, true}) {
      const auto pool_row = corner_row(patch, end_u, end_v);
      if (!pool_row) continue;
      const int row = end_u ? lines.rows - 1 : 0;
      const int column = end_v ? lines.columns - 1 : 0;
      const auto known = corner_vertices_.find(*pool_row);
      lines.at(row, column) = known != corner_vertices_.end()
                                  ? known->second
                                  : corner_vertices_[*pool_row] = new_vertex(grid, row, column);
    }
  }
}

void TessellationBuilder::number_side(std::size_t patch, int side, const Grid& grid, Lines& lines) {
  const PatchSide& description = sides_[patch][side];
  if (description.kind == EdgeKind::open) return;
  const bool along_v = side < 2;
  const int count = along_v ? lines.columns : lines.rows;
  const int fixed = side % 2 == 0 ? 0 : (along_v ? lines.rows : lines.columns) - 1;
  const auto place = [&](int k) { return along_v ? std::pair{fixed, k} : std::pair{k, fixed}; };
  const auto vertex = [&](int k) -> std::int32_t& { return lines.at(place(k).first, place(k).second); };
  const auto number_new = [&](int k) {
    if (vertex(k) < 0) vertex(k) = new_vertex(grid, place(k).first, place(k).second);
    return vertex(k);
  };
  if (description.kind == EdgeKind::pole) {
    for (int k = 0; k < count; ++k) vertex(k) = number_new(0);
    return;
  }
  std::vector<std::int32_t>& known = edge_vertices_[{description.edge, count}];
  const auto on_edge = [&](int k) { return description.reversed ? count - 1 - k : k; };
  if (known.empty()) {
    known.resize(count);
    for (int k = 0; k < count; ++k) known[on_edge(k)] = number_new(k);
    return;
  }
  for (int k = 0; k < count; ++k) {
    if (vertex(k) < 0) vertex(k) = known[on_edge(k)];
  }
}

void TessellationBuilder::add_seam(std::int32_t corner_a, std::int32_t corner_b) {
  if (mesh_.corner_vertices_[corner_a] > mesh_.corner_vertices_[corner_b]) std::swap(corner_a, corner_b);
  mesh_.seams_.push_back({mesh_.corner_vertices_[corner_a], mesh_.corner_vertices_[corner_b], corner_a, corner_b});
}

namespace {

/// Which corner of a quad stands for each one: on a pole two are one.
std::array<int, 4> distinct_corners(const std::array<std::int32_t, 4>& vertices) {
  std::array<int, 4> same{0, 1, 2, 3};
  for (int k = 1; k < 4; ++k) {
    if (vertices[k] == vertices[k - 1]) same[k] = same[k - 1];
  }
  if (same[3] == 3 && vertices[3] == vertices[0]) same[3] = 0;
  return same;
}

}  // namespace

std::int32_t TessellationBuilder::add_corner(std::size_t patch, int i, int j, std::int32_t vertex) {
  const Grid& grid = mesh_.grids_[patch];
  const NurbsPatch& form = nurbs_of(set_.patch(patch));
  const auto scaled = [&](Axis axis, double u) {
    const Interval range = form.knot_vector(axis).domain();
    return static_cast<float>((u - range.start) / range.length());
  };
  mesh_.corner_vertices_.push_back(vertex);
  mesh_.corner_samples_.push_back(grid.first_sample + i * grid.v.samples.size() + j);
  mesh_.corner_uvs_.push_back(scaled(Axis::u, grid.u.samples.parameter(i)));
  mesh_.corner_uvs_.push_back(scaled(Axis::v, grid.v.samples.parameter(j)));
  return static_cast<std::int32_t>(mesh_.corner_vertices_.size()) - 1;
}

/// Whether no face with these vertices is there, and none of them is met twice. Only in a patch of
/// one strip, or of two, can a face have no vertex of its own.
bool TessellationBuilder::is_new_face(const Lines& lines, std::array<std::int32_t, 4> vertices) {
  if (vertices[0] == vertices[2] || vertices[1] == vertices[3]) return false;
  if (std::min(lines.rows, lines.columns) > 3) return true;
  std::ranges::sort(vertices);
  return coarse_faces_.insert(vertices).second;
}

/// The face from sample (i, j) to the next ones, unless it has shrunk to an edge.
void TessellationBuilder::add_face(std::size_t patch, Lines& lines, int i, int j) {
  const Grid& grid = mesh_.grids_[patch];
  // Counter-clockwise seen from where S_u x S_v points.
  const std::array<std::pair<int, int>, 4> around{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
  std::array<std::int32_t, 4> vertices;
  for (int k = 0; k < 4; ++k) vertices[k] = lines.at(grid.u.line[around[k].first], grid.v.line[around[k].second]);
  const std::array<int, 4> same = distinct_corners(vertices);
  const auto merged = (same[1] != 1) + (same[2] != 2) + (same[3] != 3);
  if (merged > 1 || !is_new_face(lines, vertices)) return;
  mesh_.face_starts_.push_back(static_cast<std::int32_t>(mesh_.corner_vertices_.size()));
  mesh_.face_patches_.push_back(static_cast<std::int32_t>(patch));
  std::array<std::int32_t, 4> corners;
  for (int k = 0; k < 4; ++k) {
    corners[k] = same[k] == k ? add_corner(patch, around[k].first, around[k].second, vertices[k]) : corners[same[k]];
  }
  const auto seam_if = [&](bool border, int k, int l) {
    if (border && same[k] != same[l]) add_seam(corners[k], corners[l]);
  };
  seam_if(i == 0 || !grid.u.face_follows[i - 1], 0, 3);
  seam_if(!grid.u.face_follows[i + 1], 1, 2);
  seam_if(j == 0 || !grid.v.face_follows[j - 1], 0, 1);
  seam_if(!grid.v.face_follows[j + 1], 3, 2);
}

void TessellationBuilder::add_faces(std::size_t patch, Lines& lines) {
  const Grid& grid = mesh_.grids_[patch];
  for (int i = 0; i < static_cast<int>(grid.u.samples.size()); ++i) {
    for (int j = 0; j < static_cast<int>(grid.v.samples.size()); ++j) {
      if (grid.u.face_follows[i] && grid.v.face_follows[j]) add_face(patch, lines, i, j);
    }
  }
}

void TessellationBuilder::add_patch(std::size_t patch) {
  const Grid& grid = mesh_.grids_[patch];
  Lines lines{grid.u.line_count, grid.v.line_count, {}};
  lines.vertices.assign(static_cast<std::size_t>(lines.rows) * lines.columns, -1);
  number_corners(patch, grid, lines);
  for (int side = 0; side < 4; ++side) number_side(patch, side, grid, lines);
  for (int row = 0; row < lines.rows; ++row) {
    for (int column = 0; column < lines.columns; ++column) {
      if (lines.at(row, column) < 0) lines.at(row, column) = new_vertex(grid, row, column);
    }
  }
  add_faces(patch, lines);
}

void TessellationBuilder::drop_unused_vertices() {
  std::vector<std::int32_t> new_index(mesh_.vertex_samples_.size(), -1);
  for (const std::int32_t vertex : mesh_.corner_vertices_) new_index[vertex] = 0;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] < 0) continue;
    new_index[i] = static_cast<std::int32_t>(kept.size());
    kept.push_back(mesh_.vertex_samples_[i]);
  }
  if (kept.size() == new_index.size()) return;
  mesh_.vertex_samples_ = std::move(kept);
  for (std::int32_t& vertex : mesh_.corner_vertices_) vertex = new_index[vertex];
  for (Tessellation::Seam& seam : mesh_.seams_) {
    seam.low_vertex = new_index[seam.low_vertex];
    seam.high_vertex = new_index[seam.high_vertex];
  }
}

Tessellation Tessellation::make(const PatchSet& set, int resolution_u, int resolution_v) {
  constexpr int kMaxResolution = 4096;
  constexpr double kMaxSamples = 1 << 22;
  for (const auto& [value, name] : {std::pair{resolution_u, "resolution_u"}, std::pair{resolution_v, "resolution_v"}}) {
    if (value < 1 || value > kMaxResolution) {
      throw InvalidShape(std::string(name) + " = " + std::to_string(value) + " is outside [1, " +
                         std::to_string(kMaxResolution) + "]");
    }
  }
  Tessellation mesh;
  mesh.patches_.assign(set.patches().begin(), set.patches().end());
  mesh.first_equal_ = first_equal_rows(set);
  mesh.sides_ = patch_sides(set);
  double expected = 0.0;
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& form = nurbs_of(set.patch(i));
    expected += (1.0 + resolution_u * static_cast<double>(form.knot_vector(Axis::u).spans().size())) *
                (1.0 + resolution_v * static_cast<double>(form.knot_vector(Axis::v).spans().size()));
  }
  if (expected > kMaxSamples) throw InvalidShape("the mesh would have more than 2^22 vertices: lower the resolution");
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& form = nurbs_of(set.patch(i));
    Grid grid{sample_axis(form.knot_vector(Axis::u), resolution_u),
              sample_axis(form.knot_vector(Axis::v), resolution_v), mesh.sample_count_};
    mesh.sample_count_ += grid.u.samples.size() * grid.v.samples.size();
    mesh.grids_.push_back(std::move(grid));
  }
  TessellationBuilder builder(set, mesh);
  for (std::size_t i = 0; i < mesh.grids_.size(); ++i) builder.add_patch(i);
  builder.drop_unused_vertices();
  std::ranges::sort(mesh.seams_, {}, [](const Seam& seam) { return std::pair{seam.low_vertex, seam.high_vertex}; });
  if (mesh.face_starts_.empty()) {
    throw InvalidShape("the mesh would have no face: raise the resolution, or move points apart");
  }
  return mesh;
}

}  // namespace splinecore
