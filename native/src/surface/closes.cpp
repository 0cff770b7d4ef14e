#include "closes.hpp"

#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/length.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

bool closes(const NurbsCurve& curve) {
  if (curve.periodic()) return true;
  constexpr double kRounding = 0x1p-47;
  const NurbsCurve whole = clamped(curve);
  const glm::dvec4& first = whole.points().front();
  const glm::dvec4& last = whole.points().back();
  return first.w != 0.0 && last.w != 0.0 && std::abs(first.w - last.w) <= kRounding * std::abs(first.w) &&
         distance_of(glm::dvec3(first), glm::dvec3(last)) <= kRounding * largest_coordinate(curve.points());
}

}  // namespace splinecore
