#include "mesh_spans.hpp"

#include <algorithm>
#include <cmath>

#include "base/length.hpp"
#include "basis/bernstein_net.hpp"
#include "patch/bezier_piece.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

/// Whether the first derivative may jump between two parameters, and whether the value may.
void describe_joint(const KnotVector& knots, double from, MeshSpan& next) {
  const auto all = knots.unrolled();
  const auto first = std::ranges::lower_bound(all, from);
  const auto behind = std::ranges::upper_bound(all, next.range.start);
  next.is_crease = behind - first >= knots.degree();
  for (auto knot = first; knot < behind && !next.is_gap; ++knot) {
    next.is_gap = multiplicity(knots, *knot) > knots.degree();
  }
}

/// How far apart points of a patch may lie and still be one.
double rounding_of(const NurbsPatch& patch) {
  constexpr double kOnePoint = 1e-10;
  constexpr double kUlps = 0x1p-48;
  return std::max(kOnePoint * extent(patch.points()), kUlps * largest_coordinate(patch.points()));
}

/// Whether the points of a piece along a direction are one, on every line.
bool stands_still(const BernsteinNet<glm::dvec4>& piece, Axis axis, double tolerance) {
  const glm::dvec4* const first = piece.values.data();
  for (std::size_t i = 0; i < piece.rows; ++i) {
    for (std::size_t j = 0; j < piece.columns; ++j) {
      const glm::dvec4& p = piece.at(i, j);
      const glm::dvec4& from = axis == Axis::u ? first[j] : first[i * piece.columns];
      // Of the projected points, without dividing by a weight that may be 0.
      const glm::dvec3 apart = glm::dvec3(p) * from.w - glm::dvec3(from) * p.w;
      if (!(length_of(apart) <= tolerance * std::abs(p.w * from.w))) return false;
    }
  }
  return true;
}

/// Whether nothing is lost without a span.
bool is_joint(const NurbsPatch& patch, Axis axis, int span, double tolerance) {
  const bool is_u = axis == Axis::u;
  const int count = static_cast<int>(patch.knot_vector(is_u ? Axis::v : Axis::u).spans().size());
  for (int other = 0; other < count; ++other) {
    const auto piece = is_u ? bezier_piece(patch, span, other) : bezier_piece(patch, other, span);
    if (!stands_still(piece, axis, tolerance)) return false;
  }
  return true;
}

}  // namespace

std::vector<MeshSpan> mesh_spans(const NurbsPatch& patch, Axis axis) {
  constexpr double kShort = 1e-9;
  constexpr double kSliver = 0x1p-49;
  const KnotVector& knots = patch.knot_vector(axis);
  const Interval domain = knots.domain();
  const double tolerance = rounding_of(patch);
  std::vector<MeshSpan> found;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval range = knots.span_interval(i);
    if (range.length() > kShort * domain.length() || !is_joint(patch, axis, i, tolerance)) found.push_back({range, i});
  }
  const double longest_sliver = kSliver * std::max(std::abs(domain.start), std::abs(domain.end));
  for (MeshSpan& span : found) span.is_sliver = span.range.length() <= longest_sliver;
  for (std::size_t i = 1; i < found.size(); ++i) describe_joint(knots, found[i - 1].range.end, found[i]);
  if (found.empty()) found.push_back({domain, 0});
  found.front().range.start = domain.start;
  found.back().range.end = domain.end;
  return found;
}

std::vector<std::array<std::vector<MeshSpan>, 2>> mesh_spans(const PatchSet& set) {
  std::vector<std::array<std::vector<MeshSpan>, 2>> found;
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& patch = nurbs_of(set.patch(i));
    found.push_back({mesh_spans(patch, Axis::u), mesh_spans(patch, Axis::v)});
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
