#include "fairness.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "base/length.hpp"
#include "basis/gauss_legendre.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

/// Places in every span, by shares of it.
std::vector<double> places_in(const KnotVector& knots, std::span<const double> shares) {
  std::vector<double> found;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (const double share : shares) found.push_back(span.start + share * span.length());
  }
  return found;
}

/// Of a surface, or a place of it: the area, and times that the sum of both curvatures, and of their squares.
struct BendingSums {
  double area = 0.0;
  double curvatures = 0.0;
  double squares = 0.0;
};

BendingSums sums_at(const glm::dvec3* d) {
  const glm::dvec3& u = d[3];
  const glm::dvec3& v = d[1];
  const glm::dvec3 normal = glm::cross(u, v);
  const double area = length_of(normal);
  const double e = glm::dot(u, u);
  const double f = glm::dot(u, v);
  const double g = glm::dot(v, v);
  const double square = area * area;
  if (!(square > 0.0)) return {};
  const double l = glm::dot(d[6], normal) / area;
  const double m = glm::dot(d[4], normal) / area;
  const double n = glm::dot(d[2], normal) / area;
  const double twice_mean = (e * n - 2.0 * f * m + g * l) / square;
  const double gauss = (l * n - m * m) / square;
  return {area, twice_mean * area, (twice_mean * twice_mean - 2.0 * gauss) * area};
}

}  // namespace

SurfaceBending bending_of(std::span<const NurbsPatch> patches) {
  constexpr int kMostPlaces = 128;
  constexpr int kLeastInSpan = 2;
  BendingSums sum;
  for (const NurbsPatch& patch : patches) {
    std::array<std::vector<double>, 2> at;
    std::array<std::vector<double>, 2> weights;
    for (const Axis axis : {Axis::u, Axis::v}) {
      const KnotVector& knots = patch.knot_vector(axis);
      const int spans = static_cast<int>(knots.spans().size());
      const GaussRule rule = gauss_legendre(std::clamp(kMostPlaces / spans, kLeastInSpan, knots.degree() + 1));
      const auto side = static_cast<std::size_t>(axis);
      at[side] = places_in(knots, rule.nodes);
      for (int i = 0; i < spans; ++i) {
        for (const double weight : rule.weights) weights[side].push_back(weight * knots.span_interval(i).length());
      }
    }
    std::vector<glm::dvec3> line(9 * at[1].size());
    for (std::size_t i = 0; i < at[0].size(); ++i) {
      breathe(line.size());
      const std::vector<double> u(at[1].size(), at[0][i]);
      derivatives(patch, u, at[1], 2, std::span(&line.front().x, 3 * line.size()));
      for (std::size_t k = 0; k < at[1].size(); ++k) {
        const double weight = weights[0][i] * weights[1][k];
        const BendingSums here = sums_at(&line[9 * k]);
        sum.area += weight * here.area;
        sum.curvatures += weight * here.curvatures;
        sum.squares += weight * here.squares;
      }
    }
  }
  if (!(sum.area > 0.0)) return {};
  return {sum.squares, sum.squares - 0.5 * sum.curvatures * sum.curvatures / sum.area};
}

}  // namespace splinecore
