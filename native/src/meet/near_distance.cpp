#include "near_distance.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/length.hpp"
#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

constexpr double kFar = 0x1p60;

}  // namespace

NearOrigin::NearOrigin(const glm::dvec3& point, const NearSpace& space, std::string name)
    : point_(point), space_(space), near_(space.enter(point, kFar)), name_(std::move(name)) {
  require_finite({&point.x, 3}, name_);
}

double NearOrigin::distance_to(const glm::dvec3& near) const {
  const double distance =
      near_.moved ? distance_of(point_, leave(near)) : space_.length(glm::length(near - near_.at));
  if (std::isfinite(distance)) return distance;
  throw InvalidShape(name_ + " is too far away: its distance is too large for a number");
}

double limit_of(double least, std::optional<double> tolerance, std::span<const glm::dvec4> points) noexcept {
  constexpr double kRoundings = 0x1p-48;
  return least + tolerance.value_or(kRoundings * largest_coordinate(points) + kRoundings * least);
}

}  // namespace splinecore
