#include "splinecore/curve/finite_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "base/given_points.hpp"
#include "base/one_sign.hpp"
#include "base/require.hpp"
#include "basis/bernstein_net.hpp"
#include "basis/gaps.hpp"
#include "bezier_piece.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

using Piece = BernsteinNet<glm::dvec4>;

/// The box of the finite control points, and how far around it a curve may run.
struct Room {
  glm::dvec3 center;
  glm::dvec3 half;
  double length;

  glm::dvec3 reach(double lengths) const { return half + glm::dvec3(lengths * length); }
};

Room room_around(std::span<const glm::dvec3> points, double length) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (const glm::dvec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {0.5 * low + 0.5 * high, 0.5 * high - 0.5 * low, length};
}

std::vector<glm::dvec3> finite_points(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec3> finite;
  for (const glm::dvec4& p : points) {
    if (p.w != 0.0) finite.emplace_back(p);
  }
  return finite;
}

/// Whether all points lie in the box around the room's center, up to `noise` in homogeneous
/// coordinates. With weights of one sign the hull property says the same of the curve.
bool lies_within(std::span<const glm::dvec4> points, const Room& room, const glm::dvec3& reach, double noise) {
  return std::ranges::all_of(points, [&](const glm::dvec4& p) {
    const glm::dvec3 offset = glm::abs(glm::dvec3(p) - p.w * room.center);
    const glm::dvec3 most = std::abs(p.w) * reach + glm::dvec3(4.0 * noise);
    return offset.x <= most.x && offset.y <= most.y && offset.z <= most.z;
  });
}

/// Whether the whole curve lies beyond one pair of the box's faces, seen through infinity or not.
bool lies_beyond(std::span<const glm::dvec4> points, const Room& room, const glm::dvec3& reach) {
  const auto is_beyond = [&](int axis, double sign) {
    return std::ranges::all_of(points, [&](const glm::dvec4& p) {
      return sign * (p[axis] - p.w * room.center[axis]) > std::abs(p.w) * reach[axis];
    });
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (is_beyond(axis, 1.0) || is_beyond(axis, -1.0)) return true;
  }
  return false;
}

double size_of(std::span<const glm::dvec4> points, const Room& room) {
  double size = 0.0;
  for (const glm::dvec4& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      size = std::max({size, std::abs(p[axis] - p.w * room.center[axis]), std::abs(p.w) * room.reach(1.0)[axis]});
    }
  }
  return size;
}

/// What rounding may do to the homogeneous points of a span, seen from the room's center.
struct Noise {
  double offset = 0.0;
  double weight = 0.0;
};

Noise noise_of(std::span<const glm::dvec4> span, const Room& room) {
  const double ulps = 4.0 * static_cast<double>(span.size()) * std::numeric_limits<double>::epsilon();
  Noise size{size_of(span, room), 0.0};
  for (const glm::dvec4& p : span) {
    size.weight = std::max(size.weight, std::abs(p.w));
    for (int axis = 0; axis < 3; ++axis) {
      size.offset = std::max({size.offset, std::abs(p[axis]), std::abs(p.w * room.center[axis])});
    }
  }
  return {ulps * size.offset, ulps * size.weight};
}

/// Finds the parts of one span, over [0, 1], that lie in the room.
class ArcSearch {
 public:
  ArcSearch(const Piece& span, const Room& room) : room_(room), noise_(noise_of(span.values, room)) {
    visit(span, {0.0, 1.0}, 0);
  }

  /// In order; neighbors do not touch.
  const std::vector<Interval>& found() const noexcept { return found_; }
  const Noise& noise() const noexcept { return noise_; }

 private:
  // An end of a part is known to one in 2^48 of the span.
  static constexpr int kDeepest = 48;
  // Between the two boxes every short part is decided, so that the search ends.
  static constexpr double kInner = 1.0 - 1e-9;
  // A point that is no larger has hardly one good digit. More than the slack of lies_within(), so
  // that a short part whose weight is noise lies beyond or is undefined.
  static constexpr double kUndefined = 16.0;

  void visit(Piece piece, Interval range, int depth) {
    const std::span<const glm::dvec4> points(piece.values);
    if (size_of(points, room_) <= kUndefined * noise_.offset || lies_beyond(points, room_, room_.reach(kInner))) return;
    const bool is_inside = has_one_sign(points, &glm::dvec4::w, noise_.weight) &&
                           lies_within(points, room_, room_.reach(1.0), noise_.offset);
    if (is_inside) return keep(range);
    if (depth == kDeepest) return;
    Piece after;
    piece.halve(Axis::u, after);
    visit(std::move(piece), {range.start, range.middle()}, depth + 1);
    visit(std::move(after), {range.middle(), range.end}, depth + 1);
  }

  void keep(Interval range) {
    if (!found_.empty() && found_.back().end == range.start) {
      found_.back().end = range.end;
    } else {
      found_.push_back(range);
    }
  }

  const Room& room_;
  Noise noise_;
  std::vector<Interval> found_;
};

/// Bezier pieces that follow each other: knots at their ends, and homogeneous points of all.
struct Chain {
  std::vector<double> ends;
  std::vector<glm::dvec4> points;
};

void append(Chain& chain, std::span<const glm::dvec4> points, Interval range) {
  if (chain.ends.empty()) {
    chain.ends.push_back(range.start);
    chain.points.push_back(points.front());
  }
  chain.ends.push_back(range.end);
  chain.points.insert(chain.points.end(), points.begin() + 1, points.end());
}

/// Subdivides until all weights have one sign and no control point lies far out.
void append_positive(Chain& chain, Piece piece, Interval range, const Room& room,
                     const Noise& noise) {
  const std::span<const glm::dvec4> points(piece.values);
  const double middle = range.middle();
  const bool is_short = !(middle > range.start && middle < range.end);
  if (is_short || (has_one_sign(points, &glm::dvec4::w) && lies_within(points, room, room.reach(2.0), noise.offset))) {
    append(chain, points, range);
    return;
  }
  Piece after;
  piece.halve(Axis::u, after);
  append_positive(chain, std::move(piece), {range.start, middle}, room, noise);
  append_positive(chain, std::move(after), {middle, range.end}, room, noise);
}

/// The part of a span between two of its parameters in [0, 1].
Piece restricted(Piece piece, Interval part) {
  Piece after;
  piece.cut(Axis::u, part.end, after);
  if (part.start == 0.0) return piece;
  piece.cut(Axis::u, part.start / part.end, after);
  return after;
}

std::vector<Chain> chains_of(const NurbsCurve& curve, const Room& room) {
  const KnotVector& knots = curve.knot_vector();
  std::vector<Chain> chains;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Piece points = bezier_piece(curve, i);
    const Interval span = knots.span_interval(i);
    const auto at = [&](double t) { return t == 1.0 ? span.end : span.start + t * span.length(); };
    const ArcSearch search(points, room);
    for (const Interval& part : search.found()) {
      const Interval range{at(part.start), at(part.end)};
      if (!(range.start < range.end)) continue;
      const bool goes_on = !chains.empty() && part.start == 0.0 && chains.back().ends.back() == span.start &&
                           multiplicity(knots, span.start) <= knots.degree();
      if (!goes_on) chains.emplace_back();
      append_positive(chains.back(), restricted(points, part), range, room, search.noise());
    }
  }
  return chains;
}

NurbsCurve curve_of(Chain chain, const NurbsCurve& whole) {
  const int degree = whole.degree();
  std::vector<double> knots{chain.ends.front()};
  for (const double u : chain.ends) knots.insert(knots.end(), degree, u);
  knots.push_back(chain.ends.back());
  if (chain.points.front().w < 0.0) {
    for (glm::dvec4& p : chain.points) p = -p;
  }
  return NurbsCurve::make(KnotVector::make(degree, std::move(knots)), as_given_from(whole, chain.points).made);
}

std::vector<NurbsCurve> cut_at_gaps(const NurbsCurve& curve) {
  const std::vector<double> at = gaps(curve.knot_vector());
  if (at.empty()) return {curve};
  if (curve.periodic()) return cut_at_gaps(opened(curve, at.front()));
  std::vector<NurbsCurve> parts{curve};
  for (const double u : at) {
    auto [before, after] = split(parts.back(), u);
    parts.back() = std::move(before);
    parts.push_back(std::move(after));
  }
  return parts;
}

NurbsCurve with_positive_weights(const NurbsCurve& curve) {
  if (curve.points().front().w > 0.0) return curve;
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& p : points) p.w = -p.w;
  return curve.with_points(std::move(points));
}

/// Whether the first and the last arc of a periodic curve are one arc that the seam cuts.
bool is_cut_by_seam(const NurbsCurve& curve, const std::vector<Chain>& chains) {
  const Interval domain = curve.domain();
  return curve.periodic() && chains.size() > 1 && chains.front().ends.front() == domain.start &&
         chains.back().ends.back() == domain.end && multiplicity(curve.knot_vector(), domain.start) <= curve.degree();
}

}  // namespace

std::vector<NurbsCurve> finite_arcs(const NurbsCurve& curve, double length, std::span<const glm::dvec3> around) {
  require_positive(length, "length");
  if (around.empty() && has_one_sign(curve.points(), &glm::dvec4::w)) return cut_at_gaps(with_positive_weights(curve));
  const Room room = around.empty() ? room_around(finite_points(curve.points()), length) : room_around(around, length);
  std::vector<Chain> chains = chains_of(curve, room);
  if (is_cut_by_seam(curve, chains)) chains = chains_of(opened(curve, chains.front().ends.back()), room);
  std::vector<NurbsCurve> arcs;
  for (Chain& chain : chains) arcs.push_back(curve_of(std::move(chain), curve));
  return arcs;
}

}  // namespace splinecore
