#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <optional>

#include "base/parallel.hpp"
#include "cell_grid.hpp"
#include "face_pattern.hpp"
#include "mesh_writer.hpp"
#include "side_vertices.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {

/// Fits the cells of all panels to one another, numbers their vertices and lays faces.
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
  const std::vector<MeshSpan>& spans(std::size_t panel, Axis axis) const {
    return spans_[panel_of(panel).patch][axis == Axis::u ? 0 : 1];
  }
  void make_grids(const PatchSet& set, const Fineness& fineness, int threads);
  void fit();
  double scaled(std::size_t panel, int side, Place place) const;
  Place place_on(std::size_t panel, int side, double t) const;
  std::vector<Place> places_on(std::size_t panel, int side) const;
  void collect(std::vector<std::vector<double>>& edges) const;
  bool spread(const std::vector<std::vector<double>>& edges);
  bool is_one_place(std::size_t edge, double a, double b) const;

  std::size_t on_edge(int edge, double t) const;

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
  std::vector<std::array<std::vector<MeshSpan>, 2>> spans_;  // of each patch
  std::vector<CellGrid> grids_;  // of each panel
  std::vector<std::vector<std::pair<std::size_t, int>>> edge_sides_;  ///< of each edge: panels and their sides on it
  /// Of each edge: scaled places with a vertex, growing from 0 to 1.
  std::vector<std::vector<double>> edge_places_;
  std::vector<std::int32_t> numbers_;  ///< in the mesh, of the vertices of a grid; -1 where there is none yet
  std::int32_t middle_ = -1;           ///< the vertex in the middle of a cell
  std::vector<Place> line_;  ///< vertices inside a side of a cell
  std::vector<Spot> spots_;  ///< and inside all four
  MeshWriter writer_;
  std::optional<SideVertices> side_vertices_;
};

namespace {

/// What the faces of a cell cost, about, in steps of breathe().
constexpr std::size_t kStepsOfFaces = 1000;
/// And what it costs to cut a piece that is as curved as most.
constexpr std::size_t kStepsOfPiece = std::size_t{1} << 16;
/// Scaled places may be one where they are nearer than this, and not farther apart than this part of the span that
/// some side of the edge has there: a 2^-30th of it can hardly tell them apart.
constexpr double kOnePlace = 1e-8;
constexpr double kPartOfSpan = 0x1p-27;

MeshCell whole_of(const Panel& panel, const std::vector<MeshSpan>& u, const std::vector<MeshSpan>& v) {
  return {place_of(u, panel.u.start), place_of(u, panel.u.end), place_of(v, panel.v.start), place_of(v, panel.v.end)};
}

/// Where spans begin and end.
std::vector<Place> spans_between(Place from, Place to) {
  std::vector<Place> places;
  for (Place place = from; place <= to; place += kSpan) places.push_back(place);
  return places;
}

bool is_along_v(int side) { return side < 2; }

std::pair<Place, Place> range_along(const MeshCell& whole, int side) {
  return is_along_v(side) ? std::pair{whole.v0, whole.v1} : std::pair{whole.u0, whole.u1};
}

bool is_on_knot(Place place) { return place % kSpan == 0; }

}  // namespace

AdaptiveBuilder::AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, int threads, MeshParts& mesh)
    : mesh_(mesh), spans_(mesh_spans(set)), writer_(set, mesh) {
  make_grids(set, fineness, threads);
  fit();
  std::vector<std::size_t> counts;
  for (const std::vector<double>& places : edge_places_) counts.push_back(places.size());
  side_vertices_.emplace(mesh.panels, counts);
}

/// Cuts all panels into cells, row by row.
void AdaptiveBuilder::make_grids(const PatchSet& set, const Fineness& fineness, int threads) {
  struct Row {
    std::size_t panel;
    std::size_t number;
  };
  std::map<std::size_t, PlacedPatch> placed;
  std::deque<CellCutter> cutters;
  std::vector<Row> rows;
  std::vector<std::vector<std::vector<Cut>>> cuts;
  std::size_t work = 0;
  for (const Panel& panel : mesh_.panels) {
    const auto& spans = spans_[panel.patch];
    const bool closed_u = panel.sides[0].edge >= 0 && panel.sides[0].edge == panel.sides[1].edge;
    const bool closed_v = panel.sides[2].edge >= 0 && panel.sides[2].edge == panel.sides[3].edge;
    auto patch = placed.find(panel.patch);
    if (patch == placed.end()) {
      const NurbsPatch& given = nurbs_of(set.patch(panel.patch));
      breathe(given.points().size());
      patch = placed.try_emplace(panel.patch, given, fineness).first;
    }
    const CellCutter& cutter =
        cutters.emplace_back(patch->second, spans, whole_of(panel, spans[0], spans[1]), closed_u, closed_v);
    for (std::size_t i = 0; i < cutter.rows(); ++i) rows.push_back({cuts.size(), i});
    cuts.emplace_back(cutter.rows());
    work += kStepsOfPiece * cutter.rows() * cutter.columns();
  }
  parallel_for(rows.size(), threads_for(threads, work, rows.size()), [&](std::size_t i) {
    const Row& row = rows[i];
    cuts[row.panel][row.number] = cutters[row.panel].cuts_of_row(row.number);
  });
  for (std::size_t panel = 0; panel < cuts.size(); ++panel) {
    const auto& spans = spans_[panel_of(panel).patch];
    const MeshCell whole = whole_of(panel_of(panel), spans[0], spans[1]);
    grids_.emplace_back(spans_between(whole.u0, whole.u1), spans_between(whole.v0, whole.v1), cuts[panel]);
    cuts[panel] = {};
  }
}

double AdaptiveBuilder::scaled(std::size_t panel, int side, Place place) const {
  const std::vector<MeshSpan>& along = spans(panel, is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  if (place == from || place == to) return (place == to) != panel_of(panel).sides[side].reversed ? 1.0 : 0.0;
  const double start = parameter_at(along, from);
  const double t = (parameter_at(along, place) - start) / (parameter_at(along, to) - start);
  return panel_of(panel).sides[side].reversed ? 1.0 - t : t;
}

Place AdaptiveBuilder::place_on(std::size_t panel, int side, double t) const {
  const std::vector<MeshSpan>& along = spans(panel, is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  const double forward = panel_of(panel).sides[side].reversed ? 1.0 - t : t;
  const double start = parameter_at(along, from);
  return std::clamp(place_of(along, start + forward * (parameter_at(along, to) - start)), from, to);
}

std::vector<Place> AdaptiveBuilder::places_on(std::size_t panel, int side) const {
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  std::vector<Place> places{from};
  grids_[panel].on_border(side, from, to, places);
  places.push_back(to);
  return places;
}

/// Whether two places of an edge are one.
bool AdaptiveBuilder::is_one_place(std::size_t edge, double a, double b) const {
  constexpr double kRounding = 0x1p-51;
  const double apart = std::abs(b - a);
  if (apart <= kRounding) return true;
  if (apart > kOnePlace) return false;
  const double middle = 0.5 * (a + b);
  return std::ranges::any_of(edge_sides_[edge], [&](const auto& on) {
    const auto [panel, side] = on;
    const std::vector<MeshSpan>& along = spans(panel, is_along_v(side) ? Axis::v : Axis::u);
    const auto [from, to] = range_along(grids_[panel].whole(), side);
    const Place place = std::min(place_on(panel, side, middle), to - 1);
    return apart * (parameter_at(along, to) - parameter_at(along, from)) <=
           kPartOfSpan * along[static_cast<std::size_t>(place / kSpan)].range.length();
  });
}

/// The places of all sides of each edge.
void AdaptiveBuilder::collect(std::vector<std::vector<double>>& edges) const {
  for (std::size_t panel = 0; panel < mesh_.panels.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge < 0) continue;
      if (edges.size() <= static_cast<std::size_t>(edge)) edges.resize(edge + 1);
      for (const Place place : places_on(panel, side)) edges[edge].push_back(scaled(panel, side, place));
    }
  }
  for (std::vector<double>& places : edges) {
    std::ranges::sort(places);
    const auto edge = static_cast<std::size_t>(&places - edges.data());
    const auto same = [&](double a, double b) { return is_one_place(edge, a, b); };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    places.back() = 1.0;
  }
}

/// Gives every side all places of its edge; whether one was new.
bool AdaptiveBuilder::spread(const std::vector<std::vector<double>>& edges) {
  bool is_any_new = false;
  for (std::size_t panel = 0; panel < mesh_.panels.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge < 0) continue;
      const auto own = places_on(panel, side);
      if (own.size() == edges[edge].size()) continue;
      std::vector<double> known;
      for (const Place place : own) known.push_back(scaled(panel, side, place));
      std::ranges::sort(known);
      for (const double t : edges[edge]) {
        auto next = std::ranges::lower_bound(known, t - kOnePlace);
        while (next != known.end() && *next <= t + kOnePlace && !is_one_place(edge, t, *next)) ++next;
        if (next != known.end() && *next <= t + kOnePlace) continue;
        is_any_new |= grids_[panel].add(side, place_on(panel, side, t));
      }
    }
  }
  return is_any_new;
}

void AdaptiveBuilder::fit() {
  edge_sides_.resize(side_counts(mesh_.panels).size());
  for (std::size_t panel = 0; panel < mesh_.panels.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge >= 0) edge_sides_[edge].emplace_back(panel, side);
    }
  }
  for (bool again = true; again;) {
    for (CellGrid& grid : grids_) grid.balance();
    std::vector<std::vector<double>> edges;
    collect(edges);
    again = spread(edges);
    edge_places_ = std::move(edges);
  }
}

std::size_t AdaptiveBuilder::on_edge(int edge, double t) const {
  const std::vector<double>& places = edge_places_[edge];
  const auto next = std::ranges::lower_bound(places, t);
  if (next == places.end()) return places.size() - 1;
  const auto i = static_cast<std::size_t>(next - places.begin());
  return i > 0 && t - places[i - 1] < places[i] - t ? i - 1 : i;
}

std::int32_t AdaptiveBuilder::side_vertex(std::size_t panel, int side, const Spot& spot) {
  const int edge = panel_of(panel).sides[side].edge;
  const std::size_t number = edge < 0 ? 0 : on_edge(edge, scaled(panel, side, is_along_v(side) ? spot.v : spot.u));
  std::int32_t& vertex = side_vertices_->at(panel, side, number);
  if (vertex < 0) vertex = writer_.add_vertex(sample_at(panel, spot, grids_[panel].whole()));
  return vertex;
}

std::int32_t AdaptiveBuilder::vertex_at(std::size_t panel, const Spot& spot) {
  if (spot.vertex == kOnBorder) return border_vertex(panel, spot);
  std::int32_t& vertex = spot.vertex == kInMiddle ? middle_ : numbers_[spot.vertex];
  if (vertex < 0) vertex = writer_.add_vertex(inner_sample(panel, spot));
  return vertex;
}

std::int32_t AdaptiveBuilder::border_vertex(std::size_t panel, const Spot& spot) {
  const MeshCell& whole = grids_[panel].whole();
  if (spot.u == whole.u0) return side_vertex(panel, 0, spot);
  if (spot.u == whole.u1) return side_vertex(panel, 1, spot);
  return side_vertex(panel, spot.v == whole.v0 ? 2 : 3, spot);
}

/// Whether the first derivative may jump there.
bool AdaptiveBuilder::is_crease(std::size_t panel, Axis axis, Place place) const {
  if (!is_on_knot(place)) return false;
  const MeshCell& whole = grids_[panel].whole();
  const auto [from, to] = axis == Axis::u ? std::pair{whole.u0, whole.u1} : std::pair{whole.v0, whole.v1};
  return place == from || place == to || spans(panel, axis)[place / kSpan].is_crease;
}

/// The sample at a spot, seen from inside a cell.
std::size_t AdaptiveBuilder::sample_at(std::size_t panel, const Spot& spot, const MeshCell& cell) {
  const bool is_left_u = spot.u == cell.u1 && is_crease(panel, Axis::u, spot.u);
  const bool is_left_v = spot.v == cell.v1 && is_crease(panel, Axis::v, spot.v);
  const auto& u = spans(panel, Axis::u);
  const auto& v = spans(panel, Axis::v);
  return writer_.sample_at(panel_of(panel).patch, is_left_u ? parameter_before(u, spot.u) : parameter_at(u, spot.u),
                           is_left_v ? parameter_before(v, spot.v) : parameter_at(v, spot.v),
                           is_left_u ? Side::left : Side::right, is_left_v ? Side::left : Side::right);
}

/// The sample of a vertex inside a panel.
std::size_t AdaptiveBuilder::inner_sample(std::size_t panel, const Spot& spot) {
  // Corners of faces ask for it there as well.
  const bool may_jump = is_crease(panel, Axis::u, spot.u) || is_crease(panel, Axis::v, spot.v);
  if (may_jump) return sample_at(panel, spot, grids_[panel].whole());
  return writer_.new_sample(panel_of(panel).patch, parameter_at(spans(panel, Axis::u), spot.u),
                            parameter_at(spans(panel, Axis::v), spot.v), Side::right, Side::right);
}

void AdaptiveBuilder::add_face(std::size_t panel, const MeshCell& cell, std::span<const Spot> spots) {
  std::array<FaceCorner, 4> corners;
  std::array<char, 4> is_border{};
  std::array<std::array<bool, 2>, 4> jumps;
  const std::vector<MeshSpan>& spans_u = spans(panel, Axis::u);
  const std::vector<MeshSpan>& spans_v = spans(panel, Axis::v);
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
  for (int side = 0; side < 4; ++side) counts[side] = add_spots(grids_[panel], cell, side);
  std::array<std::span<const Spot>, 4> inside;
  std::size_t first = 0;
  for (int side = 0; side < 4; first += counts[side++]) inside[side] = std::span(spots_).subspan(first, counts[side]);
  const Spot middle{(u0 + u1) / 2, (v0 + v1) / 2, kInMiddle};
  middle_ = -1;
  face_pattern(corners, inside, middle, [&](const auto& face) { add_face(panel, cell.range, face); });
}

void AdaptiveBuilder::add_faces() {
  std::size_t count = 0;
  for (const CellGrid& grid : grids_) count += grid.cells().size();
  writer_.reserve_faces(count);
  for (std::size_t panel = 0; panel < grids_.size(); ++panel) {
    numbers_.assign(grids_[panel].inner_count(), -1);
    for (const GridCell& cell : grids_[panel].cells()) {
      breathe(kStepsOfFaces);
      add_cell(panel, cell);
    }
  }
  writer_.finish();
}

Tessellation Tessellation::adaptive(const PatchSet& set, const Fineness& fineness, int threads) {
  if (!(fineness.distance > 0.0) || !(fineness.angle > 0.0)) {
    throw InvalidShape("a tolerance of a mesh is not above 0");
  }
  MeshParts mesh(set);
  AdaptiveBuilder(set, fineness, threads, mesh).add_faces();
  place_vertices(set, mesh);
  return Tessellation(std::move(mesh));
}

}  // namespace splinecore
