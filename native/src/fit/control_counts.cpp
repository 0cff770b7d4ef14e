#include "control_counts.hpp"

#include <algorithm>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

std::size_t least_count(int degree, bool is_periodic) {
  if (degree < 1 || degree > kMaxDegree) {
    throw InvalidShape("degree = " + std::to_string(degree) + " is outside [1, " + std::to_string(kMaxDegree) + "]");
  }
  return static_cast<std::size_t>(is_periodic ? std::max(degree, 3) : degree + 1);
}

void require_count(std::size_t count, int degree, bool is_periodic) {
  const std::size_t least = least_count(degree, is_periodic);
  if (count >= least) return;
  throw InvalidShape("count = " + std::to_string(count) + " control points are fewer than the " +
                     std::to_string(least) + " that degree " + std::to_string(degree) + " needs");
}

void require_room_for_ends(std::size_t count, std::size_t held) {
  if (count >= held) return;
  throw InvalidShape(std::to_string(count) + " control points are fewer than the " + std::to_string(held) +
                     " that the ends and their derivatives need");
}

void require_enough_points(std::size_t points, int degree, bool is_periodic) {
  const std::size_t least = least_count(degree, is_periodic);
  if (points >= least) return;
  throw InvalidShape(std::to_string(points) + " points are too few for degree " + std::to_string(degree) +
                     ", which needs at least " + std::to_string(least));
}

}  // namespace splinecore
