#include "splinecore/measure/moments.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "base/placement.hpp"
#include "closed_set.hpp"
#include "finite_weights.hpp"
#include "moment_integral.hpp"
#include "placed_patches.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

void require_reached(const FoundMoments& found, double allowed, const char* what) {
  if (found.excess > 1.0) throw ToleranceNotReached(what, allowed, allowed * found.excess);
}

glm::dvec3 first_of(const MomentSums& sums) { return {sums.values[1], sums.values[2], sums.values[3]}; }

/// @throws InvalidShape if the volume is no more than what it may be off by.
void require_volume(const MomentSums& sums) {
  if (std::abs(sums.values[0]) > sums.error(0) + 4.0 * sums.rounding(0)) return;
  throw InvalidShape("the patches enclose no volume: they have no centroid");
}

/// In the place. @param placement  whose origin is the middle of the box
Approximation<glm::dvec3> placed_centroid(const PatchSet& set, const Placement& placement, double tolerance) {
  constexpr const char* kWhat = "the centroid cannot be found";
  const double radius = radius_of(set.points(), placement);
  const auto targets = [&](const MomentSums& sums) {
    MomentValues allowed;
    allowed.fill(kAny);
    allowed[0] = 0.25 * tolerance * std::abs(sums.values[0]);
    for (int i = 1; i < 4; ++i) allowed[i] = radius * allowed[0];
    return allowed;
  };
  const FoundMoments found = moments_of(placed_patches(patches_of(set), placement), targets, kWhat);
  require_volume(found.sums);
  require_reached(found, given_size(tolerance * radius, 1, placement), kWhat);
  const glm::dvec3 middle = first_of(found.sums) / found.sums.values[0];
  glm::dvec3 wrong;
  for (int i = 0; i < 3; ++i) {
    const auto error = [&](int k) { return found.sums.error(k) + found.sums.rounding(k); };
    wrong[i] = (error(1 + i) + std::abs(middle[i]) * error(0)) / std::abs(found.sums.values[0]);
  }
  return {middle, glm::length(wrong)};
}

void require_measurable(const PatchSet& set, double tolerance) {
  require_relative(tolerance);
  require_closed(set);
  for (const NurbsPatch* patch : patches_of(set)) require_finite_points(*patch);
}

/// Second moments, by rows, from six of them.
SecondMoments matrix_of(const MomentValues& m) {
  return {glm::dvec3{m[4], m[5], m[6]}, glm::dvec3{m[5], m[7], m[8]}, glm::dvec3{m[6], m[8], m[9]}};
}

}  // namespace

Approximation<glm::dvec3> centroid(const PatchSet& set, double tolerance) {
  require_measurable(set, tolerance);
  const Placement placement = placement_of(set.points());
  const auto [middle, error] = placed_centroid(set, placement, tolerance);
  return {given_point(middle, placement), given_size(error, 1, placement)};
}

Approximation<SecondMoments> second_moments(const PatchSet& set, std::optional<glm::dvec3> about, double tolerance) {
  constexpr const char* kWhat = "the second moments cannot be found";
  require_measurable(set, tolerance);
  if (about && !(std::isfinite(about->x) && std::isfinite(about->y) && std::isfinite(about->z))) {
    throw InvalidShape("about is not finite");
  }
  Placement placement = placement_of(set.points());
  placement.origin = given_point(placed_centroid(set, placement, tolerance).value, placement);
  const auto trace = [](const MomentSums& sums) { return std::abs(sums.values[4] + sums.values[7] + sums.values[9]); };
  const auto targets = [&](const MomentSums& sums) {
    MomentValues allowed;
    allowed.fill(kAny);
    for (std::size_t i = 4; i < kMoments; ++i) allowed[i] = tolerance * trace(sums);
    return allowed;
  };
  const FoundMoments found = moments_of(placed_patches(patches_of(set), placement), targets, kWhat);
  require_reached(found, given_size(tolerance * trace(found.sums), 5, placement), kWhat);
  const double volume = found.sums.values[0];
  const glm::dvec3 middle = first_of(found.sums) / volume;
  glm::dvec3 way(0.0);
  for (int i = 0; about && i < 3; ++i) {
    way[i] = std::ldexp(placement.origin[i] - (*about)[i], -placement.exponent) + middle[i];
  }
  SecondMoments moments = matrix_of(found.sums.values);
  double error = 0.0;
  for (std::size_t i = 4; i < kMoments; ++i) error = std::max(error, found.sums.error(i) + found.sums.rounding(i));
  error += glm::dot(way, way) * (found.sums.error(0) + found.sums.rounding(0));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double moved = moments[i][j] + volume * (way[i] * way[j] - middle[i] * middle[j]);
      moments[i][j] = finite_size(moved, 5, placement, "second moment");
    }
  }
  return {moments, given_size(error, 5, placement)};
}

}  // namespace splinecore
