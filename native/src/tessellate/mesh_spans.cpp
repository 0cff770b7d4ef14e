#include "splinecore/tessellate/mesh_spans.hpp"

#include <algorithm>
#include <cmath>

namespace splinecore {

namespace {

/// Whether the first derivative may jump between two parameters, and whether the value may.
void describe_joint(const KnotVector& knots, double from, MeshSpan& next) {
  int count = 0;
  for (const double u : knots.unrolled()) count += u >= from && u <= next.range.start;
  next.is_crease = count >= knots.degree();
  for (const double u : knots.unrolled()) {
    if (u >= from && u <= next.range.start) next.is_gap |= multiplicity(knots, u) > knots.degree();
  }
}

}  // namespace

std::vector<MeshSpan> mesh_spans(const KnotVector& knots) {
  constexpr double kShortest = 1e-9;
  const Interval domain = knots.domain();
  std::vector<MeshSpan> found;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval range = knots.span_interval(i);
    if (range.length() > kShortest * domain.length()) found.push_back({range, i});
  }
  for (std::size_t i = 1; i < found.size(); ++i) describe_joint(knots, found[i - 1].range.end, found[i]);
  found.front().range.start = domain.start;
  found.back().range.end = domain.end;
  return found;
}

std::vector<std::array<std::vector<MeshSpan>, 2>> mesh_spans(const PatchSet& set) {
  std::vector<std::array<std::vector<MeshSpan>, 2>> found;
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& patch = nurbs_of(set.patch(i));
    found.push_back({mesh_spans(patch.knot_vector(Axis::u)), mesh_spans(patch.knot_vector(Axis::v))});
  }
  return found;
}

double parameter_at(const std::vector<MeshSpan>& spans, Place place) {
  const Place span = std::min(place / kSpan, static_cast<Place>(spans.size()) - 1);
  const Interval& range = spans[span].range;
  const Place part = place - span * kSpan;
  if (part == kSpan) return range.end;
  return range.start + range.length() * (static_cast<double>(part) / static_cast<double>(kSpan));
}

double parameter_before(const std::vector<MeshSpan>& spans, Place place) {
  return place > 0 && place % kSpan == 0 ? spans[place / kSpan - 1].range.end : parameter_at(spans, place);
}

Place place_of(const std::vector<MeshSpan>& spans, double u) {
  auto span = std::ranges::upper_bound(spans, u, {}, [](const MeshSpan& s) { return s.range.start; });
  if (span != spans.begin()) --span;
  const double part = std::clamp((u - span->range.start) / span->range.length(), 0.0, 1.0);
  return (span - spans.begin()) * kSpan + std::llround(part * static_cast<double>(kSpan));
}

}  // namespace splinecore
