#include "splinecore/patch/distance.hpp"

#include <algorithm>

#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/difference.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

/// The patch with every knot of either patch along an axis as often as it falls apart there.
NurbsPatch chopped(const NurbsPatch& patch, const NurbsPatch& other, Axis axis) {
  const KnotVector& own = patch.knot_vector(axis);
  std::vector<double> knots;
  std::ranges::merge(own.knots(), other.knot_vector(axis).knots(), std::back_inserter(knots));
  knots.erase(std::ranges::unique(knots).begin(), knots.end());
  std::vector<double> missing;
  for (const double u : knots) missing.insert(missing.end(), missing_for_cut(own, u), u);
  return missing.empty() ? patch : refine(patch, axis, missing);
}

/// Brings both patches to one degree and one set of spans along an axis.
void make_alike(NurbsPatch& a, NurbsPatch& b, Axis axis) {
  a = clamped(a, axis);
  b = clamped(b, axis);
  const int more = a.knot_vector(axis).degree() - b.knot_vector(axis).degree();
  if (more < 0) a = elevated(a, axis, -more);
  if (more > 0) b = elevated(b, axis, more);
  NurbsPatch pieces = chopped(a, b, axis);
  b = chopped(b, a, axis);
  a = std::move(pieces);
}

/// The homogeneous points of one piece of a patch that is chopped in both directions.
Net<glm::dvec4> net_of(const NurbsPatch& patch, int span_u, int span_v) {
  const KnotVector& u = patch.knot_vector(Axis::u);
  const KnotVector& v = patch.knot_vector(Axis::v);
  Net<glm::dvec4> net{static_cast<std::size_t>(u.degree()) + 1, static_cast<std::size_t>(v.degree()) + 1, {}};
  for (int i = u.spans()[span_u] - u.degree(); i <= u.spans()[span_u]; ++i) {
    for (int j = v.spans()[span_v] - v.degree(); j <= v.spans()[span_v]; ++j) {
      net.values.push_back(patch.homogeneous_points()[i * v.count() + j]);
    }
  }
  return net;
}

/// Where two patches differ, piece by piece; pieces that are equal bit for bit are left out.
std::vector<DifferencePiece> difference_pieces(NurbsPatch a, NurbsPatch b) {
  make_alike(a, b, Axis::u);
  make_alike(a, b, Axis::v);
  std::vector<DifferencePiece> pieces;
  for (int i = 0; i < static_cast<int>(a.knot_vector(Axis::u).spans().size()); ++i) {
    for (int j = 0; j < static_cast<int>(a.knot_vector(Axis::v).spans().size()); ++j) {
      Net<glm::dvec4> on_a = net_of(a, i, j);
      Net<glm::dvec4> on_b = net_of(b, i, j);
      if (on_a.values != on_b.values) pieces.push_back(difference(std::move(on_a), std::move(on_b)));
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
  return largest_length(difference_pieces(a, b), kSlack);
}

}  // namespace splinecore
