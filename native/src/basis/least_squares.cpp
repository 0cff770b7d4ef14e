#include "splinecore/basis/least_squares.hpp"

#include <glm/geometric.hpp>

namespace splinecore {

namespace {

using Points = std::vector<glm::dvec4>;

double squared(const Points& points) {
  double sum = 0.0;
  for (const glm::dvec4& p : points) sum += glm::dot(p, p);
  return sum;
}

void add(Points& sum, double factor, const Points& points) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * points[i];
}

Points image(const PointMatrix& matrix, const Points& points) {
  Points out(matrix.knots().count());
  matrix.apply(points.data(), 1, out.data(), 1);
  return out;
}

/// The gradient of half the squared residual, downhill.
Points descent(const PointMatrix& matrix, const Points& residual, std::span<const int> fixed) {
  Points gradient = matrix.apply_transposed(residual);
  for (const int i : fixed) gradient[i] = glm::dvec4(0.0);
  return gradient;
}

/// One run of conjugate gradients. Below the rounding of the points a gradient is noise, along which steps grow
/// without end.
void improve(const PointMatrix& matrix, std::span<const glm::dvec4> points, std::span<const int> fixed, Points& found) {
  constexpr double kRounding = 1e-30;  // of the squared points
  Points residual(points.begin(), points.end());
  add(residual, -1.0, image(matrix, found));
  Points gradient = descent(matrix, residual, fixed);
  Points direction = gradient;
  const double least = kRounding * squared({points.begin(), points.end()});
  double length = squared(gradient);
  const std::size_t most = 2 * found.size() + 50;
  for (std::size_t i = 0; i < most && length > least; ++i) {
    const Points step = image(matrix, direction);
    const double size = squared(step);
    if (size == 0.0) return;
    const double factor = length / size;
    add(found, factor, direction);
    add(residual, -factor, step);
    gradient = descent(matrix, residual, fixed);
    const double next = squared(gradient);
    for (std::size_t k = 0; k < direction.size(); ++k) direction[k] = gradient[k] + (next / length) * direction[k];
    length = next;
  }
}

}  // namespace

Points closest_preimage(const PointMatrix& matrix, std::span<const glm::dvec4> points, Points start,
                        std::span<const int> fixed) {
  constexpr int kRuns = 3;
  for (int run = 0; run < kRuns; ++run) improve(matrix, points, fixed, start);
  return start;
}

}  // namespace splinecore
