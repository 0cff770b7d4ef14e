#include "patch_match.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "boxed_pieces.hpp"
#include "matched_axes.hpp"
#include "matched_borders.hpp"
#include "matched_nets.hpp"
#include "one_sheet.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

Interval local(const Interval& range, const Interval& span) {
  return {std::clamp((range.start - span.start) / span.length(), 0.0, 1.0),
          std::clamp((range.end - span.start) / span.length(), 0.0, 1.0)};
}

bool is_inside(const Interval& range, const Interval& whole, double share = 0x1p-40) {
  const double slack = share * whole.length();
  return range.start >= whole.start - slack && range.end <= whole.end + slack;
}

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.start, b.start), std::max(a.end, b.end)}; }

std::array<Interval, 2> parameters_of(const PatchPieces& patch, const PatchPart& part) {
  const auto start = patch.parameters({part.piece, {part.range[0].start, part.range[1].start}});
  const auto end = patch.parameters({part.piece, {part.range[0].end, part.range[1].end}});
  return {Interval{start[0], end[0]}, Interval{start[1], end[1]}};
}

}  // namespace

PatchSpots matched_spots(const TwoPatches& patches, bool is_exchanged, const std::array<MatchedSpan, 2>& spans,
                         const std::array<double, 2>& shares) {
  PatchSpots at{};
  const std::array<std::size_t, 2> own{is_exchanged ? std::size_t{1} : 0, is_exchanged ? std::size_t{0} : 1};
  std::array<std::size_t, 2> in_b{};
  for (std::size_t k = 0; k < 2; ++k) {
    at.a.at[k] = std::lerp(spans[k].a.start, spans[k].a.end, shares[k]);
    at.b.at[own[k]] = spans[k].b_at(shares[k]);
    in_b[own[k]] = spans[k].span_b;
  }
  at.a.piece = patches.a.piece_in(spans[0].span_a, spans[1].span_a);
  at.b.piece = patches.b.piece_in(in_b[0], in_b[1]);
  return at;
}

std::optional<PatchMatch> PatchMatch::of(const TwoPatches& patches, double tolerance) {
  constexpr std::size_t kMostProducts = std::size_t{1} << 29;  // of control points, in all pieces together
  const std::size_t in_pieces = patches.a.piece(0).values.size() * patches.b.piece(0).values.size();
  if (in_pieces * std::max(patches.a.size(), patches.b.size()) > kMostProducts) return {};
  for (const std::array<AxisMatch, 2>& axes : axis_matches(patches, tolerance)) {
    PatchMatch match(patches, axes, tolerance);
    if (match.is_near_at_places() && match.is_near_all_over()) return match;
  }
  return {};
}

bool PatchMatch::is_near_at_places() const {
  constexpr std::array<double, 5> kLooks{0.03, 0.26, 0.5, 0.77, 0.97};
  for (const double x : kLooks) {
    for (const double y : kLooks) {
      const std::array<double, 2> of_a{std::lerp(axes_[0].from.start, axes_[0].from.end, x),
                                       std::lerp(axes_[1].from.start, axes_[1].from.end, y)};
      std::array<double, 2> of_b{axes_[0].to(of_a[0]), axes_[1].to(of_a[1])};
      if (is_exchanged()) std::swap(of_b[0], of_b[1]);
      const glm::dvec3 point = patches_.a.at(patches_.a.spot(of_a)).point;
      if (!(glm::length(patches_.b.at(patches_.b.spot(of_b), point).offset) <= tolerance_)) return false;
    }
  }
  return true;
}

bool PatchMatch::is_near_all_over() const {
  const std::vector<MatchedSpan> u = spans_along(0);
  const std::vector<MatchedSpan> v = spans_along(1);
  for (const MatchedSpan& of_u : u) {
    for (const MatchedSpan& of_v : v) {
      const std::size_t in_a = patches_.a.piece_in(of_u.span_a, of_v.span_a);
      const MatchedSpan& b_u = is_exchanged() ? of_v : of_u;
      const MatchedSpan& b_v = is_exchanged() ? of_u : of_v;
      const std::size_t in_b = patches_.b.piece_in(b_u.span_b, b_v.span_b);
      const PatchPart a = part_of(in_a, patches_.a.piece(in_a), {of_u.a, of_v.a});
      const PatchPart b = part_of(in_b, patches_.b.piece(in_b), {b_u.b, b_v.b});
      if (!are_within(a.net, turned(b.net, is_exchanged(), of_u.is_reversed, of_v.is_reversed), tolerance_)) return false;
    }
  }
  return true;
}

double PatchMatch::largest_gap() const {
  constexpr int kLooks = 7;
  const std::array<std::vector<MatchedSpan>, 2> spans{spans_along(0), spans_along(1)};
  double most = 0.0;
  for (const MatchedSpan& u : spans[0]) {
    for (const MatchedSpan& v : spans[1]) {
      for (int i = 0; i < kLooks * kLooks; ++i) {
        breathe(256);
        const PatchSpots at = matched_spots(patches_, is_exchanged(), {u, v}, {(i / kLooks) / (kLooks - 1.0),
                                                                               (i % kLooks) / (kLooks - 1.0)});
        const PatchMeeting here = meeting_at(patches_, at);
        most = std::max(most, std::abs(glm::dot(here.b.offset, here.normal_a)));
      }
    }
  }
  return most;
}

std::vector<MatchedSpan> PatchMatch::spans_along(std::size_t k) const {
  constexpr double kSame = 0x1p-36;
  const AxisMatch& match = axes_[k];
  const KnotVector& of_a = patches_.a.knots(k == 0 ? Axis::u : Axis::v);
  const KnotVector& of_b = patches_.b.knots(match.axis);
  std::vector<double> marks{match.from.start, match.from.end};
  const auto add = [&](double t) {
    if (t > match.from.start && t < match.from.end) marks.push_back(t);
  };
  for (int i = 0; i < static_cast<int>(of_a.spans().size()); ++i) add(of_a.span_interval(i).start);
  for (int i = 0; i < static_cast<int>(of_b.spans().size()); ++i) add(match.back(of_b.span_interval(i).start));
  std::ranges::sort(marks);
  std::vector<MatchedSpan> found;
  double start = marks.front();
  for (std::size_t i = 1; i < marks.size(); ++i) {
    const bool is_last = i + 1 == marks.size();
    if (!is_last && marks[i] - start <= kSame * match.from.length()) continue;
    if (!is_last && marks.back() - marks[i] <= kSame * match.from.length()) continue;
    const double middle = 0.5 * (start + marks[i]);
    const double one = match.to(start);
    const double other = match.to(marks[i]);
    const int in_a = of_a.span_of(middle, Side::right);
    const int in_b = of_b.span_of(match.to(middle), Side::right);
    found.push_back({static_cast<std::size_t>(in_a), local({start, marks[i]}, of_a.span_interval(in_a)),
                     static_cast<std::size_t>(in_b),
                     local({std::min(one, other), std::max(one, other)}, of_b.span_interval(in_b)), other < one});
    start = marks[i];
  }
  return found;
}

std::array<Interval, 2> PatchMatch::range_of(const PatchPart& b) const {
  const std::array<Interval, 2> own = parameters_of(patches_.b, b);
  const auto along = [&](const AxisMatch& match) { return match.back(own[match.axis == Axis::u ? 0 : 1]); };
  return {along(axes_[0]), along(axes_[1])};
}

/// Whether along an axis both patches go on at both ends of what is one: they are closed.
bool PatchMatch::goes_on_over_end(std::size_t k) const {
  const auto goes_on = [](const PatchPieces& patch, Axis axis) {
    return patch.beyond(0, {axis, false}) || patch.beyond(patch.size() - 1, {axis, true});
  };
  return goes_on(patches_.a, k == 0 ? Axis::u : Axis::v) && goes_on(patches_.b, axes_[k].axis);
}

bool PatchMatch::explains(const PatchPart& a, const PatchPart& b) const {
  const std::array<Interval, 2> of_a = parameters_of(patches_.a, a);
  const std::array<Interval, 2> of_b = range_of(b);
  std::array<Interval, 2> both;
  std::array<Interval, 2> in_b;
  std::array<bool, 2> is_in_a{};
  std::array<bool, 2> is_in_b{};
  for (std::size_t k = 0; k < 2; ++k) {
    const AxisMatch& match = axes_[k];
    const double turn = match.from.length();
    const bool is_round = goes_on_over_end(k);
    const double shift = is_round ? std::round((of_a[k].middle() - of_b[k].middle()) / turn) * turn : 0.0;
    both[k] = hull(of_a[k], {of_b[k].start + shift, of_b[k].end + shift});
    if (both[k].length() > 0.5 * turn && is_round) return false;
    const double one = match.to(both[k].start);
    const double other = match.to(both[k].end);
    const std::size_t own = match.axis == Axis::u ? 0 : 1;
    in_b[own] = {std::min(one, other), std::max(one, other)};
    is_in_a[k] = is_round || is_inside(both[k], patches_.a.knots(k == 0 ? Axis::u : Axis::v).domain());
    is_in_b[own] = is_round || is_inside(in_b[own], patches_.b.knots(match.axis).domain());
  }
  if (is_in_a[0] && is_in_a[1]) return is_one_sheet(patches_.a, both);
  return is_in_b[0] && is_in_b[1] && is_one_sheet(patches_.b, in_b);
}

bool PatchMatch::is_within(const PatchSpots& at, double slack) const {
  const std::array<double, 2> a = patches_.a.parameters(at.a);
  const std::array<double, 2> b = patches_.b.parameters(at.b);
  for (std::size_t k = 0; k < 2; ++k) {
    const double back = axes_[k].back(b[axes_[k].axis == Axis::u ? 0 : 1]);
    if (!is_inside({a[k], a[k]}, axes_[k].from, slack) || !is_inside({back, back}, axes_[k].from, slack)) return false;
  }
  return true;
}

bool PatchMatch::joins(const PatchSpots& at) const {
  constexpr double kNear = 0x1p-8;
  const std::array<double, 2> a = patches_.a.parameters(at.a);
  const std::array<double, 2> b = patches_.b.parameters(at.b);
  for (std::size_t k = 0; k < 2; ++k) {
    const double turn = axes_[k].from.length();
    double off = (axes_[k].back(b[axes_[k].axis == Axis::u ? 0 : 1]) - a[k]) / turn;
    if (goes_on_over_end(k)) off -= std::round(off);
    if (std::abs(off) > kNear) return false;
  }
  return is_about(at);
}

std::vector<SectionTrace> PatchMatch::borders() const {
  return matched_borders(patches_, axes_, {spans_along(0), spans_along(1)}, tolerance_);
}

}  // namespace splinecore
