#include "splinecore/patch/transform.hpp"

#include "basis/moebius.hpp"
#include "curve/affine.hpp"
#include "lines.hpp"
#include "splinecore/curve/transform.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

NurbsPatch transformed(const NurbsPatch& patch, const glm::dmat4& matrix) {
  return patch.with_points(transformed(patch.points(), matrix));
}

BezierPatch transformed(const BezierPatch& patch, const glm::dmat4& matrix) {
  return as_bezier(transformed(patch.nurbs(), matrix));
}

HermitePatch transformed(const HermitePatch& patch, const glm::dmat4& matrix) {
  require_affine(matrix, "patch");
  const glm::dmat3 linear(matrix);
  HermiteNet net = patch.net();
  for (glm::dvec3& point : net.points) point = glm::dvec3(matrix * glm::dvec4(point, 1.0));
  for (auto* vectors : {&net.tangents_u, &net.tangents_v, &net.twists}) {
    for (glm::dvec3& vector : *vectors) vector = linear * vector;
  }
  return patch.with_net(std::move(net));
}

PatchSet transformed(const PatchSet& set, const glm::dmat4& matrix) {
  for (const IndexedPatch& patch : set.patches()) {
    if (patch.kind == PatchKind::hermite) require_affine(matrix, "patch");
  }
  return set.with_points(transformed(set.points(), matrix));
}

NurbsPatch moebius(const NurbsPatch& patch, Axis axis, double rho) {
  const bool reaches_pole = has_moebius_pole(patch.knot_vector(axis), rho);
  const bool is_ready = !reaches_pole && !patch.knot_vector(axis).periodic();
  const NurbsPatch plain = is_ready ? patch : clamped(patch, axis);
  MoebiusKnots mapped = moebius(plain.knot_vector(axis), rho);
  const Lines lines = lines_of(plain, axis);
  std::vector<glm::dvec4> points(plain.points().begin(), plain.points().end());
  for (std::size_t line = 0; line < lines.count; ++line) {
    for (std::size_t i = 0; i < lines.size; ++i) {
      const std::size_t at = lines.at(line, i);
      points[at] = multiplied(points[at], mapped.factors[i], at, plain.count(Axis::v));
    }
  }
  const int degree = plain.knot_vector(axis).degree();
  return with_axis(plain, axis, KnotVector::make(degree, std::move(mapped.knots)), std::move(points));
}

}  // namespace splinecore
