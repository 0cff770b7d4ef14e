#include "splinecore/curve/distance.hpp"

#include <algorithm>

#include "basis/refinement.hpp"
#include "bezier_piece.hpp"
#include "common_origin.hpp"
#include "difference.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/degree.hpp"

namespace splinecore {

namespace {

/// The curve with all inner knots of the other.
NurbsCurve with_knots_of(const NurbsCurve& curve, const KnotVector& other) {
  const std::vector<double> missing = missing_inside(curve.knot_vector(), other);
  return missing.empty() ? curve : refine(curve, missing);
}

/// Where the curves differ, span by span.
std::vector<DifferencePiece> pieces_of(NurbsCurve a, NurbsCurve b) {
  if (a.degree() < b.degree()) a = elevated(a, b.degree() - a.degree());
  if (b.degree() < a.degree()) b = elevated(b, a.degree() - b.degree());
  a = with_knots_of(a, b.knot_vector());
  b = with_knots_of(b, a.knot_vector());
  // Matrices of spans are built once for a knot vector and its copies.
  if (a.knot_vector() == b.knot_vector()) {
    b = NurbsCurve::make(a.knot_vector(), {b.points().begin(), b.points().end()});
  }
  std::vector<DifferencePiece> pieces;
  for (int i = 0; i < static_cast<int>(a.knot_vector().spans().size()); ++i) {
    BernsteinNet<glm::dvec4> on_a = bezier_piece(a, i);
    BernsteinNet<glm::dvec4> on_b = bezier_piece(b, i);
    if (on_a != on_b) pieces.push_back(difference(std::move(on_a), std::move(on_b)));
  }
  return pieces;
}

}  // namespace

double largest_distance(const NurbsCurve& a, const NurbsCurve& b) {
  if (a.domain() != b.domain()) throw InvalidShape("the domains differ");
  constexpr double kSlack = 1.01;
  const auto plain = [](const NurbsCurve& curve) { return curve.periodic() ? unrolled(curve) : curve; };
  const glm::dvec3 origin = common_origin(a.points(), b.points());
  const auto near = [&](const NurbsCurve& curve) { return plain(curve.with_points(from_origin(curve.points(), origin))); };
  return largest_length(pieces_of(near(a), near(b)), kSlack);
}

}  // namespace splinecore
