#include "patch_touching.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "base/length.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Beads of a step of a curve.
constexpr int kBeads = 32;

/// Where normals are parallel places have half the digits: on a side of a piece they may be off it by that.
bool enters_nearly(PatchSpots& at) {
  constexpr double kHalfOfDigits = 0x1p-24;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(at[i] >= -kHalfOfDigits && at[i] <= 1.0 + kHalfOfDigits)) return false;
  }
  for (std::size_t i = 0; i < 4; ++i) at[i] = std::clamp(at[i], 0.0, 1.0);
  return true;
}

bool is_beside(const SectionTrace& trace, const glm::dvec3& point, double distance) {
  for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
    if (SectionStep(trace.places[i], trace.places[i + 1]).is_near(point, distance)) return true;
  }
  return false;
}

}  // namespace

bool TouchingCurves::knows(const PatchPart& a, const PatchPart& b) {
  if (std::max(a.largest_size(), b.largest_size()) > kLargestOfTouch) return false;
  if (is_explained(a, b) || (find_near(a, b) && is_explained(a, b))) return true;
  if (!is_one(a, b)) return false;
  const std::optional<Nearness> seen = nearness(a, b);
  if (!seen) return false;
  // Where surfaces touch more closely in a point of a curve they are within the tolerance about it, and not one.
  constexpr double kSmall = 0x1p-6;
  constexpr double kExact = 0x1p-40;
  const double size = std::max(a.largest_size(), b.largest_size());
  if (size < kSmall * std::min(patches_.a.extent(), patches_.b.extent()) && seen->gap > kExact) return true;
  are_one_ = are_one_ || seen->is_inside;
  find_borders(a, b);
  return true;
}

/// Calls look with the feet of places all over a part on the other one, and how far they are from it, as long as it returns true.
/// @returns whether it did for all of them
template <class Look>
bool TouchingCurves::for_feet(const PatchPart& a, const PatchPart& b, Look look) const {
  constexpr std::size_t kMost = 8;  // of a part that is a small one of a piece
  const double farthest = std::max(a.largest_size(), b.largest_size());
  const std::size_t rows = std::min(a.net.rows + 1, kMost);
  const std::size_t columns = std::min(a.net.columns + 1, kMost);
  PatchSpots at{{a.piece, a.middle()}, {b.piece, b.middle()}};
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double s = static_cast<double>(i) / static_cast<double>(rows - 1);
      const double t = static_cast<double>(j) / static_cast<double>(columns - 1);
      at.a.at = {a.range[0].start + s * a.range[0].length(), a.range[1].start + t * a.range[1].length()};
      const std::optional<PatchSpots> foot = foot_near(patches_, at);
      if (!foot) return false;
      at.b = foot->b;
      const PatchMeeting here = meeting_at(patches_, at);
      const double gap = glm::dot(here.b.offset, here.normal_a);
      if (!(std::abs(gap) <= farthest) || !look(at, here.a.point, gap)) return false;
    }
  }
  return true;
}

/// Whether a part parts from a curve that is known, as surfaces do that touch there.
bool TouchingCurves::is_explained(const PatchPart& a, const PatchPart& b) const {
  if (beads_.empty()) return false;
  return for_feet(a, b, [&](const PatchSpots&, const glm::dvec3& point, double gap) { return is_explained(point, gap); });
}

/// @returns none if it is not all within the tolerance
std::optional<TouchingCurves::Nearness> TouchingCurves::nearness(const PatchPart& a, const PatchPart& b) const {
  Nearness found{false, 0.0};
  const bool is_near = for_feet(a, b, [&](const PatchSpots& at, const glm::dvec3&, double gap) {
    PatchSpots inside = at;
    found.is_inside = found.is_inside || enters(inside);
    found.gap = std::max(found.gap, std::abs(gap));
    return std::abs(gap) <= tolerance_;
  });
  return is_near ? std::optional(found) : std::nullopt;
}

bool TouchingCurves::is_explained(const glm::dvec3& point, double gap) const {
  const double slack = 0.25 * tolerance_;
  constexpr double kLoose = 4.0;
  double distance = 0.0;
  const BeadStrings::Bead* const bead = beads_.nearest(point, distance);
  if (!bead) return false;
  const double parted = 0.5 * bead->bend * distance * distance;
  const double that_way = parted < 0.0 ? -gap : gap;
  return that_way >= std::abs(parted) / kLoose - slack && that_way <= kLoose * std::abs(parted) + slack;
}

bool TouchingCurves::runs_by(const SectionPlace& place) const {
  double distance = 0.0;
  const BeadStrings::Bead* const bead = beads_.nearest(place.point, distance);
  if (!bead) return false;
  const double bend = std::abs(bead->bend);
  const double sine = glm::length(meeting_at(patches_, place.at).along);
  return bend * distance * distance <= 0.5 * tolerance_ && sine * sine <= bend * tolerance_;
}

/// Whether parts that are near do not part as surfaces do that touch.
bool TouchingCurves::is_one(const PatchPart& a, const PatchPart& b) const {
  const auto foot = foot_near(patches_, {{a.piece, a.middle()}, {b.piece, b.middle()}});
  if (!foot) return false;
  const PatchMeeting there = meeting_at(patches_, *foot);
  const std::optional<Parting> parting = parting_at(there);
  return parting && glm::length(there.along) < kOneSlope * tolerance_ && std::abs(parting->across) < kOneBend * tolerance_;
}

/// Where in a pair of parts, or a little beyond, the patches touch, in the pieces that it lies in.
std::optional<PatchSpots> TouchingCurves::touch_of_parts(const PatchPart& a, const PatchPart& b) const {
  constexpr double kBeyond = 1.0;
  constexpr int kMostHops = 4;
  std::array<Interval, 4> box{a.range[0], a.range[1], b.range[0], b.range[1]};
  for (Interval& range : box) {
    const double beyond = kBeyond * range.length();
    range = {range.start - beyond, range.end + beyond};
  }
  std::optional<PatchSpots> at = touch_near(patches_, {{a.piece, a.middle()}, {b.piece, b.middle()}}, box);
  for (int hop = 0; at && !enters_nearly(*at); ++hop) {
    if (hop == kMostHops) return {};
    PatchSpots from = *at;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_end = from[i] > 1.0;
      if (from[i] >= 0.0 && !is_end) continue;
      PatchSpot& spot = i < 2 ? from.a : from.b;
      const auto next = (i < 2 ? patches_.a : patches_.b).beyond(spot.piece, {i % 2 == 0 ? Axis::u : Axis::v, is_end});
      if (!next) return {};
      spot.piece = *next;
      spot.at[i % 2] = is_end ? 0.0 : 1.0;
    }
    at = touch_near(patches_, from);
  }
  return at;
}

/// @returns whether there is a new curve
bool TouchingCurves::find_near(const PatchPart& a, const PatchPart& b) {
  const std::optional<PatchSpots> at = touch_of_parts(a, b);
  if (!at) return false;
  const PatchMeeting here = meeting_at(patches_, *at);
  constexpr double kNear = 0x1p-10;
  if (here.distance() > 0.5 * tolerance_ || beads_.is_near(here.a.point, kNear)) return false;
  if (no_curves_.is_near(here.a.point, kNear)) return false;
  const std::optional<Parting> parting = parting_at(here);
  if (!parting || !is_curve(*parting) || std::abs(parting->across) < kOneBend * tolerance_) return false;
  const SectionPlace seed{*at, here.a.point + 0.5 * here.b.offset, parting->way, slopes_along(here, parting->way)};
  SectionTrace trace = traced(patches_, seed, {{PatchContact::Kind::grazing, {}}, {}, 0.5 * tolerance_});
  if (trace.places.size() < 2) return false;
  if (!ends_well(trace)) {
    no_curves_.add(patches_, trace);
    return false;
  }
  beads_.add(patches_, trace);
  traces_.push_back(std::move(trace));
  return true;
}

/// Whether a curve is closed or ends on borders: about a point in which patches touch, or at which curves cross at a small
/// angle, also where that is on a border, one goes on but as far as they are within the tolerance.
bool TouchingCurves::ends_well(const SectionTrace& trace) const {
  const auto is_on_border = [&](const PatchSpots& at) {
    constexpr double kHalfOfDigits = 0x1p-24;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_end = at[i] > 0.5;
      const PatchPieces& pieces = i < 2 ? patches_.a : patches_.b;
      const bool is_on_side = std::abs(at[i] - (is_end ? 1.0 : 0.0)) <= kHalfOfDigits;
      const PieceSide side{i % 2 == 0 ? Axis::u : Axis::v, is_end};
      if (is_on_side && !pieces.beyond(i < 2 ? at.a.piece : at.b.piece, side)) return true;
    }
    return false;
  };
  const auto ends_in_touch = [&](const PatchSpots& at) {
    return is_on_border(at) || meeting_at(patches_, at).distance() <= 0.25 * tolerance_;
  };
  const SectionPlace& first = trace.places.front();
  const SectionPlace& last = trace.places.back();
  if (trace.is_closed) return true;
  return (is_on_border(first.at) || is_on_border(last.at)) && ends_in_touch(first.at) && ends_in_touch(last.at);
}

/// Sides of parts that are one which are borders of their patches.
void TouchingCurves::find_borders(const PatchPart& a, const PatchPart& b) {
  find_borders_of(a, b, true);
  find_borders_of(b, a, false);
}

void TouchingCurves::find_borders_of(const PatchPart& part, const PatchPart& other, bool is_a) {
  constexpr int kLooks = 16;
  const PatchPieces& pieces = is_a ? patches_.a : patches_.b;
  const TwoPatches seen{pieces, is_a ? patches_.b : patches_.a};
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    for (const bool is_end : {false, true}) {
      const double value = is_end ? 1.0 : 0.0;
      const PieceSide side{k == 0 ? Axis::u : Axis::v, is_end};
      if ((is_end ? part.range[k].end : part.range[k].start) != value) continue;
      if (pieces.is_pole(part.piece, side) || pieces.beyond(part.piece, side)) continue;
      const Interval& along = part.range[1 - k];
      for (int i = 0; i <= kLooks; ++i) {
        PatchSpots at{{part.piece, {value, value}}, {other.piece, other.middle()}};
        at.a.at[1 - k] = along.start + along.length() * i / kLooks;
        std::optional<PatchSpots> foot = foot_near(seen, at);
        if (!foot || !enters(*foot)) continue;
        if (is_a) {
          find_border(*foot, {k, value});
        } else {
          find_border({foot->b, foot->a}, {2 + k, value});
        }
      }
    }
  }
}

/// Where a border leaves the other patch, the border of that goes on, however short it is.
void TouchingCurves::follow_borders() {
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    if (borders_[i].is_closed || whole_[i]) continue;
    const std::array<PatchSpots, 2> ends{borders_[i].places.front().at, borders_[i].places.back().at};
    for (const PatchSpots& end : ends) {
      for (const OnFace& border : borders_at(end)) {
        PatchSpots at = end;
        at[border.parameter] = border.value;
        keep_border(traced_border(at, border), i);
      }
    }
  }
}

/// The borders of both patches that a place is on.
std::vector<OnFace> TouchingCurves::borders_at(const PatchSpots& at) const {
  constexpr double kHalfOfDigits = 0x1p-24;
  std::vector<OnFace> found;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_end = at[i] > 0.5;
    const double value = is_end ? 1.0 : 0.0;
    const PatchPieces& pieces = i < 2 ? patches_.a : patches_.b;
    const std::size_t piece = i < 2 ? at.a.piece : at.b.piece;
    const PieceSide side{i % 2 == 0 ? Axis::u : Axis::v, is_end};
    if (std::abs(at[i] - value) > kHalfOfDigits || pieces.is_pole(piece, side) || pieces.beyond(piece, side)) continue;
    found.push_back({i, value});
  }
  return found;
}

/// Whether a border goes where none that is known does.
bool TouchingCurves::is_new(const SectionTrace& trace) const {
  for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
    if (!trace.places[i].has_pieces_of(trace.places[i + 1])) continue;
    const SectionStep step(trace.places[i], trace.places[i + 1]);
    if (step.length > near_border() && !border_beads_.is_near(step.point(0.5), near_border())) return true;
  }
  return false;
}

double TouchingCurves::near_border() const { return std::max(4.0 * tolerance_, 0x1p-16); }

void TouchingCurves::find_border(const PatchSpots& at, const OnFace& border) {
  const PatchMeeting here = meeting_at(patches_, at);
  if (here.distance() > 0.5 * tolerance_ || border_beads_.is_near(here.a.point, near_border())) return;
  keep_border(traced_border(at, border), {});
}

/// @returns none where nothing is to be followed
std::optional<SectionTrace> TouchingCurves::traced_border(const PatchSpots& at, const OnFace& border) const {
  if (is_known_place && is_known_place(at)) return {};
  const PatchMeeting here = meeting_at(patches_, at);
  const std::size_t other = border.parameter ^ 1U;
  const glm::dvec3& slope = other < 2 ? here.a.first[other] : here.b.first[other - 2];
  if (!(glm::length(slope) > 0.0)) return {};
  const glm::dvec3 way = glm::normalize(slope);
  SectionPlace seed{at, here.a.point + 0.5 * here.b.offset, way, slopes_along(here, way)};
  seed.slopes[border.parameter] = 0.0;
  return traced(patches_, seed, {{PatchContact::Kind::border, border}, {}, 0.5 * tolerance_});
}

void TouchingCurves::keep_border(std::optional<SectionTrace> trace, std::optional<std::size_t> from) {
  if (!trace) return;
  if (trace->places.size() < 2) {
    if (trace->is_lost[0] || trace->is_lost[1]) lost_.push_back({trace->places.front().point, from});
    return;
  }
  for (SectionTrace& part : without_crossings(std::move(*trace))) {
    if (!from || is_new(part)) add_border(std::move(part));
  }
}

/// What of a border is none of a crossing, which it goes on in where patches part at a crease.
std::vector<SectionTrace> TouchingCurves::without_crossings(SectionTrace trace) const {
  std::vector<SectionTrace> parts;
  SectionTrace part{{trace.places.front()}, false, {trace.is_lost[0], false}};
  bool is_whole = true;
  for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
    const SectionPlace& to = trace.places[i + 1];
    const bool is_joint = !trace.places[i].has_pieces_of(to);
    if (is_joint || !is_crossing || !is_crossing(SectionStep(trace.places[i], to).point(0.5))) {
      if (is_joint && part.places.size() == 1 && i > 0) part.places.clear();
      part.places.push_back(to);
      continue;
    }
    is_whole = false;
    if (part.places.size() > 1) parts.push_back(std::move(part));
    part = {{to}, false};
  }
  if (is_whole) return {std::move(trace)};
  part.is_lost[1] = trace.is_lost[1];
  if (part.places.size() > 1) parts.push_back(std::move(part));
  return parts;
}

std::optional<glm::dvec3> TouchingCurves::lost_border() const {
  const auto goes_by = [&](const glm::dvec3& point, std::optional<std::size_t> but) {
    for (std::size_t i = 0; i < borders_.size(); ++i) {
      if (but != i && is_beside(borders_[i], point, near_border())) return true;
    }
    return false;
  };
  for (const LostBorder& lost : lost_) {
    if (!goes_by(lost.point, lost.from)) return lost.point;
  }
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    const SectionTrace& border = borders_[i];
    if (border.is_lost[0] && !goes_by(border.places.front().point, i)) return border.places.front().point;
    if (border.is_lost[1] && !goes_by(border.places.back().point, i)) return border.places.back().point;
  }
  return {};
}

void TouchingCurves::add_border(SectionTrace trace, bool is_whole) {
  are_one_ = true;
  border_beads_.add(patches_, trace);
  borders_.push_back(std::move(trace));
  whole_.push_back(is_whole);
}

void BeadStrings::add(const TwoPatches& patches, const SectionTrace& trace) {
  std::vector<Bead> beads;
  for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
    const SectionPlace& from = trace.places[i];
    const SectionPlace& to = trace.places[i + 1];
    const std::optional<Parting> parting = parting_at(meeting_at(patches, from.at));
    const double bend = parting ? parting->across : beads.empty() ? 0.0 : beads.back().bend;
    if (!from.has_pieces_of(to)) continue;
    const SectionStep step(from, to);
    for (int k = 0; k < kBeads; ++k) beads.push_back({step.point(static_cast<double>(k) / kBeads), bend});
  }
  if (!beads.empty()) beads.push_back({trace.places.back().point, beads.back().bend});
  strings_.push_back(std::move(beads));
}

const BeadStrings::Bead* BeadStrings::nearest(const glm::dvec3& point, double& distance) const {
  const Bead* found = nullptr;
  distance = std::numeric_limits<double>::infinity();
  for (const std::vector<Bead>& beads : strings_) {
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
      const double here = distance_to_segment(point, beads[i].point, beads[i + 1].point);
      if (here >= distance) continue;
      distance = here;
      found = &beads[i];
    }
  }
  return found;
}

bool BeadStrings::is_near(const glm::dvec3& point, double distance) const {
  double found = 0.0;
  return nearest(point, found) && found <= distance;
}

}  // namespace splinecore
