#include "numerators.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {


/// Coefficients that are added up, with the sizes of their terms.
class Sums {
 public:
  explicit Sums(int degree) : values_(degree + 1), sizes_(degree + 1) {}

  void add(std::size_t i, double value, double size) {
    values_[i] += value;
    sizes_[i] += size;
  }

  /// @param factors  how many a term has, which round each
  Numerator found(int factors) && {
    const double largest = *std::ranges::max_element(sizes_);
    if (!std::isfinite(largest)) throw InvalidShape("points and weights differ too much in size");
    return {std::move(values_), kRoundingOfStep * factors * largest};
  }

 private:
  std::vector<double> values_;
  std::vector<double> sizes_;
};

template <class Points>
bool is_plain(const Points& points) {
  return std::ranges::all_of(points, [](const auto& p) { return p[p.length() - 1] == 1.0; });
}

Numerator plain_slope(std::span<const glm::dvec2> line) {
  const int degree = static_cast<int>(line.size()) - 1;
  Sums sums(degree - 1);
  for (int i = 0; i < degree; ++i) {
    sums.add(i, degree * (line[i + 1].x - line[i].x), degree * (std::abs(line[i + 1].x) + std::abs(line[i].x)));
  }
  return std::move(sums).found(2);
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }
double cross_size(const glm::dvec2& a, const glm::dvec2& b) { return std::abs(a.x * b.y) + std::abs(a.y * b.x); }

/// A B' - A' B for the two coordinates of a polynomial: the products of Bernstein polynomials i < j, i after i.
Numerator wronskian(std::span<const glm::dvec2> points) {
  const int degree = static_cast<int>(points.size()) - 1;
  breathe(8 * points.size() * points.size());
  if (degree == 0) return {{0.0}, 0.0};
  Sums sums(2 * degree - 2);
  for (int i = 0; i < degree; ++i) {
    for (int j = i + 1; j <= degree; ++j) {
      const int at = i + j - 1;
      const double share = (j - i) * (binomial(degree, i) * binomial(degree, j) / binomial(2 * degree - 2, at));
      sums.add(at, share * cross(points[i], points[j]), share * cross_size(points[i], points[j]));
    }
  }
  return std::move(sums).found(degree + 3);
}

double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

double determinant_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto of = [](double x, double y, double z) { return std::abs(x * y * z); };
  return of(a.x, b.y, c.z) + of(a.x, b.z, c.y) + of(a.y, b.z, c.x) + of(a.y, b.x, c.z) + of(a.z, b.x, c.y) +
         of(a.z, b.y, c.x);
}

/// det(P, P', P''): the same of three polynomials, i < j < k. Its degree is 3 less than that of their product for each
/// factor but the first two.
Numerator wronskian(std::span<const glm::dvec3> points) {
  const int degree = static_cast<int>(points.size()) - 1;
  if (degree < 2) return {{0.0}, 0.0};
  Sums sums(3 * degree - 6);
  for (int i = 0; i <= degree - 2; ++i) {
    for (int j = i + 1; j <= degree - 1; ++j) {
      breathe(16 * points.size());
      const double pair = (j - i) * (binomial(degree, i) * binomial(degree, j));
      for (int k = j + 1; k <= degree; ++k) {
        const int at = i + j + k - 3;
        const double share = pair / binomial(3 * degree - 6, at) * binomial(degree, k) * (k - i) * (k - j);
        sums.add(at, share * determinant(points[i], points[j], points[k]),
                 share * determinant_size(points[i], points[j], points[k]));
      }
    }
  }
  return std::move(sums).found(degree + 6);
}

}  // namespace

Numerator slope_of(std::span<const glm::dvec2> line) {
  if (is_plain(line)) return plain_slope(line);
  // Of A / W in the other order: W A' - W' A.
  std::vector<glm::dvec2> turned;
  for (const glm::dvec2& p : line) turned.emplace_back(p.y, p.x);
  return wronskian(std::span<const glm::dvec2>(turned));
}

Numerator sweep_of(std::span<const glm::dvec2> points) { return wronskian(points); }

Numerator bend_of(std::span<const glm::dvec3> points) {
  if (!is_plain(points)) return wronskian(points);
  std::vector<glm::dvec2> slopes;
  double rounding = 0.0;
  const int degree = static_cast<int>(points.size()) - 1;
  for (int i = 0; i < degree; ++i) {
    const glm::dvec3 step = points[i + 1] - points[i];
    slopes.emplace_back(degree * step.x, degree * step.y);
    rounding = std::max({rounding, std::abs(points[i].x), std::abs(points[i].y), std::abs(points[i + 1].x),
                         std::abs(points[i + 1].y)});
  }
  Numerator found = wronskian(std::span<const glm::dvec2>(slopes));
  // What the differences lost.
  double largest = 0.0;
  for (const glm::dvec2& slope : slopes) largest = std::max({largest, std::abs(slope.x), std::abs(slope.y)});
  found.noise += 4.0 * kRoundingOfStep * degree * degree * rounding * largest;
  return found;
}

}  // namespace splinecore
