#include "splinecore/conic/implicit_conic.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/require.hpp"
#include "numbers.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr double kNoise = 64.0 * kEpsilon;

struct ConicCoefficients {
  double a, b, c, d, e, f;
};

glm::dvec2 across(const glm::dvec2& v) { return {-v.y, v.x}; }

/// Of the two unit vectors along an axis the one to the right, or up.
glm::dvec2 oriented(const glm::dvec2& v) { return v.x < 0.0 || (v.x == 0.0 && v.y < 0.0) ? -v : v; }

/// The quadratic part in its own axes: `large` is the eigenvalue of the greater size. `determinant`
/// is 0 where the two eigenvalues' product is, up to rounding.
struct Spectrum {
  double large;
  double small;
  double determinant;
  glm::dvec2 axis;  // of the large eigenvalue
  bool is_round;
};

Spectrum spectrum_of(const ConicCoefficients& k) {
  const double difference = k.a - k.c;
  const double sum = k.a + k.c;
  const double root = std::hypot(difference, k.b);
  const double large = 0.5 * (sum + std::copysign(root, sum));
  double determinant = difference_of_products(k.a, k.c, 0.5 * k.b, 0.5 * k.b);
  if (std::abs(determinant) < kNoise * (std::abs(k.a * k.c) + 0.25 * k.b * k.b)) determinant = 0.0;
  // Half the angle of (difference, b), without cancellation on either side.
  const double longer = std::sqrt(0.5 * (1.0 + std::abs(difference) / root));
  const double shorter = 0.5 * k.b / (root * longer);
  const glm::dvec2 steep(std::abs(shorter), std::copysign(longer, k.b));
  glm::dvec2 axis(1.0, 0.0);
  if (root > 0.0) axis = difference >= 0.0 ? glm::dvec2(longer, shorter) : steep;
  if (std::signbit(sum)) axis = across(axis);
  return {large, determinant / large, determinant, axis, root <= kNoise * std::abs(sum)};
}

ConicShape straight(const ConicCoefficients& k) {
  const double square = k.d * k.d + k.e * k.e;
  if (square == 0.0) return {.type = ConicType::empty};
  const glm::dvec2 normal(k.d, k.e);
  return {.type = ConicType::line, .center = -k.f / square * normal, .axis = oriented(across(glm::normalize(normal)))};
}

ConicShape elliptic(const Spectrum& s, const glm::dvec2& center, double value) {
  if (value == 0.0) return {.type = ConicType::point, .center = center};
  if ((value > 0.0) == (s.large > 0.0)) return {.type = ConicType::empty};
  if (s.is_round) {
    const double radius = std::sqrt(-value / (0.5 * (s.large + s.small)));
    return {ConicType::circle, center, {1.0, 0.0}, radius, radius};
  }
  const double major = std::sqrt(-value / s.small);
  return {ConicType::ellipse, center, oriented(across(s.axis)), major, std::sqrt(-value / s.large)};
}

ConicShape hyperbolic(const Spectrum& s, const glm::dvec2& center, double value) {
  const double large = std::sqrt(std::abs(s.large));
  const double small = std::sqrt(std::abs(s.small));
  if (value == 0.0) {
    const double length = std::hypot(large, small);
    return {ConicType::crossing_lines, center, oriented(s.axis), small / length, large / length};
  }
  const double half = std::sqrt(std::abs(value));
  const bool is_along = (value > 0.0) != (s.large > 0.0);
  if (is_along) return {ConicType::hyperbola, center, oriented(s.axis), half / large, half / small};
  return {ConicType::hyperbola, center, oriented(across(s.axis)), half / small, half / large};
}

ConicShape central(const ConicCoefficients& k, const Spectrum& s) {
  const double x = 0.25 * difference_of_products(k.b, k.e, 2.0 * k.c, k.d) / s.determinant;
  const double y = 0.25 * difference_of_products(k.b, k.d, 2.0 * k.a, k.e) / s.determinant;
  const double from_x = 0.5 * k.d * x;
  const double from_y = 0.5 * k.e * y;
  double value = k.f + from_x + from_y;
  if (std::abs(value) < kNoise * (std::abs(k.f) + std::abs(from_x) + std::abs(from_y))) value = 0.0;
  return s.determinant > 0.0 ? elliptic(s, {x, y}, value) : hyperbolic(s, {x, y}, value);
}

/// large p² + along p + f = 0, where p runs in the direction of the axis.
ConicShape parallel(const Spectrum& s, double along, double f) {
  double root = difference_of_products(along, along, 4.0 * s.large, f);
  if (std::abs(root) < kNoise * (along * along + std::abs(4.0 * s.large * f))) root = 0.0;
  if (root < 0.0) return {.type = ConicType::empty};
  return {root == 0.0 ? ConicType::line : ConicType::parallel_lines, -0.5 * along / s.large * s.axis,
          oriented(across(s.axis)), 0.0, 0.5 * std::sqrt(root) / std::abs(s.large)};
}

ConicShape parabolic(const ConicCoefficients& k, const Spectrum& s) {
  const glm::dvec2 opening = across(s.axis);
  const double along = k.d * s.axis.x + k.e * s.axis.y;
  const double across_it = k.d * opening.x + k.e * opening.y;
  if (std::abs(across_it) <= kNoise * std::hypot(k.d, k.e)) return parallel(s, along, k.f);
  const double p = -0.5 * along / s.large;
  const double q = -(k.f + 0.5 * along * p) / across_it;
  const double focal = -0.25 * across_it / s.large;
  return {ConicType::parabola, p * s.axis + q * opening, focal > 0.0 ? opening : -opening, std::abs(focal), 0.0};
}

/// Divided by the power of two of the largest quadratic coefficient: no digit changes.
ConicCoefficients scaled(const std::array<double, 6>& k) {
  const auto largest = [&](int first, int last) {
    double size = 0.0;
    for (int i = first; i < last; ++i) size = std::max(size, std::abs(k[i]));
    return size;
  };
  const double size = largest(0, 3) > 0.0 ? largest(0, 3) : largest(3, 6);
  const int exponent = -std::ilogb(size);
  const auto at = [&](int i) { return std::scalbn(k[i], exponent); };
  return {at(0), at(1), at(2), at(3), at(4), at(5)};
}

ConicShape shape_of(const ConicCoefficients& k) {
  if (k.a == 0.0 && k.b == 0.0 && k.c == 0.0) return straight(k);
  const Spectrum s = spectrum_of(k);
  return s.determinant == 0.0 ? parabolic(k, s) : central(k, s);
}

}  // namespace

ImplicitConic ImplicitConic::make(const std::array<double, 6>& coefficients, const Plane& plane) {
  require_finite(coefficients, "coefficients");
  if (std::ranges::all_of(coefficients, [](double k) { return k == 0.0; })) {
    throw InvalidShape("coefficients are all zero: every point of the plane would lie on the conic");
  }
  const ConicShape shape = shape_of(scaled(coefficients));
  for (const double number : {shape.center.x, shape.center.y, shape.axis.x, shape.axis.y, shape.first, shape.second}) {
    if (!std::isfinite(number)) throw InvalidShape("coefficients describe a conic beyond the range of numbers");
  }
  return {coefficients, plane_along(plane.origin, plane.x_axis, plane.y_axis), shape};
}

std::optional<glm::dvec3> center(const ImplicitConic& conic) {
  if (conic.type() == ConicType::empty) return std::nullopt;
  return conic.plane().point(conic.shape().center);
}

std::array<glm::dvec3, 2> axis_directions(const ImplicitConic& conic) {
  const glm::dvec2 axis = conic.shape().axis;
  return {conic.plane().direction(axis), conic.plane().direction(across(axis))};
}

std::vector<glm::dvec3> foci(const ImplicitConic& conic) {
  const ConicShape& s = conic.shape();
  const auto at = [&](double distance) { return conic.plane().point(s.center + distance * s.axis); };
  switch (s.type) {
    case ConicType::circle: return {at(0.0)};
    case ConicType::parabola: return {at(s.first)};
    case ConicType::ellipse: {
      const double distance = std::sqrt((s.first - s.second) * (s.first + s.second));
      return {at(-distance), at(distance)};
    }
    case ConicType::hyperbola: return {at(-std::hypot(s.first, s.second)), at(std::hypot(s.first, s.second))};
    default: return {};
  }
}

std::optional<double> eccentricity(const ImplicitConic& conic) {
  const ConicShape& s = conic.shape();
  switch (s.type) {
    case ConicType::circle: return 0.0;
    case ConicType::parabola: return 1.0;
    case ConicType::ellipse: return std::sqrt((s.first - s.second) * (s.first + s.second)) / s.first;
    case ConicType::hyperbola: return std::hypot(s.first, s.second) / s.first;
    default: return std::nullopt;
  }
}

}  // namespace splinecore
