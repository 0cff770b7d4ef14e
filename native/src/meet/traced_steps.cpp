#include "traced_steps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Places so near are one.
constexpr double kRoundingOfPlaces = 0x1p-36;

FourParameters between(const FourParameters& a, const FourParameters& b, double share) {
  FourParameters at;
  for (std::size_t i = 0; i < 4; ++i) at[i] = std::lerp(a[i], b[i], share);
  return at;
}

/// What is no more than rounding of a range.
double slack_of(const Interval& range) {
  constexpr double kSlack = 0x1p-24;
  return kSlack * range.length() + kOnSide;
}

/// What of a straight line is in a part (Liang and Barsky 1984), or a little beside it: also there a value of the leading
/// parameter has one place at most.
std::optional<Interval> clipped(const CrossingPart& part, const FourParameters& from, const FourParameters& to) {
  constexpr double kBeside = 0x1p-4;
  Interval kept;
  for (std::size_t i = 0; i < 4; ++i) {
    const double slack = i == part.lead ? slack_of(part.range(i)) : kBeside * part.range(i).length() + kOnSide;
    const double low = part.range(i).start - slack;
    const double high = part.range(i).end + slack;
    const double way = to[i] - from[i];
    if (way == 0.0) {
      if (from[i] < low || from[i] > high) return {};
      continue;
    }
    const double enters = ((way > 0.0 ? low : high) - from[i]) / way;
    const double leaves = ((way > 0.0 ? high : low) - from[i]) / way;
    kept = {std::max(kept.start, enters), std::min(kept.end, leaves)};
    if (!(kept.start <= kept.end)) return {};
  }
  return kept;
}

/// Whether a curve that goes on from a place, the leading parameter rising or falling, is beyond the part for good: a
/// parameter is at its end there and goes one way.
bool leaves_for_good(const CrossingPart& part, const FourParameters& at, bool is_rising) {
  const int way = is_rising ? part.signs[part.lead] : -part.signs[part.lead];
  for (std::size_t i = 0; i < 4; ++i) {
    if (i == part.lead || part.signs[i] == 0) continue;
    const double slack = 2.0 * slack_of(part.range(i));
    const bool goes_up = part.signs[i] * way > 0;
    if (goes_up ? at[i] >= part.range(i).end - slack : at[i] <= part.range(i).start + slack) return true;
  }
  return false;
}

/// The values of the leading parameter for which the part has nothing but what is known between two places of a curve.
Interval settled_range(const CrossingPart& part, FourParameters first, FourParameters second) {
  const std::size_t lead = part.lead;
  if (first[lead] > second[lead]) std::swap(first, second);
  Interval settled{first[lead], second[lead]};
  if (leaves_for_good(part, first, false)) settled.start = part.range(lead).start;
  if (leaves_for_good(part, second, true)) settled.end = part.range(lead).end;
  return settled;
}

}  // namespace

void TracedSteps::add(SectionTrace trace) {
  traces_.push_back(std::move(trace));
  const std::vector<SectionPlace>& places = traces_.back().places;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    if (!places[i].has_pieces_of(places[i + 1])) continue;
    const SectionStep step(places[i], places[i + 1]);
    Step made{traces_.size() - 1, i, {}};
    for (std::size_t k = 0; k < kSamples; ++k) {
      made.at[k] = parameters_of(step.spots(static_cast<double>(k) / static_cast<double>(kSamples - 1)));
    }
    put({places[i].at.a.piece, places[i].at.b.piece}, made);
  }
}

/// Where a step runs along the side of a piece it is in the one beyond, too.
void TracedSteps::put(const Pieces& pieces, const Step& step) {
  std::vector<std::pair<Pieces, Step>> all{{pieces, step}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t count = all.size();
    for (std::size_t known = 0; known < count; ++known) {
      for (const bool is_end : {false, true}) {
        const double side = is_end ? 1.0 : 0.0;
        const auto is_on_side = [&](const FourParameters& at) { return std::abs(at[i] - side) <= kOnSide; };
        if (!std::ranges::all_of(all[known].second.at, is_on_side)) continue;
        const PatchPieces& of = i < 2 ? patches_.a : patches_.b;
        const auto next = of.beyond(all[known].first[i / 2], {i % 2 == 0 ? Axis::u : Axis::v, is_end});
        if (!next) continue;
        auto [there, twin] = all[known];
        there[i / 2] = *next;
        for (FourParameters& at : twin.at) at[i] = 1.0 - side;
        all.emplace_back(there, twin);
      }
    }
  }
  for (const auto& [there, twin] : all) steps_[there].push_back(twin);
}

const std::vector<TracedSteps::Step>* TracedSteps::steps_in(const Pieces& pieces) const {
  const auto found = steps_.find(pieces);
  return found == steps_.end() ? nullptr : &found->second;
}

bool TracedSteps::holds(const SectionPlace& place) const {
  const double sine = glm::length(meeting_at(patches_, place.at).along);
  const auto is_on_any = [&](const Pieces& pieces, auto test) {
    const std::vector<Step>* const steps = steps_in(pieces);
    if (steps) breathe(16 * steps->size());
    return steps && std::ranges::any_of(*steps, [&](const Step& step) { return (this->*test)(step, place, sine); });
  };
  for (const PatchSpot& in_a : patches_.a.twins(place.at.a, kOnSide)) {
    for (const PatchSpot& in_b : patches_.b.twins(place.at.b, kOnSide)) {
      if (is_on_any({in_a.piece, in_b.piece}, &TracedSteps::is_on)) return true;
    }
  }
  // Beside a side that the curve grazes a step may be in the piece beyond, within the tolerance.
  constexpr double kBeside = 0x1p-5;
  for (const PatchSpot& in_a : patches_.a.twins(place.at.a, kBeside)) {
    for (const PatchSpot& in_b : patches_.b.twins(place.at.b, kBeside)) {
      if (is_on_any({in_a.piece, in_b.piece}, &TracedSteps::is_within)) return true;
    }
  }
  return false;
}

bool TracedSteps::holds_along(const SectionPlace& place) const {
  constexpr double kSame = 1e-3;
  const std::vector<Step>* const steps = steps_in({place.at.a.piece, place.at.b.piece});
  return steps && std::ranges::any_of(*steps, [&](const Step& which) {
    const SectionTrace& trace = traces_[which.trace];
    const SectionStep step(trace.places[which.step], trace.places[which.step + 1]);
    if (!step.is_near(place.point, kRoundingOfPlaces)) return false;
    const SectionPlace& nearer = glm::distance(step.from.point, place.point) < glm::distance(step.to.point, place.point)
                                     ? step.from : step.to;
    return glm::length(glm::cross(nearer.tangent, place.tangent)) <= kSame;
  });
}

/// Whether a step within the tolerance of a place goes its way, there or back.
bool TracedSteps::runs_along(const SectionPlace& place) const {
  constexpr double kAlong = 0.9;
  const std::vector<Step>* const steps = steps_in({place.at.a.piece, place.at.b.piece});
  if (!steps) return false;
  breathe(16 * steps->size());
  return std::ranges::any_of(*steps, [&](const Step& which) {
    const SectionTrace& trace = traces_[which.trace];
    const SectionStep step(trace.places[which.step], trace.places[which.step + 1]);
    return std::abs(glm::dot(step.from.tangent, place.tangent)) >= kAlong && step.is_near(place.point, tolerance_);
  });
}

SectionTrace TracedSteps::without_known_ends(SectionTrace trace) const {
  std::vector<SectionPlace>& places = trace.places;
  if (trace.is_closed || places.empty()) return trace;
  const auto known = [&](std::size_t i) { return runs_along(places[i]); };
  std::size_t first = 0;
  while (first < places.size() && known(first)) ++first;
  if (first == places.size()) return {{}, false};
  std::size_t last = places.size() - 1;
  while (last > first && known(last)) --last;
  // It goes on from where it leaves them.
  if (first > 0) --first;
  if (last + 1 < places.size()) ++last;
  places.erase(places.begin() + static_cast<std::ptrdiff_t>(last + 1), places.end());
  places.erase(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(first));
  return trace;
}

/// Whether a place is within the tolerance of both patches beside a step that goes the same way.
bool TracedSteps::is_within(const Step& which, const SectionPlace& place, double sine) const {
  constexpr double kAlong = 0.9;
  constexpr double kShare = 0x1p-4;
  const SectionTrace& trace = traces_[which.trace];
  const SectionStep step(trace.places[which.step], trace.places[which.step + 1]);
  if (std::abs(glm::dot(step.from.tangent, place.tangent)) < kAlong) return false;
  return step.is_near(place.point, std::min(tolerance_ / sine, kShare * step.length + tolerance_));
}

/// Whether Newton's method comes to a place from the step of a trace beside it: where surfaces cross at a small angle a
/// step may be far from the place, within the tolerance of both.
bool TracedSteps::is_on(const Step& which, const SectionPlace& place, double sine) const {
  const SectionTrace& trace = traces_[which.trace];
  const SectionStep step(trace.places[which.step], trace.places[which.step + 1]);
  const glm::dvec3 chord = step.to.point - step.from.point;
  const double square = glm::dot(chord, chord);
  if (!(square > 0.0)) return false;
  const double s = glm::dot(place.point - step.from.point, chord) / square;
  const double beyond = 1e-6 + tolerance_ / step.length;
  if (s < -beyond || s > 1.0 + beyond) return false;
  constexpr double kBeside = 0.25;
  const glm::dvec3 beside = step.point(std::clamp(s, 0.0, 1.0));
  if (glm::distance(beside, place.point) > kBeside * step.length + tolerance_) return false;
  const std::optional<PatchSpots> at =
      place_near(patches_, step.spots(std::clamp(s, 0.0, 1.0)), InPlane{place.point, place.tangent});
  if (!at) return false;
  constexpr double kSame = 0x1p-26;
  constexpr double kRounding = 0x1p-44;
  return glm::distance(patches_.a.at(at->a).point, place.point) <= kSame * step.length + kRounding / sine;
}

bool TracedSteps::are_near(const glm::dvec3& point, double distance) const {
  return std::ranges::any_of(traces_, [&](const SectionTrace& trace) {
    breathe(8 * trace.places.size());
    for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
      if (SectionStep(trace.places[i], trace.places[i + 1]).is_near(point, distance)) return true;
    }
    return false;
  });
}

std::vector<Interval> TracedSteps::gaps(const CrossingPart& part) const {
  constexpr double kNothing = 0x1p-3;  // of the tolerance
  const Interval& whole = part.range(part.lead);
  std::vector<Interval> settled;
  if (const std::vector<Step>* const steps = steps_in({part.a.piece, part.b.piece})) {
    breathe(64 * steps->size());
    for (const Step& step : *steps) {
      for (std::size_t k = 0; k + 1 < kSamples; ++k) {
        const auto inside = clipped(part, step.at[k], step.at[k + 1]);
        if (!inside) continue;
        settled.push_back(settled_range(part, between(step.at[k], step.at[k + 1], inside->start),
                                        between(step.at[k], step.at[k + 1], inside->end)));
      }
    }
  }
  std::ranges::sort(settled, {}, &Interval::start);
  std::vector<Interval> gaps;
  const double length = part.length_along(part.lead);
  const auto add = [&](double start, double end) {
    const bool counts = (end - start) * length > kNothing * tolerance_ * whole.length();
    if (counts && end - start > slack_of(whole)) gaps.push_back({start, end});
  };
  double at = whole.start;
  for (const Interval& range : settled) {
    add(at, std::min(range.start, whole.end));
    at = std::max(at, range.end);
  }
  add(at, whole.end);
  return gaps;
}

}  // namespace splinecore
