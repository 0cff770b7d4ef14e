#include "fitted_panels.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>

#include "base/parallel.hpp"
#include "cells.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// What it costs to cut a piece that is as curved as most, in steps of breathe().
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

std::pair<Place, Place> range_along(const MeshCell& whole, int side) {
  return is_along_v(side) ? std::pair{whole.v0, whole.v1} : std::pair{whole.u0, whole.u1};
}

/// The number of the nearest of growing places, of equal ones the first.
std::size_t nearest(const std::vector<double>& places, double t) {
  const auto next = std::ranges::lower_bound(places, t);
  if (next == places.begin()) return 0;
  const bool is_next = next != places.end() && *next - t <= t - next[-1];
  return (is_next ? next : std::ranges::lower_bound(places, next[-1])) - places.begin();
}

}  // namespace

FittedPanels::FittedPanels(const PatchSet& set, const std::vector<Panel>& panels, const Fineness& fineness, int threads)
    : panels_(panels), spans_(mesh_spans(set)) {
  make_grids(set, fineness, threads);
  fit();
}

std::vector<std::size_t> FittedPanels::places_of_edges() const {
  std::vector<std::size_t> counts;
  for (const std::vector<double>& places : edge_places_) counts.push_back(places.size());
  return counts;
}

/// Cuts all panels into cells, row by row.
void FittedPanels::make_grids(const PatchSet& set, const Fineness& fineness, int threads) {
  struct Row {
    std::size_t panel;
    std::size_t number;
  };
  std::map<std::size_t, PlacedPatch> placed;
  std::deque<CellCutter> cutters;
  std::vector<Row> rows;
  std::vector<std::vector<std::vector<Cut>>> cuts;
  std::size_t work = 0;
  for (const Panel& panel : panels_) {
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

double FittedPanels::scaled(std::size_t panel, int side, Place place) const {
  const std::vector<MeshSpan>& along = spans(panel, is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  if (place == from || place == to) return (place == to) != panel_of(panel).sides[side].reversed ? 1.0 : 0.0;
  const double start = parameter_at(along, from);
  const double t = (parameter_at(along, place) - start) / (parameter_at(along, to) - start);
  return panel_of(panel).sides[side].reversed ? 1.0 - t : t;
}

/// Goes back along the edge over the slivers that end at a place.
EdgePlace FittedPanels::edge_place(std::size_t panel, int side, Place place) const {
  const std::vector<MeshSpan>& along = spans(panel, is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  const bool is_reversed = panel_of(panel).sides[side].reversed;
  const auto span_before = [&] { return (is_reversed ? place : place - 1) / kSpan; };
  int slivers = 0;
  while (place != (is_reversed ? to : from) && along[span_before()].is_sliver) {
    if (place % kSpan == 0) ++slivers;
    place = (span_before() + (is_reversed ? 1 : 0)) * kSpan;
  }
  return {scaled(panel, side, place), slivers};
}

Place FittedPanels::place_on(std::size_t panel, int side, double t) const {
  const std::vector<MeshSpan>& along = spans(panel, is_along_v(side) ? Axis::v : Axis::u);
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  const double forward = panel_of(panel).sides[side].reversed ? 1.0 - t : t;
  const double start = parameter_at(along, from);
  return std::clamp(place_of(along, start + forward * (parameter_at(along, to) - start)), from, to);
}

std::vector<Place> FittedPanels::places_on(std::size_t panel, int side) const {
  const auto [from, to] = range_along(grids_[panel].whole(), side);
  std::vector<Place> places{from};
  grids_[panel].on_border(side, from, to, places);
  places.push_back(to);
  return places;
}

/// Whether two places of an edge are one.
bool FittedPanels::is_one_place(std::size_t edge, double a, double b) const {
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

/// The places of all sides of an edge.
std::vector<double> FittedPanels::collect(std::size_t edge) const {
  std::vector<double> places;
  bool has_slivers = false;
  for (const auto& [panel, side] : edge_sides_[edge]) {
    for (const Place place : places_on(panel, side)) {
      const auto [t, slivers] = edge_place(panel, side, place);
      places.push_back(t);
      has_slivers |= slivers > 0;
    }
  }
  std::ranges::sort(places);
  const auto same = [&](double a, double b) { return is_one_place(edge, a, b); };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  places.back() = 1.0;
  return has_slivers ? with_slivers(edge, places) : places;
}

/// The places of an edge, each as often as all its sides tell ends of slivers apart there.
std::vector<double> FittedPanels::with_slivers(std::size_t edge, const std::vector<double>& places) const {
  std::vector<int> on_all(places.size(), std::numeric_limits<int>::max());
  for (const auto& [panel, side] : edge_sides_[edge]) {
    std::vector<int> own(places.size(), 0);
    for (const Place place : places_on(panel, side)) {
      const auto [t, slivers] = edge_place(panel, side, place);
      int& most = own[nearest(places, t)];
      most = std::max(most, slivers);
    }
    std::ranges::transform(on_all, own, on_all.begin(), [](int a, int b) { return std::min(a, b); });
  }
  std::vector<double> found;
  for (std::size_t i = 0; i < places.size(); ++i) found.insert(found.end(), on_all[i] + 1, places[i]);
  return found;
}

/// Gives every side all places of its edge; whether one was new.
bool FittedPanels::spread(const std::vector<std::vector<double>>& edges) {
  bool is_any_new = false;
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge < 0) continue;
      const auto own = places_on(panel, side);
      if (own.size() == edges[edge].size()) continue;
      std::vector<double> known;
      for (const Place place : own) known.push_back(edge_place(panel, side, place).t);
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

void FittedPanels::fit() {
  edge_sides_.resize(side_counts(panels_).size());
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel_of(panel).sides[side].edge;
      if (edge >= 0) edge_sides_[edge].emplace_back(panel, side);
    }
  }
  for (bool again = true; again;) {
    for (CellGrid& grid : grids_) grid.balance();
    std::vector<std::vector<double>> edges(edge_sides_.size());
    for (std::size_t edge = 0; edge < edges.size(); ++edge) edges[edge] = collect(edge);
    again = spread(edges);
    edge_places_ = std::move(edges);
  }
}

std::size_t FittedPanels::on_edge(int edge, EdgePlace place) const {
  const std::vector<double>& places = edge_places_[edge];
  const std::size_t number = nearest(places, place.t);
  const std::size_t last = std::ranges::upper_bound(places, places[number]) - places.begin() - 1;
  return std::min(number + static_cast<std::size_t>(place.slivers), last);
}

}  // namespace splinecore
