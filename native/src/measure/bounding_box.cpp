#include "splinecore/measure/bounding_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "curve/bezier_piece.hpp"
#include "finite_weights.hpp"
#include "patch/bezier_piece.hpp"
#include "quadrature.hpp"
#include "reach.hpp"
#include "splinecore/base/approximation.hpp"

namespace splinecore {

namespace {

using Ranges = std::array<Interval, 3>;

/// A power of two near the largest coordinate: products of a few numbers stay in range then, to the digit.
int exponent_of(std::span<const glm::dvec4> points) {
  const double largest = largest_coordinate(points);
  return largest > 0.0 ? std::ilogb(largest) : 0;
}

std::vector<glm::dvec2> coordinates(std::span<const glm::dvec4> points, int axis, int exponent) {
  std::vector<glm::dvec2> found;
  found.reserve(points.size());
  for (const glm::dvec4& p : points) found.emplace_back(std::scalbn(p[axis], -exponent), p.w);
  return found;
}

Box box_of(const Ranges& ranges, int exponent) {
  Box box{};
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::scalbn(ranges[axis].start, exponent);
    box.high[axis] = std::scalbn(ranges[axis].end, exponent);
  }
  return box;
}

/// The other way round, so that what is lowest is highest.
Interval turned(const Interval& range) { return {-range.end, -range.start}; }

/// All pieces of a patch, one axis at a time.
class Pieces {
 public:
  Pieces(const NurbsPatch& patch, double tolerance) : patch_(patch), exponent_(exponent_of(patch.points())) {
    slack_ = std::max(tolerance * std::scalbn(largest_coordinate(patch.points()), -exponent_), 0x1p-49);
  }

  Box box() {
    for (int axis = 0; axis < 3; ++axis) {
      Interval& range = ranges_[axis];
      for_each(axis, [&](const BernsteinNet<glm::dvec2>& net) {
        for (const glm::dvec2& corner : net.corners()) take(range, corner.x / corner.y);
      });
      for_each(axis, [&](BernsteinNet<glm::dvec2> net) { widen(range, std::move(net)); });
    }
    return box_of(ranges_, exponent_);
  }

 private:
  template <class Visit>
  void for_each(int axis, Visit visit) const {
    const auto spans_u = static_cast<int>(patch_.knot_vector(Axis::u).spans().size());
    const auto spans_v = static_cast<int>(patch_.knot_vector(Axis::v).spans().size());
    for (int i = 0; i < spans_u; ++i) {
      for (int j = 0; j < spans_v; ++j) {
        const BernsteinNet<glm::dvec4> piece = bezier_piece(patch_, i, j);
        visit(BernsteinNet<glm::dvec2>{piece.rows, piece.columns, coordinates(piece.values, axis, exponent_)});
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
    throw ToleranceNotReached("the box cannot be found", std::scalbn(slack_, exponent_),
                              std::scalbn(missing, exponent_));
  }

  const NurbsPatch& patch_;
  int exponent_;
  double slack_;
  Ranges ranges_{kNothing, kNothing, kNothing};
};

}  // namespace

Box bounding_box(const NurbsCurve& curve) {
  require_finite_points(curve, curve.domain());
  const int exponent = exponent_of(curve.points());
  const auto spans = static_cast<int>(curve.knot_vector().spans().size());
  Ranges ranges{kNothing, kNothing, kNothing};
  std::vector<glm::dvec4> piece(curve.degree() + 1);
  const glm::dvec4* const points = curve.homogeneous_points().data();
  for (int i = 0; i < spans; ++i) {
    write_bezier_piece(curve.knot_vector(), i, points, piece.data());
    for (const glm::dvec4& end : {piece.front(), piece.back()}) {
      for (int axis = 0; axis < 3; ++axis) take(ranges[axis], std::scalbn(end[axis], -exponent) / end.w);
    }
  }
  for (int i = 0; i < spans; ++i) {
    write_bezier_piece(curve.knot_vector(), i, points, piece.data());
    for (int axis = 0; axis < 3; ++axis) take_line(ranges[axis], coordinates(piece, axis, exponent));
  }
  return box_of(ranges, exponent);
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
