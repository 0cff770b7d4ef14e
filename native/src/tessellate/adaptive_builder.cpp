#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

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
  AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, Tessellation& mesh);
  void add_faces();

 private:
  struct Spot {
    Place u;
    Place v;
  };

  const Panel& panel_of(std::size_t panel) const { return mesh_.panels_[panel]; }
  const std::vector<MeshSpan>& spans(std::size_t panel, Axis axis) const {
    return spans_[panel_of(panel).patch][axis == Axis::u ? 0 : 1];
  }
  void fit();
  double scaled(std::size_t panel, int side, Place place) const;
  Place place_on(std::size_t panel, int side, double t) const;
  Spot spot_on(std::size_t panel, int side, Place place) const;
  std::vector<Place> places_on(std::size_t panel, int side) const;
  void collect(std::vector<std::vector<double>>& edges) const;
  bool spread(const std::vector<std::vector<double>>& edges);

  std::size_t on_edge(int edge, double t) const;

  std::int32_t vertex_at(std::size_t panel, const Spot& spot);
  std::int32_t side_vertex(std::size_t panel, int side, const Spot& spot);
  std::size_t sample_at(std::size_t panel, const Spot& spot, const Cell& cell);
  bool is_crease(std::size_t panel, Axis axis, Place place) const;
  void add_cell(std::size_t panel, const Cell& cell);
  void add_face(std::size_t panel, const Cell& cell, const std::vector<Spot>& spots);

  Tessellation& mesh_;
  std::vector<std::array<std::vector<MeshSpan>, 2>> spans_;  // of each patch
  std::vector<CellGrid> grids_;  // of each panel
  /// Of each edge: scaled places with a vertex, growing from 0 to 1.
  std::vector<std::vector<double>> edge_places_;
  std::vector<std::map<std::pair<Place, Place>, std::int32_t>> inner_vertices_;
  MeshWriter writer_;
  std::optional<SideVertices> side_vertices_;
};

namespace {

/// What the faces of a cell cost, about, in steps of breathe().
constexpr std::size_t kStepsOfFaces = 2000;
/// Scaled places nearer than this are one: a 2^-30th of a span cannot tell them apart.
constexpr double kOnePlace = 1e-8;

Cell whole_of(const Panel& panel, const std::vector<MeshSpan>& u, const std::vector<MeshSpan>& v) {
  return {place_of(u, panel.u.start), place_of(u, panel.u.end), place_of(v, panel.v.start), place_of(v, panel.v.end)};
}

bool is_along_v(int side) { return side < 2; }

std::pair<Place, Place> range_along(const Cell& whole, int side) {
  return is_along_v(side) ? std::pair{whole.v0, whole.v1} : std::pair{whole.u0, whole.u1};
}

Place line_of(const Cell& whole, int side) {
  return std::array{whole.u0, whole.u1, whole.v0, whole.v1}[side];
}

}  // namespace

AdaptiveBuilder::AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, Tessellation& mesh)
    : mesh_(mesh), spans_(mesh_spans(set)), writer_(set, mesh) {
  for (const Panel& panel : mesh.panels_) {
    const NurbsPatch& patch = nurbs_of(set.patch(panel.patch));
    const auto& spans = spans_[panel.patch];
    const Cell whole = whole_of(panel, spans[0], spans[1]);
    const bool closed_u = panel.sides[0].edge >= 0 && panel.sides[0].edge == panel.sides[1].edge;
    const bool closed_v = panel.sides[2].edge >= 0 && panel.sides[2].edge == panel.sides[3].edge;
    grids_.emplace_back(whole, cells_of(patch, spans, whole, fineness, closed_u, closed_v));
  }
  inner_vertices_.resize(mesh.panels_.size());
  fit();
  std::vector<std::size_t> counts;
  for (const std::vector<double>& places : edge_places_) counts.push_back(places.size());
  side_vertices_.emplace(mesh.panels_, counts);
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

AdaptiveBuilder::Spot AdaptiveBuilder::spot_on(std::size_t panel, int side, Place place) const {
  const Place line = line_of(grids_[panel].whole(), side);
  return is_along_v(side) ? Spot{line, place} : Spot{place, line};
}

std::vector<Place> AdaptiveBuilder::places_on(std::size_t panel, int side) const {
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  std::vector<Place> places =
      grids_[panel].between(is_along_v(side) ? Axis::v : Axis::u, line_of(grids_[panel].whole(), side), from, to);
  places.insert(places.begin(), from);
  places.push_back(to);
  return places;
}

/// The places of all sides of each edge.
void AdaptiveBuilder::collect(std::vector<std::vector<double>>& edges) const {
  for (std::size_t panel = 0; panel < mesh_.panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge < 0) continue;
      if (edges.size() <= static_cast<std::size_t>(edge)) edges.resize(edge + 1);
      for (const Place place : places_on(panel, side)) edges[edge].push_back(scaled(panel, side, place));
    }
  }
  for (std::vector<double>& places : edges) {
    std::ranges::sort(places);
    const auto same = [](double a, double b) { return b - a <= kOnePlace; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    places.back() = 1.0;
  }
}

/// Gives every side all places of its edge; whether one was new.
bool AdaptiveBuilder::spread(const std::vector<std::vector<double>>& edges) {
  bool is_any_new = false;
  for (std::size_t panel = 0; panel < mesh_.panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge < 0) continue;
      const auto own = places_on(panel, side);
      if (own.size() == edges[edge].size()) continue;
      std::vector<double> known;
      for (const Place place : own) known.push_back(scaled(panel, side, place));
      std::ranges::sort(known);
      for (const double t : edges[edge]) {
        const auto next = std::ranges::lower_bound(known, t - kOnePlace);
        if (next != known.end() && *next <= t + kOnePlace) continue;
        const Spot spot = spot_on(panel, side, place_on(panel, side, t));
        is_any_new |= grids_[panel].add(Axis::u, spot.v, spot.u);
      }
    }
  }
  return is_any_new;
}

void AdaptiveBuilder::fit() {
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
  const Cell& whole = grids_[panel].whole();
  if (spot.u == whole.u0) return side_vertex(panel, 0, spot);
  if (spot.u == whole.u1) return side_vertex(panel, 1, spot);
  if (spot.v == whole.v0) return side_vertex(panel, 2, spot);
  if (spot.v == whole.v1) return side_vertex(panel, 3, spot);
  const auto [found, is_new] = inner_vertices_[panel].try_emplace({spot.u, spot.v}, -1);
  if (is_new) found->second = writer_.add_vertex(sample_at(panel, spot, grids_[panel].whole()));
  return found->second;
}

/// Whether the first derivative may jump there.
bool AdaptiveBuilder::is_crease(std::size_t panel, Axis axis, Place place) const {
  const Cell& whole = grids_[panel].whole();
  const auto [from, to] = axis == Axis::u ? std::pair{whole.u0, whole.u1} : std::pair{whole.v0, whole.v1};
  if (place == from || place == to) return true;
  if (place % kSpan != 0) return false;
  return spans(panel, axis)[place / kSpan].is_crease;
}

/// The sample at a spot, seen from inside a cell.
std::size_t AdaptiveBuilder::sample_at(std::size_t panel, const Spot& spot, const Cell& cell) {
  const bool is_left_u = spot.u == cell.u1 && is_crease(panel, Axis::u, spot.u);
  const bool is_left_v = spot.v == cell.v1 && is_crease(panel, Axis::v, spot.v);
  const auto& u = spans(panel, Axis::u);
  const auto& v = spans(panel, Axis::v);
  return writer_.sample_at(panel_of(panel).patch, is_left_u ? parameter_before(u, spot.u) : parameter_at(u, spot.u),
                           is_left_v ? parameter_before(v, spot.v) : parameter_at(v, spot.v),
                           is_left_u ? Side::left : Side::right, is_left_v ? Side::left : Side::right);
}

void AdaptiveBuilder::add_face(std::size_t panel, const Cell& cell, const std::vector<Spot>& spots) {
  std::vector<FaceCorner> corners;
  std::vector<char> is_border;
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const Spot& a = spots[k];
    const Spot& b = spots[(k + 1) % spots.size()];
    corners.push_back({vertex_at(panel, a), sample_at(panel, a, cell), parameter_at(spans(panel, Axis::u), a.u),
                       parameter_at(spans(panel, Axis::v), a.v)});
    is_border.push_back((a.u == b.u && is_crease(panel, Axis::u, a.u)) ||
                        (a.v == b.v && is_crease(panel, Axis::v, a.v)));
  }
  writer_.add_face(panel_of(panel).patch, corners, is_border);
}

void AdaptiveBuilder::add_cell(std::size_t panel, const Cell& cell) {
  const CellGrid& grid = grids_[panel];
  const auto on_side = [&](Axis axis, Place line, Place from, Place to, bool is_backward) {
    std::vector<Place> places = grid.between(axis, line, from, to);
    if (is_backward) std::ranges::reverse(places);
    std::vector<Spot> spots;
    for (const Place place : places) spots.push_back(axis == Axis::u ? Spot{place, line} : Spot{line, place});
    return spots;
  };
  const std::array<Spot, 4> corners{{{cell.u0, cell.v0}, {cell.u1, cell.v0}, {cell.u1, cell.v1}, {cell.u0, cell.v1}}};
  const std::array<std::vector<Spot>, 4> inside{
      on_side(Axis::u, cell.v0, cell.u0, cell.u1, false), on_side(Axis::v, cell.u1, cell.v0, cell.v1, false),
      on_side(Axis::u, cell.v1, cell.u0, cell.u1, true), on_side(Axis::v, cell.u0, cell.v0, cell.v1, true)};
  const Spot middle{(cell.u0 + cell.u1) / 2, (cell.v0 + cell.v1) / 2};
  for (const auto& face : face_pattern(corners, inside, middle)) add_face(panel, cell, face);
}

void AdaptiveBuilder::add_faces() {
  for (std::size_t panel = 0; panel < grids_.size(); ++panel) {
    for (const Cell& cell : grids_[panel].cells()) {
      breathe(kStepsOfFaces);
      add_cell(panel, cell);
    }
  }
  writer_.finish();
}

Tessellation Tessellation::adaptive(const PatchSet& set, const Fineness& fineness) {
  if (!(fineness.distance > 0.0) || !(fineness.angle > 0.0)) {
    throw InvalidShape("a tolerance of a mesh is not above 0");
  }
  Tessellation mesh(set);
  AdaptiveBuilder(set, fineness, mesh).add_faces();
  mesh.place_vertices(set);
  return mesh;
}

}  // namespace splinecore
