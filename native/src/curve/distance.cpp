#include "splinecore/curve/distance.hpp"

#include <algorithm>

#include "splinecore/base/errors.hpp"
#include "splinecore/basis/difference.hpp"
#include "splinecore/curve/degree.hpp"

namespace splinecore {

namespace {

/// The distinct knots of both curves in the domain, each as often as a curve of this degree lacks it.
NurbsCurve chopped(const NurbsCurve& curve, const NurbsCurve& other) {
  const auto own = curve.knot_vector().knots();
  const Interval domain = curve.domain();
  std::vector<double> knots;
  std::ranges::merge(own, other.knot_vector().knots(), std::back_inserter(knots));
  knots.erase(std::ranges::unique(knots).begin(), knots.end());
  std::vector<double> missing;
  for (const double u : knots) {
    if (u < domain.start || u > domain.end) continue;
    const auto copies = static_cast<long>(std::ranges::equal_range(own, u).size());
    missing.insert(missing.end(), curve.degree() + 1 - copies, u);
  }
  return missing.empty() ? curve : refine(curve, missing);
}

/// Where the curves differ, span by span.
std::vector<DifferencePiece> pieces_of(NurbsCurve a, NurbsCurve b) {
  if (a.degree() < b.degree()) a = elevated(a, b.degree() - a.degree());
  if (b.degree() < a.degree()) b = elevated(b, a.degree() - b.degree());
  const NurbsCurve pieces_a = chopped(a, b);
  const NurbsCurve pieces_b = chopped(b, a);
  const std::size_t count = a.degree() + 1;
  std::vector<DifferencePiece> pieces;
  for (std::size_t i = 0; i < pieces_a.knot_vector().spans().size(); ++i) {
    const auto take = [&](const NurbsCurve& curve) {
      const auto begin = curve.homogeneous_points().begin() + (curve.knot_vector().spans()[i] - curve.degree());
      return Net<glm::dvec4>{count, 1, {begin, begin + static_cast<long>(count)}};
    };
    Net<glm::dvec4> on_a = take(pieces_a);
    Net<glm::dvec4> on_b = take(pieces_b);
    if (on_a.values != on_b.values) pieces.push_back(difference(std::move(on_a), std::move(on_b)));
  }
  return pieces;
}

}  // namespace

double largest_distance(const NurbsCurve& a, const NurbsCurve& b) {
  if (a.domain() != b.domain()) throw InvalidShape("the domains differ");
  constexpr double kSlack = 1.01;
  const auto plain = [](const NurbsCurve& curve) { return curve.periodic() ? unrolled(curve) : curve; };
  return largest_length(pieces_of(plain(a), plain(b)), kSlack);
}

}  // namespace splinecore
