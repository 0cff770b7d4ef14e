#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "face_pattern.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/tessellate/panels.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {

/// Fits the cells of all panels to one another, numbers their vertices and lays faces.
class AdaptiveBuilder {
 public:
  AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, double tolerance, Tessellation& mesh);

  void fit();
  void number_edges();
  void add_faces();

 private:
  struct Spot {
    Place u;
    Place v;
  };

  const NurbsPatch& patch_of(std::size_t panel) const { return nurbs_of(set_.patch(panels_[panel].patch)); }
  double scaled(std::size_t panel, int side, Place place) const;
  Place place_on(std::size_t panel, int side, double t) const;
  Spot spot_on(std::size_t panel, int side, Place place) const;
  std::vector<Place> places_on(std::size_t panel, int side) const;
  void collect(std::vector<std::vector<double>>& edges) const;
  bool spread(const std::vector<std::vector<double>>& edges);

  int corner_node(std::size_t panel, int side, bool at_end) const;
  int root(int node);
  void join_corners();
  std::size_t on_edge(int edge, double t) const;

  std::int32_t vertex_at(std::size_t panel, const Spot& spot);
  std::int32_t side_vertex(std::size_t panel, int side, const Spot& spot);
  std::int32_t new_vertex(std::size_t panel, const Spot& spot);
  std::size_t sample_at(std::size_t panel, const Spot& spot, const Cell& cell);
  bool is_crease(std::size_t panel, Axis axis, Place place) const;
  void add_cell(std::size_t panel, const Cell& cell);
  void add_face(std::size_t panel, const Cell& cell, const std::vector<Spot>& spots);
  void add_seam(std::int32_t corner_a, std::int32_t corner_b);

  const PatchSet& set_;
  Tessellation& mesh_;
  std::vector<Panel> panels_;
  std::vector<CellGrid> grids_;
  /// Of each edge: scaled places with a vertex, growing from 0 to 1, and the vertices, -1 where not made yet.
  std::vector<std::vector<double>> edge_places_;
  std::vector<std::vector<std::int32_t>> edge_vertices_;
  /// Ends of edges, two for each, and then sides that are points, one for each: which of them are one vertex.
  std::vector<int> nodes_;
  std::vector<std::int32_t> node_vertices_;
  std::vector<std::map<std::pair<Place, Place>, std::int32_t>> inner_vertices_;
  std::map<std::tuple<std::size_t, Place, Place, Side, Side>, std::size_t> samples_;
  std::map<std::tuple<std::size_t, Side, Side>, std::size_t> scatter_of_;
  std::vector<std::pair<std::size_t, std::size_t>> sample_places_;  // scatter, number in it
};

namespace {

/// Scaled places nearer than this are one: a 2^-30th of a span cannot tell them apart.
constexpr double kOnePlace = 1e-8;



bool is_along_v(int side) { return side < 2; }

std::pair<Place, Place> range_along(const Cell& whole, int side) {
  return is_along_v(side) ? std::pair{whole.v0, whole.v1} : std::pair{whole.u0, whole.u1};
}

Place line_of(const Cell& whole, int side) {
  return std::array{whole.u0, whole.u1, whole.v0, whole.v1}[side];
}

}  // namespace

AdaptiveBuilder::AdaptiveBuilder(const PatchSet& set, const Fineness& fineness, double tolerance, Tessellation& mesh)
    : set_(set), mesh_(mesh), panels_(panels_of(set, tolerance)) {
  for (const Panel& panel : panels_) {
    const NurbsPatch& patch = nurbs_of(set.patch(panel.patch));
    const bool closed_u = panel.sides[0].edge >= 0 && panel.sides[0].edge == panel.sides[1].edge;
    const bool closed_v = panel.sides[2].edge >= 0 && panel.sides[2].edge == panel.sides[3].edge;
    grids_.emplace_back(panel.whole, cells_of(patch, panel.whole, fineness, closed_u, closed_v));
  }
  inner_vertices_.resize(panels_.size());
}

double AdaptiveBuilder::scaled(std::size_t panel, int side, Place place) const {
  const KnotVector& knots = patch_of(panel).knot_vector(is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(panels_[panel].whole, side);
  if (place == from || place == to) return (place == to) != panels_[panel].sides[side].reversed ? 1.0 : 0.0;
  const double start = parameter_at(knots, from);
  const double t = (parameter_at(knots, place) - start) / (parameter_at(knots, to) - start);
  return panels_[panel].sides[side].reversed ? 1.0 - t : t;
}

Place AdaptiveBuilder::place_on(std::size_t panel, int side, double t) const {
  const KnotVector& knots = patch_of(panel).knot_vector(is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(panels_[panel].whole, side);
  const double forward = panels_[panel].sides[side].reversed ? 1.0 - t : t;
  const double start = parameter_at(knots, from);
  return std::clamp(place_of(knots, start + forward * (parameter_at(knots, to) - start)), from, to);
}

AdaptiveBuilder::Spot AdaptiveBuilder::spot_on(std::size_t panel, int side, Place place) const {
  const Place line = line_of(panels_[panel].whole, side);
  return is_along_v(side) ? Spot{line, place} : Spot{place, line};
}

std::vector<Place> AdaptiveBuilder::places_on(std::size_t panel, int side) const {
  const auto [from, to] = range_along(panels_[panel].whole, side);
  std::vector<Place> places =
      grids_[panel].between(is_along_v(side) ? Axis::v : Axis::u, line_of(panels_[panel].whole, side), from, to);
  places.insert(places.begin(), from);
  places.push_back(to);
  return places;
}

/// The places of all sides of each edge.
void AdaptiveBuilder::collect(std::vector<std::vector<double>>& edges) const {
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panels_[panel].sides[side].edge;
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
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panels_[panel].sides[side].edge;
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

/// The node of a side's end; a side that is a point has one.
int AdaptiveBuilder::corner_node(std::size_t panel, int side, bool at_end) const {
  const PanelSide& description = panels_[panel].sides[side];
  if (description.edge < 0) return static_cast<int>(2 * edge_places_.size() + 4 * panel) + side;
  return 2 * description.edge + (at_end != description.reversed ? 1 : 0);
}

int AdaptiveBuilder::root(int node) {
  while (nodes_[node] != node) node = nodes_[node] = nodes_[nodes_[node]];
  return node;
}

void AdaptiveBuilder::join_corners() {
  nodes_.resize(2 * edge_places_.size() + 4 * panels_.size());
  std::iota(nodes_.begin(), nodes_.end(), 0);
  node_vertices_.assign(nodes_.size(), -1);
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (const bool end_u : {false, true}) {
      for (const bool end_v : {false, true}) {
        const int a = corner_node(panel, end_u ? 1 : 0, end_v);
        const int b = corner_node(panel, end_v ? 3 : 2, end_u);
        nodes_[root(a)] = root(b);
      }
    }
  }
}

void AdaptiveBuilder::number_edges() {
  join_corners();
  for (const std::vector<double>& places : edge_places_) edge_vertices_.emplace_back(places.size(), -1);
}

std::size_t AdaptiveBuilder::on_edge(int edge, double t) const {
  const std::vector<double>& places = edge_places_[edge];
  const auto next = std::ranges::lower_bound(places, t);
  if (next == places.end()) return places.size() - 1;
  const auto i = static_cast<std::size_t>(next - places.begin());
  return i > 0 && t - places[i - 1] < places[i] - t ? i - 1 : i;
}

std::int32_t AdaptiveBuilder::new_vertex(std::size_t panel, const Spot& spot) {
  mesh_.vertex_samples_.push_back(sample_at(panel, spot, panels_[panel].whole));
  return static_cast<std::int32_t>(mesh_.vertex_samples_.size()) - 1;
}

std::int32_t AdaptiveBuilder::side_vertex(std::size_t panel, int side, const Spot& spot) {
  const auto [from, to] = range_along(panels_[panel].whole, side);
  const Place place = is_along_v(side) ? spot.v : spot.u;
  const int edge = panels_[panel].sides[side].edge;
  const bool is_corner = place == from || place == to;
  std::int32_t& vertex = edge < 0 || is_corner ? node_vertices_[root(corner_node(panel, side, place == to))]
                                               : edge_vertices_[edge][on_edge(edge, scaled(panel, side, place))];
  if (vertex < 0) vertex = new_vertex(panel, spot);
  return vertex;
}

std::int32_t AdaptiveBuilder::vertex_at(std::size_t panel, const Spot& spot) {
  const Cell& whole = panels_[panel].whole;
  if (spot.u == whole.u0) return side_vertex(panel, 0, spot);
  if (spot.u == whole.u1) return side_vertex(panel, 1, spot);
  if (spot.v == whole.v0) return side_vertex(panel, 2, spot);
  if (spot.v == whole.v1) return side_vertex(panel, 3, spot);
  const auto [found, is_new] = inner_vertices_[panel].try_emplace({spot.u, spot.v}, -1);
  if (is_new) found->second = new_vertex(panel, spot);
  return found->second;
}

/// Whether the first derivative may jump there.
bool AdaptiveBuilder::is_crease(std::size_t panel, Axis axis, Place place) const {
  const Cell& whole = panels_[panel].whole;
  const auto [from, to] = axis == Axis::u ? std::pair{whole.u0, whole.u1} : std::pair{whole.v0, whole.v1};
  if (place == from || place == to) return true;
  if (place % kSpan != 0) return false;
  const KnotVector& knots = patch_of(panel).knot_vector(axis);
  return multiplicity(knots, parameter_at(knots, place)) >= knots.degree();
}

/// The sample at a spot, seen from inside a cell.
std::size_t AdaptiveBuilder::sample_at(std::size_t panel, const Spot& spot, const Cell& cell) {
  const Side side_u = spot.u == cell.u1 && is_crease(panel, Axis::u, spot.u) ? Side::left : Side::right;
  const Side side_v = spot.v == cell.v1 && is_crease(panel, Axis::v, spot.v) ? Side::left : Side::right;
  const std::size_t patch = panels_[panel].patch;
  const auto [found, is_new] = samples_.try_emplace({patch, spot.u, spot.v, side_u, side_v}, sample_places_.size());
  if (!is_new) return found->second;
  const auto [scatter, is_first] = scatter_of_.try_emplace({patch, side_u, side_v}, mesh_.scatters_.size());
  if (is_first) mesh_.scatters_.push_back({patch, {side_u, side_v, AtInfinity::raise}, {}, {}, 0});
  Tessellation::Scatter& samples = mesh_.scatters_[scatter->second];
  sample_places_.emplace_back(scatter->second, samples.u.size());
  samples.u.push_back(parameter_at(patch_of(panel).knot_vector(Axis::u), spot.u));
  samples.v.push_back(parameter_at(patch_of(panel).knot_vector(Axis::v), spot.v));
  return found->second;
}

void AdaptiveBuilder::add_seam(std::int32_t corner_a, std::int32_t corner_b) {
  if (mesh_.corner_vertices_[corner_a] > mesh_.corner_vertices_[corner_b]) std::swap(corner_a, corner_b);
  mesh_.seams_.push_back({mesh_.corner_vertices_[corner_a], mesh_.corner_vertices_[corner_b], corner_a, corner_b});
}

/// A face with these corners, counter-clockwise seen from where S_u x S_v points, unless it has shrunk to an edge.
void AdaptiveBuilder::add_face(std::size_t panel, const Cell& cell, const std::vector<Spot>& spots) {
  std::vector<std::pair<std::int32_t, Spot>> corners;
  for (const Spot& spot : spots) {
    const std::int32_t vertex = vertex_at(panel, spot);
    if (corners.empty() || (corners.back().first != vertex)) corners.emplace_back(vertex, spot);
  }
  while (corners.size() > 1 && corners.back().first == corners.front().first) corners.pop_back();
  if (corners.size() < 3) return;
  mesh_.face_starts_.push_back(static_cast<std::int32_t>(mesh_.corner_vertices_.size()));
  mesh_.face_patches_.push_back(static_cast<std::int32_t>(panels_[panel].patch));
  const auto first = static_cast<std::int32_t>(mesh_.corner_vertices_.size());
  const NurbsPatch& patch = patch_of(panel);
  const auto uv = [&](Axis axis, Place place) {
    const Interval range = patch.knot_vector(axis).domain();
    return static_cast<float>((parameter_at(patch.knot_vector(axis), place) - range.start) / range.length());
  };
  for (const auto& [vertex, spot] : corners) {
    mesh_.corner_vertices_.push_back(vertex);
    mesh_.corner_samples_.push_back(sample_at(panel, spot, cell));
    mesh_.corner_uvs_.push_back(uv(Axis::u, spot.u));
    mesh_.corner_uvs_.push_back(uv(Axis::v, spot.v));
  }
  const auto count = static_cast<std::int32_t>(corners.size());
  for (std::int32_t k = 0; k < count; ++k) {
    const Spot& a = corners[k].second;
    const Spot& b = corners[(k + 1) % count].second;
    const bool is_border = (a.u == b.u && is_crease(panel, Axis::u, a.u)) || (a.v == b.v && is_crease(panel, Axis::v, a.v));
    if (is_border) add_seam(first + k, first + (k + 1) % count);
  }
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
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (const Cell& cell : grids_[panel].cells()) add_cell(panel, cell);
  }
  for (Tessellation::Scatter& scatter : mesh_.scatters_) {
    scatter.first_sample = mesh_.sample_count_;
    mesh_.sample_count_ += scatter.u.size();
  }
  const auto final_number = [&](std::size_t& sample) {
    const auto [scatter, number] = sample_places_[sample];
    sample = mesh_.scatters_[scatter].first_sample + number;
  };
  std::ranges::for_each(mesh_.vertex_samples_, final_number);
  std::ranges::for_each(mesh_.corner_samples_, final_number);
}

Tessellation Tessellation::adaptive(const PatchSet& set, const Fineness& fineness) {
  if (!(fineness.distance > 0.0) || !(fineness.angle > 0.0)) {
    throw InvalidShape("a tolerance of a mesh is not above 0");
  }
  constexpr double kOneCurve = 1e-10;
  Tessellation mesh;
  mesh.patches_.assign(set.patches().begin(), set.patches().end());
  mesh.first_equal_ = first_equal_rows(set);
  mesh.sides_ = patch_sides(set);
  AdaptiveBuilder builder(set, fineness, kOneCurve * extent(set.points()), mesh);
  builder.fit();
  builder.number_edges();
  builder.add_faces();
  std::ranges::sort(mesh.seams_, {}, [](const Seam& seam) { return std::pair{seam.low_vertex, seam.high_vertex}; });
  if (mesh.face_starts_.empty()) throw InvalidShape("the mesh would have no face: move points apart");
  return mesh;
}

}  // namespace splinecore
