#include "least_squares.hpp"

#include <algorithm>
#include <cmath>

namespace splinecore {

namespace {

using Points = std::vector<glm::dvec4>;

/// Scalar products by coordinate: the four are problems of their own, and one may be far smaller.
glm::dvec4 products(const Points& a, const Points& b) {
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add(Points& sum, const glm::dvec4& factor, const Points& points) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * points[i];
}

/// 0 where a coordinate is done.
glm::dvec4 quotient(const glm::dvec4& a, const glm::dvec4& b) {
  glm::dvec4 result(0.0);
  for (int axis = 0; axis < 4; ++axis) {
    if (b[axis] > 0.0) result[axis] = a[axis] / b[axis];
  }
  return result;
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

/// Powers of two that bring the largest of each coordinate near 1, so that squares stay in range.
glm::dvec4 scale_of(std::span<const glm::dvec4> points) {
  glm::dvec4 scale(1.0);
  for (int axis = 0; axis < 4; ++axis) {
    double largest = 0.0;
    for (const glm::dvec4& p : points) largest = std::max(largest, std::abs(p[axis]));
    if (largest > 0.0) scale[axis] = std::ldexp(1.0, std::min(1000, -std::ilogb(largest)));
  }
  return scale;
}

/// Tells when squared gradients have stopped to fall.
class Patience {
 public:
  explicit Patience(const glm::dvec4& floor) : floor_(floor) {}

  bool has(const glm::dvec4& gradient) {
    double above = 0.0;
    for (int axis = 0; axis < 4; ++axis) {
      if (gradient[axis] > floor_[axis]) above = std::max(above, gradient[axis] / floor_[axis]);
    }
    if (above < 0.5 * best_) {
      best_ = above;
      idle_ = 0;
    }
    return above > 0.0 && ++idle_ <= kMostIdle;
  }

 private:
  static constexpr int kMostIdle = 60;
  glm::dvec4 floor_;
  double best_ = HUGE_VAL;
  int idle_ = 0;
};

/// One run of conjugate gradients.
void improve(const PointMatrix& matrix, const Points& points, std::span<const int> fixed, Points& found) {
  constexpr double kRounding = 0x1p-108;  // of squared lengths
  Points residual = points;
  add(residual, glm::dvec4(-1.0), image(matrix, found));
  Points gradient = descent(matrix, residual, fixed);
  Points direction = gradient;
  glm::dvec4 length = products(gradient, gradient);
  Patience patience(kRounding * products(points, points));
  const std::size_t most = 2 * found.size() + 50;
  for (std::size_t i = 0; i < most && patience.has(length); ++i) {
    const Points step = image(matrix, direction);
    // The exact minimum along the direction: no step goes up, also when rounding has bent the direction.
    const glm::dvec4 factor = quotient(products(residual, step), products(step, step));
    add(found, factor, direction);
    add(residual, -factor, step);
    gradient = descent(matrix, residual, fixed);
    const glm::dvec4 next = products(gradient, gradient);
    const glm::dvec4 share = quotient(next, length);
    for (std::size_t k = 0; k < direction.size(); ++k) direction[k] = gradient[k] + share * direction[k];
    length = next;
  }
}

}  // namespace

Points closest_preimage(const PointMatrix& matrix, std::span<const glm::dvec4> points, Points start,
                        std::span<const int> fixed) {
  constexpr int kRuns = 3;
  const glm::dvec4 scale = scale_of(points);
  Points wanted(points.begin(), points.end());
  for (glm::dvec4& p : wanted) p *= scale;
  for (glm::dvec4& p : start) p *= scale;
  for (int run = 0; run < kRuns; ++run) improve(matrix, wanted, fixed, start);
  for (glm::dvec4& p : start) p /= scale;
  return start;
}

}  // namespace splinecore
