#include "expected_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <vector>

#include "base/length.hpp"
#include "bicubic_sum.hpp"
#include "greville.hpp"
#include "grid_controls.hpp"
#include "hole_plane.hpp"
#include "numeric/linear_equations.hpp"
#include "ribbon.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kDegreeOfFit = 4;
constexpr int kTermsOfFit = (kDegreeOfFit + 1) * (kDegreeOfFit + 2) / 2;
using Terms = std::array<double, kTermsOfFit>;

/// The products of powers of x and y, or their derivatives along a direction.
Terms terms_at(const glm::dvec3& p) {
  Terms terms;
  int next = 0;
  for (int sum = 0; sum <= kDegreeOfFit; ++sum) {
    for (int k = 0; k <= sum; ++k) terms[next++] = std::pow(p.x, sum - k) * std::pow(p.y, k);
  }
  return terms;
}

Terms terms_along(const glm::dvec3& p, const glm::dvec3& way) {
  Terms terms;
  int next = 0;
  for (int sum = 0; sum <= kDegreeOfFit; ++sum) {
    for (int k = 0; k <= sum; ++k) {
      const int i = sum - k;
      const double by_x = i > 0 ? i * std::pow(p.x, i - 1) * std::pow(p.y, k) : 0.0;
      const double by_y = k > 0 ? k * std::pow(p.x, i) * std::pow(p.y, k - 1) : 0.0;
      terms[next++] = way.x * by_x + way.y * by_y;
    }
  }
  return terms;
}

/// The polynomial's factors; none where a neighbor stands too steeply over the plane.
std::optional<std::vector<double>> heights_of(const std::vector<std::vector<HolePlace>>& sides, const HolePlane& plane) {
  constexpr double kSteep = 0.15;
  constexpr double kDependent = 1e-4;
  LinearEquations equations(kTermsOfFit);
  for (const auto& side : sides) {
    for (const HolePlace& place : side) {
      const glm::dvec3 p = plane.at(place.point);
      equations.add(terms_at(p), p.z);
      if (place.out == glm::dvec3(0.0)) continue;
      const double length = length_of(place.out);
      const glm::dvec3 way = plane.size / length * plane.along(place.out);
      if (std::hypot(way.x, way.y) < kSteep) return {};
      equations.add(terms_along(p, way), way.z);
    }
  }
  return equations.least_squares(kDependent);
}

double height_at(const glm::dvec3& p, const std::vector<double>& factors) {
  const Terms terms = terms_at(p);
  return std::inner_product(terms.begin(), terms.end(), factors.begin(), 0.0);
}

std::vector<glm::dvec3> heights_over_plane(const std::vector<std::vector<HolePlace>>& sides, const Star& star,
                                           std::span<const NurbsPatch> patches) {
  const std::optional<HolePlane> plane = plane_of(sides);
  if (!plane) return {};
  const auto heights = heights_of(sides, *plane);
  if (!heights) return {};
  std::vector<glm::dvec3> found(star.size(), glm::dvec3(0.0));
  for (std::size_t k = 0; k < star.count(); ++k) {
    const std::vector<double> u = greville_places(star.along(k, Axis::u));
    const std::vector<double> v = greville_places(star.along(k, Axis::v));
    std::vector<glm::dvec3> grid(u.size() * v.size());
    evaluate_grid(patches[k], u, v, std::span(&grid.front().x, 3 * grid.size()));
    std::vector<double> values;
    for (const glm::dvec3& p : grid) values.push_back(height_at(plane->at(p), *heights));
    const std::vector<double> controls = grid_controls(star.along(k, Axis::u), star.along(k, Axis::v), values);
    for (std::size_t i = 0; i < u.size(); ++i) {
      for (std::size_t j = 0; j < v.size(); ++j) {
        found[star.at(k, i, j)] = plane->size * controls[i * v.size() + j] * plane->normal;
      }
    }
  }
  return found;
}

/// A border, and if a neighbor says how the patch leaves it, the derivative by the other parameter.
LeftBorder left_border(const NurbsPatch& patch, Border border, bool has_neighbor) {
  LeftBorder made{boundary(patch, border), {}};
  if (!has_neighbor) return made;
  std::vector<glm::dvec4> vectors;
  for (const glm::dvec4& out : derivative_out(ribbon_of(patch, border), 1)) {
    vectors.emplace_back(is_at_end(border) ? glm::dvec3(out) : -glm::dvec3(out), 1.0);
  }
  made.across = made.curve.with_points(std::move(vectors));
  return made;
}

/// Sides of the hole are v_start, u_end, v_end, u_start.
std::vector<glm::dvec3> bicubic_points(const Hole& hole, const Star& star, const NurbsPatch& patch) {
  const auto border = [&](std::size_t side, Border name) {
    return left_border(patch, name, hole.sides[side].continuity() > 0);
  };
  const BicubicSum sum = bicubic_sum({border(0, Border::v_start), border(2, Border::v_end)},
                                     {border(3, Border::u_start), border(1, Border::u_end)});
  if (sum.patch.points().size() != star.size()) return {};
  std::vector<glm::dvec3> found;
  for (const glm::dvec4& p : sum.patch.points()) found.emplace_back(p);
  return found;
}

}  // namespace

std::vector<glm::dvec3> expected_points(const Hole& hole, const Star& star, std::span<const NurbsPatch> patches) {
  const auto has_neighbor = [](const HoleSide& side) { return side.continuity() > 0; };
  if (std::ranges::none_of(hole.sides, has_neighbor)) return {};
  if (star.count() == 1) return bicubic_points(hole, star, patches[0]);
  std::vector<std::vector<HolePlace>> sides;
  for (const HoleSide& side : hole.sides) sides.push_back(places_along(side));
  return heights_over_plane(sides, star, patches);
}

}  // namespace splinecore
