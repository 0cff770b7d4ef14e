#include "splinecore/measure/bounding_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "base/placement.hpp"
#include "curve/bezier_piece.hpp"
#include "finite_weights.hpp"
#include "patch/bezier_piece.hpp"
#include "quadrature.hpp"
#include "reach.hpp"
#include "splinecore/base/approximation.hpp"

namespace splinecore {

namespace {

using Ranges = std::array<Interval, 3>;

/// Boxes of points that are not far from 0 are told to the digit.
constexpr double kFar = 0x1p10;

std::vector<glm::dvec2> coordinates(std::span<const glm::dvec4> points, int axis) {
  std::vector<glm::dvec2> found;
  found.reserve(points.size());
  for (const glm::dvec4& p : points) found.emplace_back(p[axis], p.w);
  return found;
}

Box box_of(const Ranges& ranges, const Placement& placement) {
  Box box{};
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = placement.origin[axis] + std::scalbn(ranges[axis].start, placement.exponent);
    box.high[axis] = placement.origin[axis] + std::scalbn(ranges[axis].end, placement.exponent);
  }
  return box;
}

/// The other way round, so that what is lowest is highest.
Interval turned(const Interval& range) { return {-range.end, -range.start}; }

/// All pieces of a patch, one axis at a time.
class Pieces {
 public:
  Pieces(const NurbsPatch& patch, double tolerance)
      : placement_(exact_placement(patch.points(), kFar)), patch_(placed(patch, placement_)) {
    slack_ = std::max(tolerance * std::scalbn(largest_coordinate(patch.points()), -placement_.exponent), 0x1p-49);
  }

  Box box() {
    for (int axis = 0; axis < 3; ++axis) {
      Interval& range = ranges_[axis];
      for_each(axis, [&](const BernsteinNet<glm::dvec2>& net) {
        for (const glm::dvec2& corner : net.corners()) take(range, corner.x / corner.y);
      });
      for_each(axis, [&](BernsteinNet<glm::dvec2> net) { widen(range, std::move(net)); });
    }
    return box_of(ranges_, placement_);
  }

 private:
  template <class Visit>
  void for_each(int axis, Visit visit) const {
    const auto spans_u = static_cast<int>(patch_.knot_vector(Axis::u).spans().size());
    const auto spans_v = static_cast<int>(patch_.knot_vector(Axis::v).spans().size());
    for (int i = 0; i < spans_u; ++i) {
      for (int j = 0; j < spans_v; ++j) {
        const BernsteinNet<glm::dvec4> piece = bezier_piece(patch_, i, j);
        visit(BernsteinNet<glm::dvec2>{piece.rows, piece.columns, coordinates(piece.values, axis)});
      }
    }
  }

  void widen(Interval& range, BernsteinNet<glm::dvec2> net) const {
    double missing = take_upper(range, net, slack_);
    for (glm::dvec2& p : net.values) p.x = -p.x;
    Interval low = turned(range);
    missing = std::max(missing, take_upper(low, std::move(net), slack_));
    range = turned(low);
    if (missing <= slack_) return;
    throw ToleranceNotReached("the box cannot be found", std::scalbn(slack_, placement_.exponent),
                              std::scalbn(missing, placement_.exponent));
  }

  Placement placement_;
  NurbsPatch patch_;
  double slack_;
  Ranges ranges_{kNothing, kNothing, kNothing};
};

}  // namespace

Box bounding_box(const NurbsCurve& curve) {
  require_finite_points(curve, curve.domain());
  const Placement placement = exact_placement(curve.points(), kFar);
  const NurbsCurve there = placed(curve, placement);
  const auto spans = static_cast<int>(curve.knot_vector().spans().size());
  Ranges ranges{kNothing, kNothing, kNothing};
  std::vector<glm::dvec4> piece(curve.degree() + 1);
  const glm::dvec4* const points = there.homogeneous_points().data();
  for (int i = 0; i < spans; ++i) {
    write_bezier_piece(curve.knot_vector(), i, points, piece.data());
    for (const glm::dvec4& end : {piece.front(), piece.back()}) {
      for (int axis = 0; axis < 3; ++axis) take(ranges[axis], end[axis] / end.w);
    }
  }
  for (int i = 0; i < spans; ++i) {
    write_bezier_piece(curve.knot_vector(), i, points, piece.data());
    for (int axis = 0; axis < 3; ++axis) take_line(ranges[axis], coordinates(piece, axis));
  }
  return box_of(ranges, placement);
}

Box bounding_box(const NurbsPatch& patch, double tolerance) {
  require_relative(tolerance);
  require_finite_points(patch);
  return Pieces(patch, tolerance).box();
}

Box bounding_box(const PatchSet& set, double tolerance) {
  Box box = bounding_box(nurbs_of(set.patch(0)), tolerance);
  for (std::size_t i = 1; i < set.patches().size(); ++i) {
    const Box more = bounding_box(nurbs_of(set.patch(i)), tolerance);
    box.low = glm::min(box.low, more.low);
    box.high = glm::max(box.high, more.high);
  }
  return box;
}

}  // namespace splinecore
