#include "one_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "base/rounding.hpp"
#include "patch_part.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

struct SpanPart {
  std::size_t span;
  Interval range;  ///< in [0, 1] of it
};

/// The parts of spans that a range of a parameter covers, none if there are many.
std::vector<SpanPart> parts_along(const KnotVector& knots, const Interval& range) {
  constexpr std::size_t kMost = 4;
  const Interval domain = knots.domain();
  std::vector<SpanPart> found;
  for (const double turn : {-domain.length(), 0.0, domain.length()}) {
    const Interval here{range.start + turn, range.end + turn};
    if (here.end <= domain.start || here.start >= domain.end) continue;
    for (std::size_t i = 0; i < knots.spans().size(); ++i) {
      const Interval span = knots.span_interval(static_cast<int>(i));
      if (span.end <= here.start) continue;
      if (span.start >= here.end) break;
      const double start = std::max(0.0, (here.start - span.start) / span.length());
      const double end = std::min(1.0, (here.end - span.start) / span.length());
      if (end - start <= kRoundingOfPlace) continue;
      if (found.size() == kMost) return {};
      found.push_back({i, {start, end}});
    }
  }
  return found;
}

/// A derivative, times a positive number, and how far weights make it wrong.
struct Way {
  glm::dvec3 vector;
  double slack;
};

/// Derivatives X' - S w' of parts whose points S are in a ball.
std::vector<Way> ways_along(const std::vector<PatchPart>& parts, Axis axis, const glm::dvec3& center, double radius) {
  std::vector<Way> found;
  for (const PatchPart& part : parts) {
    const BernsteinNet<glm::dvec4>& net = part.net;
    const std::size_t step = axis == Axis::u ? net.columns : 1;
    const double sign = net.values.front().w < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i + (axis == Axis::u ? 1 : 0) < net.rows; ++i) {
      for (std::size_t j = 0; j + (axis == Axis::v ? 1 : 0) < net.columns; ++j) {
        const std::size_t k = i * net.columns + j;
        const glm::dvec4 way = sign * (net.values[k + step] - net.values[k]);
        const glm::dvec3 vector = glm::dvec3(way) - way.w * center;
        const double slack = radius * std::abs(way.w);
        if (glm::length(vector) + slack > kRoundingOfShape * std::abs(net.values[k].w)) found.push_back({vector, slack});
      }
    }
  }
  return found;
}

glm::dvec3 mean_of(const std::vector<Way>& ways) {
  glm::dvec3 sum(0.0);
  for (const Way& way : ways) sum += way.vector / std::max(glm::length(way.vector), 1e-300);
  return sum;
}

/// Coordinates in a plane, along two vectors, as seen along what is at right angles to both.
struct SheetPlane {
  glm::dvec3 by_first;
  glm::dvec3 by_second;

  static std::optional<SheetPlane> along(const glm::dvec3& first, const glm::dvec3& second) {
    const glm::dvec3 normal = glm::cross(first, second);
    const double square = glm::dot(normal, normal);
    if (!(square > 0.0)) return {};
    return SheetPlane{glm::cross(second, normal) / square, glm::cross(normal, first) / square};
  }

  /// The angles of vectors from an axis of the plane; none where one may be turned by a right angle or more.
  std::optional<Interval> angles(const std::vector<Way>& ways, bool from_first) const {
    const double widest = std::max(glm::length(by_first), glm::length(by_second)) * std::numbers::sqrt2;
    Interval found{0.0, 0.0};
    for (const Way& way : ways) {
      const double x = glm::dot(way.vector, from_first ? by_first : by_second);
      const double y = glm::dot(way.vector, from_first ? by_second : by_first) * (from_first ? 1.0 : -1.0);
      const double length = std::hypot(x, y);
      const double off = widest * way.slack;
      if (!(x > 0.0) || !(off < length)) return {};
      const double wrong = std::asin(off / length);
      const double angle = std::atan2(y, x);
      found = {std::min(found.start, angle - wrong), std::max(found.end, angle + wrong)};
    }
    constexpr double kMost = 0.5 * std::numbers::pi;
    return found.start > -kMost && found.end < kMost ? std::optional(found) : std::nullopt;
  }
};

}  // namespace

bool is_one_sheet(const PatchPieces& patch, const std::array<Interval, 2>& range) {
  constexpr double kMargin = 0.01;
  const std::vector<SpanPart> along_u = parts_along(patch.knots(Axis::u), range[0]);
  const std::vector<SpanPart> along_v = parts_along(patch.knots(Axis::v), range[1]);
  if (along_u.empty() || along_v.empty()) return false;
  std::vector<PatchPart> parts;
  for (const SpanPart& u : along_u) {
    for (const SpanPart& v : along_v) {
      const std::size_t piece = patch.piece_in(u.span, v.span);
      breathe(64 * patch.piece(piece).values.size());
      parts.push_back(part_of(piece, patch.piece(piece), {u.range, v.range}));
      if (!parts.back().is_boxed) return false;
    }
  }
  const glm::dvec3 center = 0.5 * (parts.front().points.front() + parts.back().points.back());
  double radius = 0.0;
  for (const PatchPart& part : parts) {
    for (const glm::dvec3& point : part.points) radius = std::max(radius, glm::distance(point, center));
  }
  const std::vector<Way> by_u = ways_along(parts, Axis::u, center, radius);
  const std::vector<Way> by_v = ways_along(parts, Axis::v, center, radius);
  if (by_u.empty() || by_v.empty()) return false;
  const auto plane = SheetPlane::along(mean_of(by_u), mean_of(by_v));
  if (!plane) return false;
  const auto of_u = plane->angles(by_u, true);
  const auto of_v = plane->angles(by_v, false);
  constexpr double kRight = 0.5 * std::numbers::pi - kMargin;
  return of_u && of_v && of_u->end - of_v->start < kRight && of_v->end - of_u->start < kRight;
}

}  // namespace splinecore
