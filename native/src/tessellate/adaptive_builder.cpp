#include <algorithm>
#include <array>

#include "face_pattern.hpp"
#include "fitted_panels.hpp"
#include "mesh_writer.hpp"
#include "side_vertices.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {

namespace {

/// Numbers the vertices of the cells of all panels and lays faces.
class AdaptiveBuilder {
 public:
  AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, int threads, MeshParts& mesh);
  void add_faces();

 private:
  /// A place, and the vertex of its grid that is there; on the border kOnBorder.
  struct Spot {
    Place u;
    Place v;
    std::int32_t vertex;
  };
  static constexpr std::int32_t kOnBorder = -1;
  static constexpr std::int32_t kInMiddle = -2;  ///< one that its cell alone has

  const Panel& panel_of(std::size_t panel) const { return mesh_.panels[panel]; }

  std::int32_t vertex_at(std::size_t panel, const Spot& spot);
  std::int32_t border_vertex(std::size_t panel, const Spot& spot);
  std::int32_t side_vertex(std::size_t panel, int side, const Spot& spot);
  std::size_t sample_at(std::size_t panel, const Spot& spot, const MeshCell& cell);
  bool is_crease(std::size_t panel, Axis axis, Place place) const;
  std::size_t inner_sample(std::size_t panel, const Spot& spot);
  std::size_t add_spots(const CellGrid& grid, const GridCell& cell, int side);
  void add_cell(std::size_t panel, const GridCell& cell);
  void add_face(std::size_t panel, const MeshCell& cell, std::span<const Spot> spots);

  MeshParts& mesh_;
  FittedPanels fitted_;
  std::vector<std::int32_t> numbers_;  ///< in the mesh, of the vertices of a grid; -1 where there is none yet
  std::int32_t middle_ = -1;           ///< the vertex in the middle of a cell
  std::vector<Place> line_;  ///< vertices inside a side of a cell
  std::vector<Spot> spots_;  ///< and inside all four
  MeshWriter writer_;
  SideVertices side_vertices_;
};

/// What the faces of a cell cost, about, in steps of breathe().
constexpr std::size_t kStepsOfFaces = 1000;

bool is_on_knot(Place place) { return place % kSpan == 0; }

AdaptiveBuilder::AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, int threads, MeshParts& mesh)
    : mesh_(mesh), fitted_(set, mesh.panels, fineness, threads), writer_(set, mesh),
      side_vertices_(mesh.panels, fitted_.places_of_edges()) {}

std::int32_t AdaptiveBuilder::side_vertex(std::size_t panel, int side, const Spot& spot) {
  const int edge = panel_of(panel).sides[side].edge;
  const Place place = is_along_v(side) ? spot.v : spot.u;
  const std::size_t number = edge < 0 ? 0 : fitted_.on_edge(edge, fitted_.edge_place(panel, side, place));
  std::int32_t& vertex = side_vertices_.at(panel, side, number);
  if (vertex < 0) vertex = writer_.add_vertex(sample_at(panel, spot, fitted_.grid(panel).whole()));
  return vertex;
}

std::int32_t AdaptiveBuilder::vertex_at(std::size_t panel, const Spot& spot) {
  if (spot.vertex == kOnBorder) return border_vertex(panel, spot);
  std::int32_t& vertex = spot.vertex == kInMiddle ? middle_ : numbers_[spot.vertex];
  if (vertex < 0) vertex = writer_.add_vertex(inner_sample(panel, spot));
  return vertex;
}

std::int32_t AdaptiveBuilder::border_vertex(std::size_t panel, const Spot& spot) {
  const MeshCell& whole = fitted_.grid(panel).whole();
  if (spot.u == whole.u0) return side_vertex(panel, 0, spot);
  if (spot.u == whole.u1) return side_vertex(panel, 1, spot);
  return side_vertex(panel, spot.v == whole.v0 ? 2 : 3, spot);
}

/// Whether the first derivative may jump there.
bool AdaptiveBuilder::is_crease(std::size_t panel, Axis axis, Place place) const {
  if (!is_on_knot(place)) return false;
  const MeshCell& whole = fitted_.grid(panel).whole();
  const auto [from, to] = axis == Axis::u ? std::pair{whole.u0, whole.u1} : std::pair{whole.v0, whole.v1};
  return place == from || place == to || fitted_.spans(panel, axis)[place / kSpan].is_crease;
}

/// The sample at a spot, seen from inside a cell.
std::size_t AdaptiveBuilder::sample_at(std::size_t panel, const Spot& spot, const MeshCell& cell) {
  const bool is_left_u = spot.u == cell.u1 && is_crease(panel, Axis::u, spot.u);
  const bool is_left_v = spot.v == cell.v1 && is_crease(panel, Axis::v, spot.v);
  const auto& u = fitted_.spans(panel, Axis::u);
  const auto& v = fitted_.spans(panel, Axis::v);
  return writer_.sample_at(panel_of(panel).patch, is_left_u ? parameter_before(u, spot.u) : parameter_at(u, spot.u),
                           is_left_v ? parameter_before(v, spot.v) : parameter_at(v, spot.v),
                           is_left_u ? Side::left : Side::right, is_left_v ? Side::left : Side::right);
}

/// The sample of a vertex inside a panel.
std::size_t AdaptiveBuilder::inner_sample(std::size_t panel, const Spot& spot) {
  // Corners of faces ask for it there as well.
  const bool may_jump = is_crease(panel, Axis::u, spot.u) || is_crease(panel, Axis::v, spot.v);
  if (may_jump) return sample_at(panel, spot, fitted_.grid(panel).whole());
  return writer_.new_sample(panel_of(panel).patch, parameter_at(fitted_.spans(panel, Axis::u), spot.u),
                            parameter_at(fitted_.spans(panel, Axis::v), spot.v), Side::right, Side::right);
}

void AdaptiveBuilder::add_face(std::size_t panel, const MeshCell& cell, std::span<const Spot> spots) {
  std::array<FaceCorner, 4> corners;
  std::array<char, 4> is_border{};
  std::array<std::array<bool, 2>, 4> jumps;
  const std::vector<MeshSpan>& spans_u = fitted_.spans(panel, Axis::u);
  const std::vector<MeshSpan>& spans_v = fitted_.spans(panel, Axis::v);
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const Spot& spot = spots[k];
    jumps[k] = {is_crease(panel, Axis::u, spot.u), is_crease(panel, Axis::v, spot.v)};
    const std::int32_t vertex = vertex_at(panel, spot);
    corners[k] = {vertex, jumps[k][0] || jumps[k][1] ? sample_at(panel, spot, cell) : mesh_.vertex_samples[vertex],
                  parameter_at(spans_u, spot.u), parameter_at(spans_v, spot.v)};
  }
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const Spot& next = spots[(k + 1) % spots.size()];
    is_border[k] = (jumps[k][0] && spots[k].u == next.u) || (jumps[k][1] && spots[k].v == next.v);
  }
  writer_.add_face(panel_of(panel).patch, std::span(corners).first(spots.size()),
                   std::span(is_border).first(spots.size()));
}

/// The spots with a vertex inside a side of a cell, counter-clockwise and behind those that are there; how many.
std::size_t AdaptiveBuilder::add_spots(const CellGrid& grid, const GridCell& cell, int side) {
  const auto [u0, u1, v0, v1] = cell.range;
  const bool is_along_u = side % 2 == 0;
  const Place line = std::array{v0, u1, v1, u0}[side];
  const auto add = [&](Place place, std::int32_t vertex) {
    spots_.push_back(is_along_u ? Spot{place, line, vertex} : Spot{line, place, vertex});
  };
  const auto [from, to] = is_along_u ? std::pair{u0, u1} : std::pair{v0, v1};
  if (cell.lines[side] >= 0) {
    const std::int32_t vertex = grid.middle_of(cell.lines[side]);
    if (vertex >= 0) add((from + to) / 2, vertex);
    return vertex >= 0 ? 1 : 0;
  }
  line_.clear();
  grid.on_border(std::array{2, 1, 3, 0}[side], from, to, line_);
  if (side >= 2) std::ranges::reverse(line_);
  for (const Place place : line_) add(place, kOnBorder);
  return line_.size();
}

void AdaptiveBuilder::add_cell(std::size_t panel, const GridCell& cell) {
  const auto [u0, u1, v0, v1] = cell.range;
  const std::array<Spot, 4> corners{
      {{u0, v0, cell.corners[0]}, {u1, v0, cell.corners[1]}, {u1, v1, cell.corners[2]}, {u0, v1, cell.corners[3]}}};
  spots_.clear();
  std::array<std::size_t, 4> counts{};
  for (int side = 0; side < 4; ++side) counts[side] = add_spots(fitted_.grid(panel), cell, side);
  std::array<std::span<const Spot>, 4> inside;
  std::size_t first = 0;
  for (int side = 0; side < 4; first += counts[side++]) inside[side] = std::span(spots_).subspan(first, counts[side]);
  const Spot middle{(u0 + u1) / 2, (v0 + v1) / 2, kInMiddle};
  middle_ = -1;
  face_pattern(corners, inside, middle, [&](const auto& face) { add_face(panel, cell.range, face); });
}

void AdaptiveBuilder::add_faces() {
  std::size_t count = 0;
  for (std::size_t panel = 0; panel < mesh_.panels.size(); ++panel) count += fitted_.grid(panel).cells().size();
  writer_.reserve_faces(count);
  for (std::size_t panel = 0; panel < mesh_.panels.size(); ++panel) {
    numbers_.assign(fitted_.grid(panel).inner_count(), -1);
    for (const GridCell& cell : fitted_.grid(panel).cells()) {
      breathe(kStepsOfFaces);
      add_cell(panel, cell);
    }
  }
  writer_.finish();
}

}  // namespace

Tessellation Tessellation::adaptive(const PatchSet& set, const Fineness& fineness, int threads) {
  if (!(fineness.distance > 0.0) || !(fineness.angle > 0.0)) {
    throw InvalidShape("the tolerance and the angle of a mesh must be above 0");
  }
  if (!(fineness.smallest >= 0.0)) throw InvalidShape("the smallest face of a mesh is below 0");
  MeshParts mesh(set);
  AdaptiveBuilder(set, fineness, threads, mesh).add_faces();
  place_vertices(set, mesh);
  return Tessellation(std::move(mesh));
}

}  // namespace splinecore
