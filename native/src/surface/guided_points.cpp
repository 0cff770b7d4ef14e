#include "guided_points.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "greville.hpp"
#include "grid_controls.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "star_rows.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec3> in_space(const std::vector<glm::dvec2>& places) {
  std::vector<glm::dvec3> found;
  for (const glm::dvec2& p : places) found.emplace_back(p, 0.0);
  return found;
}

/// The star over the guide's plane.
std::vector<NurbsPatch> flat_patches(const Hole& hole, const Star& star, const HoleGuide& guide) {
  const auto values = [&](std::size_t i, std::span<const double> s, int order) {
    return in_space(order == 0 ? guide.border(hole.sides[i], s) : guide.across(hole, i, s, order));
  };
  const std::vector<int> orders(hole.sides.size(), hole.continuity());
  return patches_of(star, solved_star(star, claimed_points(hole, star, values, orders)));
}

bool is_folded_in_plane(const NurbsPatch& patch) {
  constexpr int kPlaces = 17;
  std::vector<double> at;
  for (int k = 0; k < kPlaces; ++k) at.push_back((k + 0.5) / kPlaces);
  std::vector<glm::dvec3> points(at.size() * at.size());
  std::vector<glm::dvec3> normals(points.size());
  const std::size_t count = 3 * points.size();
  evaluate_grid_with_normals(patch, at, at, std::span(&points.front().x, count), std::span(&normals.front().x, count));
  return !std::ranges::all_of(normals, [](const glm::dvec3& normal) { return normal.z > 0.0; });
}

}  // namespace

std::vector<glm::dvec3> guided_points(const Hole& hole, const Star& star, const HoleGuide& guide) {
  const std::vector<NurbsPatch> flat = flat_patches(hole, star, guide);
  if (std::ranges::any_of(flat, is_folded_in_plane)) return {};
  std::vector<glm::dvec3> found(star.size(), glm::dvec3(0.0));
  for (std::size_t k = 0; k < star.count(); ++k) {
    const std::vector<double> u = greville_places(star.along(k, Axis::u));
    const std::vector<double> v = greville_places(star.along(k, Axis::v));
    std::vector<glm::dvec3> grid(u.size() * v.size());
    evaluate_grid(flat[k], u, v, std::span(&grid.front().x, 3 * grid.size()));
    std::array<std::vector<double>, 3> values;
    for (const glm::dvec3& p : grid) {
      const glm::dvec3 value = guide.at({p.x, p.y});
      for (int c = 0; c < 3; ++c) values[c].push_back(value[c]);
    }
    for (int c = 0; c < 3; ++c) {
      const std::vector<double> controls = grid_controls(star.along(k, Axis::u), star.along(k, Axis::v), values[c]);
      for (std::size_t i = 0; i < u.size(); ++i) {
        for (std::size_t j = 0; j < v.size(); ++j) found[star.at(k, i, j)][c] = controls[i * v.size() + j];
      }
    }
  }
  return found;
}

std::optional<SurfaceBending> guided_bending(const Hole& hole, const HoleGuide& guide) {
  constexpr int kDegree = 7;
  const KnotVector knots = KnotVector::bezier(kDegree);
  const Star star{std::vector(hole.sides.size(), KnotPair{knots, knots}), false, hole.continuity() + 1};
  const std::vector<glm::dvec3> points = guided_points(hole, star, guide);
  if (points.empty()) return {};
  return bending_of(patches_of(star, points));
}

}  // namespace splinecore
