#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "count_plan.hpp"
#include "mesh_writer.hpp"
#include "side_vertices.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/tessellate/tessellation.hpp"
#include "strip.hpp"

namespace splinecore {

namespace {

/// Grids of vertices on panels, and strips where two sides of an edge have other places.
class CountBuilder {
 public:
  CountBuilder(const PatchSet& set, int resolution_u, int resolution_v, MeshParts& mesh);
  void add_faces();

 private:
  using Grid = MeshParts::Grid;

  /// The lines of a grid that a panel has, both ends included, with its vertices.
  struct Block {
    std::size_t panel;
    std::array<int, 2> begin, end;
    std::array<bool, 4> is_strip{};  ///< of each side: its edge has other places than the grid
    std::vector<std::int32_t> vertices;

    int columns() const { return end[1] - begin[1] + 1; }
    std::int32_t& at(int row, int column) { return vertices[(row - begin[0]) * columns() + column - begin[1]]; }
  };
  /// A line of vertices that a strip lies along.
  struct Rail {
    std::vector<double> places;
    std::vector<FaceCorner> before;  ///< as corners of a face that ends there
    std::vector<FaceCorner> behind;
    std::vector<char> is_crease;
  };

  const Panel& panel_of(const Block& block) const { return mesh_.panels[block.panel]; }
  const Grid& grid_of(const Block& block) const { return mesh_.grids[panel_of(block).patch]; }
  void make_grids();

  Block block_of(std::size_t panel) const;
  std::size_t sample_on(const Grid& grid, int u, int v) const { return grid.first_sample + u * grid.v.samples.size() + v; }
  FaceCorner corner_on(const Grid& grid, int u, int v, std::int32_t vertex) const;
  void number(Block& block);
  void number_side(Block& block, int side);
  void add_block(Block& block);
  void add_cell(Block& block, int row, int column);
  void add_strip(Block& block, int side);
  Rail outer_rail(const Block& block, int side);
  Rail inner_rail(Block& block, int side);
  void add(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border, bool is_coarse);

  const PatchSet& set_;
  MeshParts& mesh_;
  CountPlan plan_;
  std::optional<MeshWriter> writer_;
  std::optional<SideVertices> side_vertices_;
};

/// The number of the axis that a side lies across.
int across_of(int side) { return side < 2 ? 0 : 1; }

CountBuilder::CountBuilder(const PatchSet& set, int resolution_u, int resolution_v, MeshParts& mesh)
    : set_(set), mesh_(mesh), plan_(set, mesh.panels, resolution_u, resolution_v) {
  make_grids();
  std::vector<std::size_t> counts;
  for (const std::vector<double>& places : plan_.edges()) counts.push_back(places.size());
  writer_.emplace(set, mesh);
  side_vertices_.emplace(mesh.panels, counts);
}

void CountBuilder::make_grids() {
  for (std::size_t i = 0; i < set_.patches().size(); ++i) {
    const NurbsPatch& form = nurbs_of(set_.patch(i));
    Grid grid{sample_axis(form.knot_vector(Axis::u), plan_.spans_of(i)[0], plan_.resolution_of(i)[0]),
              sample_axis(form.knot_vector(Axis::v), plan_.spans_of(i)[1], plan_.resolution_of(i)[1]),
              mesh_.sample_count};
    mesh_.sample_count += grid.u.samples.size() * grid.v.samples.size();
    mesh_.grids.push_back(std::move(grid));
  }
}

CountBuilder::Block CountBuilder::block_of(std::size_t panel) const {
  Block block;
  block.panel = panel;
  const Grid& grid = mesh_.grids[mesh_.panels[panel].patch];
  for (const int axis : {0, 1}) {
    block.begin[axis] = (axis == 0 ? grid.u : grid.v).span_starts[plan_.spans(panel, axis).first];
    block.end[axis] = block.begin[axis] + plan_.strips(panel, axis);
  }
  for (int side = 0; side < 4; ++side) block.is_strip[side] = !plan_.has_places_of_edge(panel, side);
  block.vertices.assign(static_cast<std::size_t>(block.end[0] - block.begin[0] + 1) * block.columns(), -1);
  return block;
}

/// A corner at samples of both directions.
FaceCorner CountBuilder::corner_on(const Grid& grid, int u, int v, std::int32_t vertex) const {
  return {vertex, sample_on(grid, u, v), grid.u.samples.parameter(u), grid.v.samples.parameter(v)};
}

void CountBuilder::number(Block& block) {
  for (int side = 0; side < 4; ++side) number_side(block, side);
  const Grid& grid = grid_of(block);
  for (int row = block.begin[0] + 1; row < block.end[0]; ++row) {
    for (int column = block.begin[1] + 1; column < block.end[1]; ++column) {
      block.at(row, column) = writer_->add_vertex(sample_on(grid, grid.u.last[row], grid.v.last[column]));
    }
  }
}

/// Beside a strip the ends only.
void CountBuilder::number_side(Block& block, int side) {
  const PanelSide& description = panel_of(block).sides[side];
  const Grid& grid = grid_of(block);
  const int axis = side_runs_along(side);
  const int count = block.end[axis] - block.begin[axis] + 1;
  const int line = side % 2 == 0 ? block.begin[across_of(side)] : block.end[across_of(side)];
  const auto last = description.edge < 0 ? std::size_t{0} : plan_.edges()[description.edge].size() - 1;
  for (int k = 0; k < count; ++k) {
    if (block.is_strip[side] && k > 0 && k + 1 < count) continue;
    const bool is_last = k + 1 == count;
    const std::size_t own = is_last ? last : static_cast<std::size_t>(k);
    std::int32_t& vertex = side_vertices_->at(block.panel, side, description.reversed ? last - own : own);
    const int row = axis == 0 ? block.begin[0] + k : line;
    const int column = axis == 0 ? line : block.begin[1] + k;
    if (vertex < 0) vertex = writer_->add_vertex(sample_on(grid, grid.u.last[row], grid.v.last[column]));
    block.at(row, column) = vertex;
  }
}

void CountBuilder::add(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border,
                       bool is_coarse) {
  // Only in a panel of one or two strips can a face have no vertex of its own.
  if (is_coarse) {
    writer_->add_face_once(patch, corners, is_border);
  } else {
    writer_->add_face(patch, corners, is_border);
  }
}

/// The face from a line of each direction to the next.
void CountBuilder::add_cell(Block& block, int row, int column) {
  constexpr std::size_t kSteps = 1000;
  breathe(kSteps);
  const Grid& grid = grid_of(block);
  const int u0 = grid.u.last[row];
  const int u1 = grid.u.first[row + 1];
  const int v0 = grid.v.last[column];
  const int v1 = grid.v.first[column + 1];
  const std::array<FaceCorner, 4> corners{
      corner_on(grid, u0, v0, block.at(row, column)), corner_on(grid, u1, v0, block.at(row + 1, column)),
      corner_on(grid, u1, v1, block.at(row + 1, column + 1)), corner_on(grid, u0, v1, block.at(row, column + 1))};
  const auto is_border = [&](const AxisSamples& axis, int line, int number) -> char {
    return line == block.begin[number] || line == block.end[number] || axis.is_crease(line);
  };
  const std::array<char, 4> borders{is_border(grid.v, column, 1), is_border(grid.u, row + 1, 0),
                                    is_border(grid.v, column + 1, 1), is_border(grid.u, row, 0)};
  add(panel_of(block).patch, corners, borders, block.vertices.size() <= 3 * static_cast<std::size_t>(block.columns()) ||
                                                   block.columns() <= 3);
}

/// The edge's vertices, seen from the panel.
CountBuilder::Rail CountBuilder::outer_rail(const Block& block, int side) {
  const Panel& panel = panel_of(block);
  const PanelSide& description = panel.sides[side];
  std::vector<double> places = plan_.edges()[description.edge];
  const std::size_t last = places.size() - 1;
  if (description.reversed) {
    std::ranges::reverse(places);
    for (double& t : places) t = 1.0 - t;
  }
  const Interval& range = side < 2 ? panel.v : panel.u;
  const Interval& other = side < 2 ? panel.u : panel.v;
  const double across = side % 2 == 0 ? other.start : other.end;
  const Side across_side = side % 2 == 0 ? Side::right : Side::left;
  Rail rail{places, {}, {}, std::vector<char>(places.size(), 0)};
  for (std::size_t k = 0; k <= last; ++k) {
    std::int32_t& vertex = side_vertices_->at(block.panel, side, description.reversed ? last - k : k);
    const double t = k == last ? range.end : range.start + places[k] * range.length();
    const auto corner = [&](Side along_side) -> FaceCorner {
      const auto [u, v] = side < 2 ? std::pair{across, t} : std::pair{t, across};
      const auto [side_u, side_v] =
          side < 2 ? std::pair{across_side, along_side} : std::pair{along_side, across_side};
      return {vertex, writer_->sample_at(panel.patch, u, v, side_u, side_v), u, v};
    };
    if (vertex < 0) vertex = writer_->add_vertex(corner(k == last ? Side::left : Side::right).sample);
    rail.before.push_back(corner(k == 0 ? Side::right : Side::left));
    rail.behind.push_back(corner(k == last ? Side::left : Side::right));
  }
  return rail;
}

/// The line of the grid beside a side, without its end where that lies beside another strip.
CountBuilder::Rail CountBuilder::inner_rail(Block& block, int side) {
  const Grid& grid = grid_of(block);
  const int axis = side_runs_along(side);
  const int first_side = 2 * axis;
  const bool is_start = side % 2 == 0;
  const int line = is_start ? block.begin[across_of(side)] + 1 : block.end[across_of(side)] - 1;
  const AxisSamples& across = axis == 0 ? grid.v : grid.u;
  const AxisSamples& along = axis == 0 ? grid.u : grid.v;
  const int across_sample = is_start ? across.first[line] : across.last[line];
  const Interval& range = axis == 0 ? panel_of(block).u : panel_of(block).v;
  Rail rail;
  for (int k = block.begin[axis] + block.is_strip[first_side]; k <= block.end[axis] - block.is_strip[first_side + 1]; ++k) {
    const auto corner = [&](int sample) {
      return axis == 0 ? corner_on(grid, sample, across_sample, block.at(k, line))
                       : corner_on(grid, across_sample, sample, block.at(line, k));
    };
    rail.places.push_back((along.samples.parameter(along.first[k]) - range.start) / range.length());
    rail.before.push_back(corner(along.first[k]));
    rail.behind.push_back(corner(along.last[k]));
    rail.is_crease.push_back(k == block.begin[axis] || k == block.end[axis] || along.is_crease(k));
  }
  return rail;
}

void CountBuilder::add_strip(Block& block, int side) {
  const Rail outer = outer_rail(block, side);
  const Rail inner = inner_rail(block, side);
  const Grid& grid = grid_of(block);
  const int line = side % 2 == 0 ? block.begin[across_of(side)] + 1 : block.end[across_of(side)] - 1;
  const char is_inner_border = (side < 2 ? grid.u : grid.v).is_crease(line);
  const auto is_rung_border = [&](std::size_t i, std::size_t j) -> char {
    return std::abs(outer.places[i] - inner.places[j]) <= kOneStep && inner.is_crease[j];
  };
  for (const StripFace& face : strip_faces(outer.places, inner.places)) {
    std::vector<FaceCorner> corners;
    std::vector<char> borders;
    const auto add_corner = [&](const FaceCorner& corner, char border) {
      corners.push_back(corner);
      borders.push_back(border);
    };
    const bool has_outer_edge = face.i < face.i_end;
    const bool has_inner_edge = face.j < face.j_end;
    const bool is_outer_last = !has_outer_edge && outer.places[face.i] >= inner.places[face.j_end];
    const bool is_inner_last = has_inner_edge || inner.places[face.j] >= outer.places[face.i_end];
    add_corner((is_outer_last ? outer.before : outer.behind)[face.i],
               has_outer_edge ? char{1} : is_rung_border(face.i, face.j_end));
    if (has_outer_edge) add_corner(outer.before[face.i_end], is_rung_border(face.i_end, face.j_end));
    add_corner((is_inner_last ? inner.before : inner.behind)[face.j_end],
               has_inner_edge ? is_inner_border : is_rung_border(face.i, face.j));
    if (has_inner_edge) add_corner(inner.behind[face.j], is_rung_border(face.i, face.j));
    if (side == 0 || side == 3) {
      std::ranges::reverse(corners);
      std::ranges::reverse(borders);
      std::ranges::rotate(borders, borders.begin() + 1);
    }
    writer_->add_face(panel_of(block).patch, corners, borders);
  }
}

void CountBuilder::add_block(Block& block) {
  number(block);
  const auto& strip = block.is_strip;
  for (int row = block.begin[0] + strip[0]; row < block.end[0] - strip[1]; ++row) {
    for (int column = block.begin[1] + strip[2]; column < block.end[1] - strip[3]; ++column) add_cell(block, row, column);
  }
  for (int side = 0; side < 4; ++side) {
    if (strip[side]) add_strip(block, side);
  }
}

void CountBuilder::add_faces() {
  for (std::size_t panel = 0; panel < mesh_.panels.size(); ++panel) {
    Block block = block_of(panel);
    add_block(block);
  }
  writer_->finish();
}

}  // namespace

Tessellation Tessellation::make(const PatchSet& set, int resolution_u, int resolution_v) {
  constexpr int kMaxResolution = 4096;
  constexpr double kMaxSamples = 1 << 22;
  for (const auto& [value, name] : {std::pair{resolution_u, "resolution_u"}, std::pair{resolution_v, "resolution_v"}}) {
    if (value < 1 || value > kMaxResolution) {
      throw InvalidShape(std::string(name) + " = " + std::to_string(value) + " is outside [1, " +
                         std::to_string(kMaxResolution) + "]");
    }
  }
  double expected = 0.0;
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& form = nurbs_of(set.patch(i));
    expected += (1.0 + resolution_u * static_cast<double>(form.knot_vector(Axis::u).spans().size())) *
                (1.0 + resolution_v * static_cast<double>(form.knot_vector(Axis::v).spans().size()));
  }
  if (expected > kMaxSamples) throw InvalidShape("the mesh would have more than 2^22 vertices: lower the resolution");
  MeshParts mesh(set);
  CountBuilder(set, resolution_u, resolution_v, mesh).add_faces();
  place_vertices(set, mesh);
  return Tessellation(std::move(mesh));
}

}  // namespace splinecore
