#include "shared_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/rounding.hpp"
#include "patch_touching.hpp"
#include "piece_box.hpp"
#include "splinecore/base/pause.hpp"
#include "touching_place.hpp"
#include "tree_pairs.hpp"
#include "turned_edges.hpp"

namespace splinecore {

namespace {

constexpr std::array kLooks{0.5, 0.25, 0.75, 0.04, 0.96};

/// Places all over a piece.
struct PieceGrid {
  std::vector<std::array<double, 2>> at;
  std::vector<glm::dvec3> points;
};

class SharedEdgeSearch {
 public:
  SharedEdgeSearch(const TwoPatches& patches, double tolerance, double rounding)
      : patches_(patches), tolerance_(tolerance), rounding_(rounding) {}

  SharedEdges found() {
    for_near_pairs(patches_.a.tree(), patches_.b.tree(), rounding_, [&](std::size_t i, std::size_t j) {
      look_along(i, j, true);
      look_along(j, i, false);
    });
    return std::move(found_);
  }

 private:
  void look_along(std::size_t piece, std::size_t other, bool is_a) {
    const PatchPieces& pieces = is_a ? patches_.a : patches_.b;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      for (const bool is_end : {false, true}) {
        const PieceSide side{k == 0 ? Axis::u : Axis::v, is_end};
        if (pieces.is_pole(piece, side) || pieces.beyond(piece, side)) continue;
        for (const double look : kLooks) {
          PatchSpot spot{piece, {look, look}};
          spot.at[k] = is_end ? 1.0 : 0.0;
          if (const auto at = on_other(spot, other, is_a)) trace(*at, {(is_a ? 0U : 2U) + k, spot.at[k]});
        }
      }
    }
  }

  /// The place of a border that lies on a piece of the other patch, unless it is known.
  std::optional<PatchSpots> on_other(const PatchSpot& spot, std::size_t other, bool is_a) {
    breathe(256);
    const TwoPatches seen{is_a ? patches_.a : patches_.b, is_a ? patches_.b : patches_.a};
    const glm::dvec3 point = seen.a.at(spot).point;
    if (!is_in_box(point, seen.b.piece(other)) || beads_.is_near(point, 4.0 * tolerance_)) return {};
    auto foot = foot_near(seen, {spot, {other, nearest_in_grid(point, other, !is_a)}});
    if (!foot || !enters_up_to_rounding(*foot)) return {};
    if (!(meeting_at(seen, *foot).distance() <= rounding_)) return {};
    return is_a ? foot : PatchSpots{foot->b, foot->a};
  }

  bool is_in_box(const glm::dvec3& point, const BernsteinNet<glm::dvec4>& piece) const {
    const TreeBox box = box_of(piece);
    for (int i = 0; i < 3; ++i) {
      if (!(point[i] >= box.low[i] - rounding_ && point[i] <= box.high[i] + rounding_)) return false;
    }
    return true;
  }

  std::array<double, 2> nearest_in_grid(const glm::dvec3& point, std::size_t piece, bool is_a) {
    const PieceGrid& grid = grid_of(piece, is_a);
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < grid.points.size(); ++i) {
      const double here = glm::distance(grid.points[i], point);
      if (here >= least) continue;
      least = here;
      nearest = i;
    }
    return grid.at[nearest];
  }

  const PieceGrid& grid_of(std::size_t piece, bool is_a) {
    constexpr int kAcross = 6;
    const auto [known, is_new] = grids_[is_a ? 0 : 1].try_emplace(piece);
    if (!is_new) return known->second;
    for (int i = 0; i <= kAcross; ++i) {
      for (int k = 0; k <= kAcross; ++k) {
        const std::array<double, 2> at{static_cast<double>(i) / kAcross, static_cast<double>(k) / kAcross};
        known->second.at.push_back(at);
        known->second.points.push_back((is_a ? patches_.a : patches_.b).at({piece, at}).point);
      }
    }
    return known->second;
  }

  static bool enters_up_to_rounding(PatchSpots& at) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(at[i] >= -kRoundingOfTouch && at[i] <= 1.0 + kRoundingOfTouch)) return false;
      at[i] = std::clamp(at[i], 0.0, 1.0);
    }
    return true;
  }

  /// What is lost of a border on the way is left to the search for crossings, which asks about all that no curve explains.
  void trace(const PatchSpots& at, const OnFace& border) {
    const PatchMeeting here = meeting_at(patches_, at);
    const std::size_t other = border.parameter ^ 1U;
    const glm::dvec3& slope = other < 2 ? here.a.first[other] : here.b.first[other - 2];
    if (!(glm::length(slope) > 0.0)) return;
    const glm::dvec3 way = glm::normalize(slope);
    SectionPlace seed{at, here.a.point + 0.5 * here.b.offset, way, slopes_along(here, way)};
    seed.slopes[border.parameter] = 0.0;
    const PatchContact contact{PatchContact::Kind::border, border};
    const SectionTrace whole = exact(traced(patches_, seed, {contact, {}, 0.5 * tolerance_}));
    if (whole.places.size() < 2 || is_short(whole)) return;
    std::optional<SharedEdges> cut = cut_at_turns(patches_, whole, contact, tolerance_);
    if (!cut) return;
    beads_.add(patches_, whole);
    for (SectionTrace& edge : cut->traces) found_.traces.push_back(std::move(edge));
    for (SectionTouch& turn : cut->turns) found_.turns.push_back(turn);
  }

  /// The longest run of places at which both are one up to rounding.
  SectionTrace exact(SectionTrace trace) const {
    const auto is_off = [&](const SectionPlace& place) { return !(meeting_at(patches_, place.at).distance() <= rounding_); };
    if (std::ranges::none_of(trace.places, is_off)) return trace;
    std::size_t first = 0;
    std::size_t count = 0;
    for (std::size_t i = 0, begin = 0; i < trace.places.size(); ++i) {
      if (is_off(trace.places[i])) begin = i + 1;
      if (i + 1 - begin <= count || i + 1 < begin) continue;
      first = begin;
      count = i + 1 - begin;
    }
    const auto from = trace.places.begin() + static_cast<std::ptrdiff_t>(first);
    return {{from, from + static_cast<std::ptrdiff_t>(count)}, false};
  }

  bool is_short(const SectionTrace& trace) const {
    constexpr double kTolerances = 64.0;
    return std::ranges::all_of(trace.places, [&](const SectionPlace& place) {
      return glm::distance(place.point, trace.places.front().point) <= kTolerances * tolerance_;
    });
  }

  TwoPatches patches_;
  double tolerance_;
  double rounding_;
  std::array<std::map<std::size_t, PieceGrid>, 2> grids_;
  BeadStrings beads_;
  SharedEdges found_;
};

}  // namespace

SharedEdges shared_edges(const TwoPatches& patches, double tolerance, double rounding) {
  return SharedEdgeSearch(patches, tolerance, rounding).found();
}

}  // namespace splinecore
