#include "finite_weights.hpp"

#include <algorithm>

#include "base/one_sign.hpp"
#include "basis/bernstein_net.hpp"
#include "patch/bezier_piece.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// The weight on a box of parameters.
struct WeightPiece {
  BernsteinNet<double> net;
  Interval u;
  Interval v;
};

/// Both halves along a direction.
std::pair<WeightPiece, WeightPiece> halves_along(WeightPiece piece, Axis axis) {
  WeightPiece second{{}, piece.u, piece.v};
  piece.net.halve(axis, second.net);
  Interval WeightPiece::*side = axis == Axis::u ? &WeightPiece::u : &WeightPiece::v;
  (piece.*side).end = (second.*side).start = (piece.*side).middle();
  return {std::move(piece), std::move(second)};
}

/// Not zero at the corners and nowhere of another sign: then zero nowhere.
bool keeps_sign(const WeightPiece& piece, double sign) {
  for (const double corner : piece.net.corners()) {
    if (!(corner * sign > 0.0)) throw PointAtInfinity(piece.u.middle(), piece.v.middle());
  }
  const auto [low, high] = piece.net.range();
  return sign > 0.0 ? low >= 0.0 : high <= 0.0;
}

void require_sign(const WeightPiece& piece, double sign, int depth) {
  if (keeps_sign(piece, sign)) return;
  if (depth == 0) throw PointAtInfinity(piece.u.middle(), piece.v.middle());
  const auto [low, high] = halves_along(piece, Axis::u);
  for (const WeightPiece* half : {&low, &high}) {
    const auto [before, after] = halves_along(*half, Axis::v);
    require_sign(before, sign, depth - 1);
    require_sign(after, sign, depth - 1);
  }
}

template <class Shape>
bool has_weights_of_one_sign(const Shape& shape) {
  return has_one_sign(shape.homogeneous_points(), &glm::dvec4::w);
}

}  // namespace

void require_finite_points(const NurbsPatch& patch) {
  constexpr int kDepth = 12;
  if (!patch.rational() || has_weights_of_one_sign(patch)) return;
  const KnotVector& knots_u = patch.knot_vector(Axis::u);
  const KnotVector& knots_v = patch.knot_vector(Axis::v);
  for (int i = 0; i < static_cast<int>(knots_u.spans().size()); ++i) {
    for (int j = 0; j < static_cast<int>(knots_v.spans().size()); ++j) {
      const WeightPiece piece{weights_of(bezier_piece(patch, i, j)), knots_u.span_interval(i),
                              knots_v.span_interval(j)};
      require_sign(piece, piece.net.values.front() < 0.0 ? -1.0 : 1.0, kDepth);
    }
  }
}

void require_finite_points(const NurbsCurve& curve, const Interval& range) {
  if (has_weights_of_one_sign(curve)) return;
  for (const Interval& piece : pieces(curve)) {
    const double start = std::max(piece.start, range.start);
    const double end = std::min(piece.end, range.end);
    if (start > end) continue;
    if (start == piece.start && is_at_infinity(curve, start, Side::right)) throw PointAtInfinity(start);
    if (end == piece.end && is_at_infinity(curve, end, Side::left)) throw PointAtInfinity(end);
  }
}

}  // namespace splinecore
