#include "offset_loops.hpp"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "curve_parts.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/meet/intersections.hpp"

namespace splinecore {

namespace {

/// Of where a curve meets itself: ends as near are joined.
constexpr double kJoined = 0x1p-28;

/// Whether a stretch of a curve lies within the tolerance of what is before it and behind it.
bool is_repeated(const NurbsCurve& curve, const Interval& stretch, double tolerance) {
  const Interval domain = curve.domain();
  std::vector<NurbsCurve> rest;
  for (const Interval& range : {Interval{domain.start, stretch.start}, Interval{stretch.end, domain.end}}) {
    if (range.length() > kSamePlace * domain.length()) rest.push_back(part_of(curve, range));
  }
  return is_covered(part_of(curve, stretch), rest, tolerance);
}

/// What a curve goes through between two times that it is at one place, the longest first.
std::vector<Interval> loops_of(const NurbsCurve& curve) {
  const CurveIntersections found = self_intersections(curve);
  std::vector<Interval> loops;
  for (const CurveIntersection& place : found.places) loops.push_back({place.a, place.b});
  for (const CurveOverlap& overlap : found.overlaps) {
    loops.push_back({overlap.a.start, std::min(overlap.b.end, curve.domain().end)});
  }
  std::erase_if(loops, [&](const Interval& loop) { return !(loop.length() > kSamePlace * curve.domain().length()); });
  std::ranges::stable_sort(loops, std::ranges::greater{}, &Interval::length);
  return loops;
}

/// What is left of a run; none if nothing is left out.
std::optional<BezierPieces> shortened(const BezierPieces& run, double tolerance) {
  const NurbsCurve curve = curve_of(run);
  std::vector<Interval> left_out;
  for (const Interval& loop : loops_of(curve)) {
    const auto overlaps = [&](const Interval& other) { return loop.start < other.end && other.start < loop.end; };
    if (std::ranges::none_of(left_out, overlaps) && is_repeated(curve, loop, tolerance)) left_out.push_back(loop);
  }
  if (left_out.empty()) return std::nullopt;
  std::ranges::sort(left_out, {}, &Interval::start);
  left_out.push_back({curve.domain().end, curve.domain().end});
  BezierPieces whole;
  double from = curve.domain().start;
  for (const Interval& gap : left_out) {
    if (gap.start - from > kSamePlace * curve.domain().length()) {
      const BezierPieces part = to_bezier(part_of(curve, {from, gap.start}));
      if (!whole.empty() && glm::distance(end_of(whole.back()), start_of(part.front())) > kJoined) {
        whole.push_back(bezier_line(end_of(whole.back()), start_of(part.front())));
      }
      whole.insert(whole.end(), part.begin(), part.end());
    }
    from = gap.end;
  }
  return whole;
}

BezierCurve with_end(const BezierCurve& piece, bool is_last, const glm::dvec3& place) {
  std::vector<glm::dvec4> points(piece.points().begin(), piece.points().end());
  glm::dvec4& end = is_last ? points.back() : points.front();
  end = glm::dvec4(place, end.w);
  return piece.with_points(std::move(points));
}

}  // namespace

BezierPieces without_specks(const BezierPieces& run, double tolerance) {
  constexpr double kSpeck = 0x1p-20;
  constexpr double kOfTolerance = 0x1p-6;
  const double most = std::min(kSpeck, kOfTolerance * tolerance);
  BezierPieces kept;
  std::optional<glm::dvec3> start;
  for (const BezierCurve& piece : run) {
    if (length_of(piece) <= most) {
      if (!start) start = start_of(piece);
      continue;
    }
    kept.push_back(start ? with_end(piece, false, *start) : piece);
    start.reset();
  }
  if (kept.empty()) return run;
  if (start) kept.back() = with_end(kept.back(), true, end_of(run.back()));
  return kept;
}

BezierPieces ended_at_start(BezierPieces run) {
  const glm::dvec3 start = start_of(run.front());
  if (run.size() < 2 || glm::distance(end_of(run.back()), start) > kSamePlace) return run;
  // With other weights at the ends their points, divided by these, would differ in the last bit.
  for (BezierCurve& piece : run) {
    if (piece.points().front().w != 1.0 || piece.points().back().w != 1.0) piece = standard_form(piece);
  }
  run.back() = with_end(run.back(), true, start);
  return run;
}

BezierPieces without_loops(const BezierPieces& run, double tolerance) {
  // Of loops that overlap one goes at a time.
  constexpr int kRounds = 8;
  BezierPieces left = run;
  for (int i = 0; i < kRounds; ++i) {
    std::optional<BezierPieces> next = shortened(left, tolerance);
    if (!next || next->empty()) break;
    left = std::move(*next);
  }
  return left;
}

}  // namespace splinecore
