#include "splinecore/convert/to_bezier.hpp"

#include <algorithm>

#include "base/given_points.hpp"
#include "basis/point_matrix.hpp"
#include "curve/bezier_piece.hpp"
#include "patch/bezier_piece.hpp"

namespace splinecore {

namespace {

/// Puts the given points, whose every digit counts, where a Bezier point is one of them.
void keep_points(std::span<const glm::dvec4> given, const SquareRows& matrix, int first, int count,
                 std::vector<glm::dvec4>& points) {
  for (std::size_t j = 0; j < points.size(); ++j) {
    const int copied = copied_point(matrix[j]);
    if (copied >= 0) points[j] = given[(first + copied) % count];
  }
}

/// The control points of the tensor piece that starts at spans u and v, row after row.
std::vector<glm::dvec4> bezier_net(const NurbsPatch& patch, int span_u, int span_v) {
  const KnotVector& knots_u = patch.knot_vector(Axis::u);
  const KnotVector& knots_v = patch.knot_vector(Axis::v);
  const std::size_t rows = knots_u.degree() + 1;
  const std::size_t columns = knots_v.degree() + 1;
  const auto matrix_u = knots_u.bezier_matrix(span_u);
  const auto matrix_v = knots_v.bezier_matrix(span_v);
  GivenPoints given = as_given_from(patch, bezier_piece(patch, span_u, span_v).values);
  for (std::size_t i = 0; i < rows; ++i) {
    const int row = copied_point(matrix_u[i]);
    if (row < 0) continue;
    for (std::size_t j = 0; j < columns; ++j) {
      const int column = copied_point(matrix_v[j]);
      if (column < 0) continue;
      const int u = (knots_u.spans()[span_u] - knots_u.degree() + row) % knots_u.count();
      const int v = (knots_v.spans()[span_v] - knots_v.degree() + column) % knots_v.count();
      given.made[i * columns + j] = given.old[u * knots_v.count() + v];
    }
  }
  return std::move(given.made);
}

}  // namespace

std::vector<BezierCurve> to_bezier(const NurbsCurve& curve) {
  const KnotVector& knots = curve.knot_vector();
  std::vector<BezierCurve> beziers;
  for (int span = 0; span < static_cast<int>(knots.spans().size()); ++span) {
    GivenPoints given = as_given_from(curve, bezier_piece(curve, span).values);
    const int first = knots.spans()[span] - knots.degree();
    keep_points(given.old, knots.bezier_matrix(span), first, knots.count(), given.made);
    beziers.push_back(BezierCurve::make(std::move(given.made)));
  }
  return beziers;
}

BezierGrid to_bezier(const NurbsPatch& patch) {
  const KnotVector& knots_u = patch.knot_vector(Axis::u);
  const KnotVector& knots_v = patch.knot_vector(Axis::v);
  BezierGrid grid{static_cast<int>(knots_u.spans().size()), static_cast<int>(knots_v.spans().size()), {}};
  for (int i = 0; i < grid.count_u; ++i) {
    for (int j = 0; j < grid.count_v; ++j) {
      grid.patches.push_back(BezierPatch::make(knots_u.degree() + 1, knots_v.degree() + 1,
                                               bezier_net(patch, i, j)));
    }
  }
  return grid;
}

}  // namespace splinecore
