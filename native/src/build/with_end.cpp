#include "with_end.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "basis/blossom.hpp"

namespace splinecore {

NurbsCurve with_end(const NurbsCurve& curve, double end) {
  const int degree = curve.degree();
  const auto knots = curve.knot_vector().knots();
  const auto points = curve.homogeneous_points();
  const std::size_t first = points.size() - 1 - static_cast<std::size_t>(degree);
  std::vector<glm::dvec4> moved(points.begin(), points.end());
  std::vector<double> row(static_cast<std::size_t>(degree) + 1);
  const std::vector<double> ends(row.size(), end);
  for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k) {
    blossom_weights(knots.data() + first, degree, std::span(ends).first(k), row.data());
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i <= k; ++i) sum += row[i] * points[first + i];
    moved[first + k] = sum;
  }
  std::vector<double> further(knots.begin(), knots.end());
  std::fill(further.end() - degree - 1, further.end(), end);
  return NurbsCurve::from_homogeneous(KnotVector::make(degree, std::move(further)), moved);
}

}  // namespace splinecore
