#include "splinecore/patch/distance.hpp"

#include <algorithm>

#include "basis/refinement.hpp"
#include "bezier_piece.hpp"
#include "curve/common_origin.hpp"
#include "curve/difference.hpp"
#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

/// The patch with all inner knots of another along an axis.
NurbsPatch with_knots_of(const NurbsPatch& patch, const KnotVector& other, Axis axis) {
  const std::vector<double> missing = missing_inside(patch.knot_vector(axis), other);
  return missing.empty() ? patch : refine(patch, axis, missing);
}

NurbsPatch plain(const NurbsPatch& patch, Axis axis) {
  return patch.knot_vector(axis).periodic() ? clamped(patch, axis) : patch;
}

/// Brings both patches to one degree and one set of spans along an axis.
void make_alike(NurbsPatch& a, NurbsPatch& b, Axis axis) {
  a = plain(a, axis);
  b = plain(b, axis);
  const int more = a.knot_vector(axis).degree() - b.knot_vector(axis).degree();
  if (more < 0) a = elevated(a, axis, -more);
  if (more > 0) b = elevated(b, axis, more);
  a = with_knots_of(a, b.knot_vector(axis), axis);
  b = with_knots_of(b, a.knot_vector(axis), axis);
  // Matrices of spans are built once for a knot vector and its copies.
  if (a.knot_vector(axis) == b.knot_vector(axis)) {
    b = with_axis(b, axis, a.knot_vector(axis), {b.points().begin(), b.points().end()});
  }
}

/// Where two patches differ, piece by piece; pieces that are equal bit for bit are left out.
std::vector<DifferencePiece> difference_pieces(NurbsPatch a, NurbsPatch b) {
  make_alike(a, b, Axis::u);
  make_alike(a, b, Axis::v);
  std::vector<DifferencePiece> pieces;
  for (int i = 0; i < static_cast<int>(a.knot_vector(Axis::u).spans().size()); ++i) {
    for (int j = 0; j < static_cast<int>(a.knot_vector(Axis::v).spans().size()); ++j) {
      BernsteinNet<glm::dvec4> on_a = bezier_piece(a, i, j);
      BernsteinNet<glm::dvec4> on_b = bezier_piece(b, i, j);
      if (on_a != on_b) pieces.push_back(difference(std::move(on_a), std::move(on_b)));
    }
  }
  return pieces;
}

}  // namespace

double largest_distance(const NurbsPatch& a, const NurbsPatch& b) {
  for (const Axis axis : {Axis::u, Axis::v}) {
    if (a.knot_vector(axis).domain() != b.knot_vector(axis).domain()) throw InvalidShape("the domains differ");
  }
  constexpr double kSlack = 1.02;
  const glm::dvec3 origin = common_origin(a.points(), b.points());
  const auto near = [&](const NurbsPatch& patch) { return patch.with_points(from_origin(patch.points(), origin)); };
  return largest_length(difference_pieces(near(a), near(b)), kSlack);
}

}  // namespace splinecore
