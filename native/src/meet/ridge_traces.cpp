#include "ridge_traces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// A side of a piece along which a step runs: the end of the one before it, and the start of the one beyond.
struct CreaseLine {
  std::size_t parameter;
  std::size_t before;
  std::size_t beyond;
};

/// The crease of one of the patches that a step runs along, up to a small part of the tolerance.
std::optional<CreaseLine> crease_of(const TwoPatches& patches, const SectionStep& step, double tolerance, bool is_a) {
  constexpr double kOfTolerance = 0x1p-4;
  for (std::size_t i = is_a ? 0 : 2; i < (is_a ? 2U : 4U); ++i) {
    const bool is_end = step.from.at[i] > 0.5;
    const double side = is_end ? 1.0 : 0.0;
    const PatchPieces& pieces = is_a ? patches.a : patches.b;
    const auto is_on_side = [&](double s) {
      const PatchSpots at = step.spots(s);
      return std::abs(at[i] - side) * glm::length(pieces.at(is_a ? at.a : at.b).first[i % 2]) <= kOfTolerance * tolerance;
    };
    if (!is_on_side(0.0) || !is_on_side(0.5) || !is_on_side(1.0)) continue;
    const std::size_t piece = is_a ? step.from.at.a.piece : step.from.at.b.piece;
    const auto other = pieces.beyond(piece, {i % 2 == 0 ? Axis::u : Axis::v, is_end});
    if (other) return is_end ? CreaseLine{i, piece, *other} : CreaseLine{i, *other, piece};
  }
  return {};
}

PatchSpot spot_beside(const PatchSpots& at, const CreaseLine& crease, bool is_beyond) {
  PatchSpot spot = crease.parameter < 2 ? at.a : at.b;
  spot.piece = is_beyond ? crease.beyond : crease.before;
  spot.at[crease.parameter % 2] = is_beyond ? 0.0 : 1.0;
  return spot;
}

/// Angles about a curve, from an axis across it.
struct AnglesAround {
  glm::dvec3 tangent;
  glm::dvec3 x;
  glm::dvec3 y;

  double of(const glm::dvec3& way) const { return std::atan2(glm::dot(way, y), glm::dot(way, x)); }

  /// Both ways in which a patch goes off from a place on the curve.
  std::optional<std::array<double, 2>> off(const PatchPieces& pieces, const PatchSpots& at, bool is_a,
                                           const std::optional<CreaseLine>& crease) const {
    std::array<double, 2> found{};
    for (const bool is_beyond : {false, true}) {
      const Slopes<2> s = pieces.at(crease ? spot_beside(at, *crease, is_beyond) : (is_a ? at.a : at.b));
      glm::dvec3 way = glm::cross(glm::cross(s.first[0], s.first[1]), tangent);
      if (crease) {
        const glm::dvec3& inwards = s.first[crease->parameter % 2];
        if (glm::dot(way, inwards) * (is_beyond ? 1.0 : -1.0) < 0.0) way = -way;
      } else if (is_beyond) {
        way = -way;
      }
      if (!(glm::length(way) > 0.0)) return {};
      found[is_beyond ? 1 : 0] = of(way);
    }
    return found;
  }
};

double turned_on(double angle) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return angle < 0.0 ? angle + kTurn : angle;
}

/// Whether the second pair of ways lies on one side of the first one; nothing where two of them are nearly the same.
std::optional<bool> are_on_one_side(const std::array<double, 2>& of_a, const std::array<double, 2>& of_b) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  constexpr double kSame = 0x1p-16;
  const double end = turned_on(of_a[1] - of_a[0]);
  int inside = 0;
  for (const double b : of_b) {
    const double here = turned_on(b - of_a[0]);
    if (std::min({here, kTurn - here, std::abs(here - end)}) < kSame) return {};
    inside += here < end ? 1 : 0;
  }
  return inside != 1;
}

/// A step along creases.
class CreaseStep {
 public:
  CreaseStep(const TwoPatches& patches, const SectionStep& step, double tolerance)
      : patches_(patches), step_(step), of_a_(crease_of(patches, step, tolerance, true)),
        of_b_(crease_of(patches, step, tolerance, false)) {}

  bool is_along_crease() const { return of_a_ || of_b_; }

  /// Its ends in the pieces before the creases, from the lower parameter to the higher one.
  std::array<SectionPlace, 2> ends() const {
    const std::size_t along = parameter();
    std::array<SectionPlace, 2> found{step_.from, step_.to};
    if (step_.from.at[along] > step_.to.at[along]) found = {step_.to.backwards(), step_.from.backwards()};
    for (SectionPlace& end : found) {
      for (const auto* crease : {&of_a_, &of_b_}) {
        if (!*crease) continue;
        ((*crease)->parameter < 2 ? end.at.a : end.at.b) = spot_beside(end.at, **crease, false);
        end.slopes[(*crease)->parameter] = 0.0;
      }
    }
    return found;
  }

  /// The one that goes along the crease.
  std::size_t parameter() const { return (of_a_ ? of_a_ : of_b_)->parameter ^ 1U; }

  /// Whether patches touch there but do not cross, where nearly all of it does one or the other.
  bool is_ridge() const {
    for (const double s : {0.5, 0.25, 0.75}) {
      if (const auto found = is_ridge_at(s)) return *found;
    }
    return false;
  }

  /// Where from start to end they begin to cross, or cease to.
  std::vector<double> changes() const {
    constexpr std::array kLooks{0x1p-6, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0 - 0x1p-6};
    std::vector<double> found;
    std::optional<bool> before;
    double last = 0.0;
    for (const double look : kLooks) {
      const std::optional<bool> here = is_ridge_at(look);
      if (!here) continue;
      if (before && *here != *before) {
        const Interval range{last, look};
        found.push_back(0.5 * (change_in(range, *before, *before) + change_in(range, *before, *here)));
      }
      before = here;
      last = look;
    }
    return found;
  }

 private:
  /// Nothing where the angles do not tell.
  std::optional<bool> is_ridge_at(double s) const {
    breathe(256);
    const PatchSpots at = step_.spots(s);
    const glm::dvec3 tangent = glm::normalize(step_.to.point - step_.from.point);
    const Slopes<2> there = patches_.a.at(at.a);
    const glm::dvec3 across = glm::cross(glm::cross(there.first[0], there.first[1]), tangent);
    if (!(glm::length(across) > 0.0)) return {};
    const glm::dvec3 x = glm::normalize(across);
    const AnglesAround around{tangent, x, glm::cross(tangent, x)};
    const auto off_a = around.off(patches_.a, at, true, of_a_);
    const auto off_b = around.off(patches_.b, at, false, of_b_);
    if (!off_a || !off_b) return {};
    return are_on_one_side(*off_a, *off_b);
  }

  /// Where they are no longer as at the start of a range, if where the angles do not tell they are as given.
  double change_in(Interval range, bool at_start, bool untold) const {
    constexpr int kHalvings = 40;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = range.middle();
      (is_ridge_at(middle).value_or(untold) == at_start ? range.start : range.end) = middle;
    }
    return range.middle();
  }

  const TwoPatches& patches_;
  const SectionStep& step_;
  std::optional<CreaseLine> of_a_;
  std::optional<CreaseLine> of_b_;
};

SectionPlace place_between(const SectionStep& step, double s) {
  SectionPlace between{step.spots(s), step.point(s), glm::mix(step.from.tangent, step.to.tangent, s), {}};
  between.tangent = glm::normalize(between.tangent);
  for (std::size_t i = 0; i < 4; ++i) between.slopes[i] = std::lerp(step.from.slopes[i], step.to.slopes[i], s);
  return between;
}

/// A trace with places where patches begin to cross along a crease, or cease to.
SectionTrace cut_at_changes(const TwoPatches& patches, const SectionTrace& trace, double tolerance) {
  SectionTrace found{{}, trace.is_closed, trace.is_lost};
  for (std::size_t i = 0; i < trace.places.size(); ++i) {
    found.places.push_back(trace.places[i]);
    if (i + 1 == trace.places.size() || !trace.places[i].has_pieces_of(trace.places[i + 1])) continue;
    const SectionStep step(trace.places[i], trace.places[i + 1]);
    if (!(step.length > tolerance)) continue;
    const CreaseStep along(patches, step, tolerance);
    if (!along.is_along_crease()) continue;
    for (const double s : along.changes()) found.places.push_back(place_between(step, s));
  }
  return found;
}

/// Stretches of creases, each run through one way and in the pieces before it.
class CreaseSteps {
 public:
  void add(const CreaseStep& step) {
    const std::array<SectionPlace, 2> ends = step.ends();
    steps_[line_of(step, ends)].push_back(ends);
  }

  void add(const CreaseSteps& others) {
    for (const auto& [line, steps] : others.steps_) {
      steps_[line].insert(steps_[line].end(), steps.begin(), steps.end());
    }
  }

  /// Whether all of a step is there, up to the rounding of changes.
  bool hold(const CreaseStep& step) const {
    constexpr double kNear = 0x1p-24;
    const std::array<SectionPlace, 2> ends = step.ends();
    const auto known = steps_.find(line_of(step, ends));
    if (known == steps_.end()) return false;
    const std::size_t along = step.parameter();
    const double length = ends[1].at[along] - ends[0].at[along];
    double left = length;
    for (const auto& [from, to] : known->second) {
      left -= std::max(0.0, std::min(to.at[along], ends[1].at[along]) - std::max(from.at[along], ends[0].at[along]));
    }
    return left < std::min(kNear, 0.25 * length);
  }

  std::vector<SectionTrace> traces() {
    std::vector<SectionTrace> found;
    for (auto& [line, steps] : steps_) {
      const std::size_t along = line[0];
      const auto start = [&](const std::array<SectionPlace, 2>& step) { return step[0].at[along]; };
      std::ranges::stable_sort(steps, {}, start);
      for (const auto& [from, to] : steps) {
        const bool goes_on = &from != &steps.front()[0] && from.at[along] <= found.back().places.back().at[along] + kSame;
        if (!goes_on) found.push_back({{from, to}, false});
        else if (to.at[along] > found.back().places.back().at[along] + kSame) found.back().places.push_back(to);
      }
    }
    return found;
  }

 private:
  static constexpr double kSame = 0x1p-30;
  using Line = std::array<std::size_t, 3>;  ///< the parameter along it, and the pieces before it

  static Line line_of(const CreaseStep& step, const std::array<SectionPlace, 2>& ends) {
    return {step.parameter(), ends[0].at.a.piece, ends[0].at.b.piece};
  }

  std::map<Line, std::vector<std::array<SectionPlace, 2>>> steps_;
};

/// What is left of a trace without some of its steps. One that is closed ends where it begins.
std::vector<SectionTrace> rest_of(const SectionTrace& trace, const std::vector<bool>& is_taken) {
  const std::vector<SectionPlace>& places = trace.places;
  const std::size_t count = is_taken.size();
  const auto taken = static_cast<std::size_t>(std::ranges::find(is_taken, true) - is_taken.begin());
  std::vector<SectionTrace> found;
  bool goes_on = false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = trace.is_closed ? (taken + k) % count : k;
    const bool is_joint = !places[i].has_pieces_of(places[i + 1]);
    if (is_taken[i] || (is_joint && !goes_on)) {
      goes_on = goes_on && !is_taken[i];
      continue;
    }
    if (!goes_on) found.push_back({{}, false});
    std::vector<SectionPlace>& rest = found.back().places;
    if (rest.empty() || !rest.back().has_pieces_of(places[i])) rest.push_back(places[i]);
    rest.push_back(places[i + 1]);
    goes_on = true;
  }
  for (SectionTrace& rest : found) {
    while (rest.places.size() > 1 && !rest.places.back().has_pieces_of(rest.places.end()[-2])) rest.places.pop_back();
  }
  return found;
}

}  // namespace

SortedTraces without_ridges(const TwoPatches& patches, const std::vector<SectionTrace>& traces, double tolerance) {
  SortedTraces found;
  CreaseSteps ridges;
  CreaseSteps crossings;
  for (const SectionTrace& whole : traces) {
    const SectionTrace trace = cut_at_changes(patches, whole, tolerance);
    CreaseSteps own;
    std::vector<bool> is_taken(trace.places.empty() ? 0 : trace.places.size() - 1, false);
    for (std::size_t i = 0; i < is_taken.size(); ++i) {
      const SectionStep step(trace.places[i], trace.places[i + 1]);
      if (!step.from.has_pieces_of(step.to) || !(step.length > 0.0)) continue;
      const CreaseStep along(patches, step, tolerance);
      if (!along.is_along_crease()) continue;
      const bool is_ridge = along.is_ridge();
      is_taken[i] = is_ridge || crossings.hold(along);
      if (is_ridge) ridges.add(along);
      else if (!is_taken[i]) own.add(along);
    }
    crossings.add(own);
    if (std::ranges::none_of(is_taken, [](bool is) { return is; })) {
      found.crossing.push_back(whole);
      continue;
    }
    for (SectionTrace& rest : rest_of(trace, is_taken)) found.crossing.push_back(std::move(rest));
  }
  found.ridges = ridges.traces();
  return found;
}

}  // namespace splinecore
