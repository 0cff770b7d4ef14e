#include "piece_box.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "base/one_sign.hpp"
#include "base/quotient.hpp"

namespace splinecore {

namespace {

using Net = BernsteinNet<glm::dvec4>;

/// Three directions at right angles, the first along a piece, the last across it.
std::array<glm::dvec3, 3> axes_of(const Net& net) {
  constexpr double kParallel = 0x1p-20;
  const PieceBox plain;
  const auto [a, b, c, d] = net.corners();
  glm::dvec3 along = project(c) - project(a) + (project(d) - project(b));
  glm::dvec3 other = net.columns > 1 ? project(b) - project(a) + (project(d) - project(c))
                                     : project(net.values[net.values.size() / 2]) - project(a);
  if (glm::length(along) < glm::length(other)) std::swap(along, other);
  const double size = glm::length(along);
  if (!(size > 0.0) || !std::isfinite(size)) return plain.axes;
  along /= size;
  glm::dvec3 across = glm::cross(along, other);
  if (!(glm::length(across) > kParallel * glm::length(other))) {
    const glm::dvec3 steps = glm::abs(along);
    const int least = steps.x <= steps.y && steps.x <= steps.z ? 0 : steps.y <= steps.z ? 1 : 2;
    across = glm::cross(along, plain.axes[least]);
  }
  across = glm::normalize(across);
  return {along, glm::cross(across, along), across};
}

}  // namespace

PieceBox piece_box(const Net& net) {
  PieceBox box;
  box.axes = axes_of(net);
  const glm::dvec3 origin = project(net.values.front());
  glm::dvec3 low(0.0);
  glm::dvec3 high(0.0);
  for (const glm::dvec4& h : net.values) {
    const glm::dvec3 offset = project(h) - origin;
    const glm::dvec3 along(glm::dot(box.axes[0], offset), glm::dot(box.axes[1], offset), glm::dot(box.axes[2], offset));
    low = glm::min(low, along);
    high = glm::max(high, along);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  box.half = 0.5 * (high - low);
  box.center = origin + middle.x * box.axes[0] + middle.y * box.axes[1] + middle.z * box.axes[2];
  return box;
}

TreeBox box_of(const Net& net) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  if (!has_one_sign(net.values, &glm::dvec4::w)) return {high, low};
  for (const glm::dvec4& h : net.values) {
    low = glm::min(low, project(h));
    high = glm::max(high, project(h));
  }
  return {low, high};
}

}  // namespace splinecore
