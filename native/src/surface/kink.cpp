#include "kink.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/length.hpp"
#include "fitted_together.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

double kink_angle(const NurbsCurve& curve, double u) {
  const Interval domain = curve.domain();
  const double before = curve.periodic() && u == domain.start ? domain.end : u;
  const double behind = curve.periodic() && u == domain.end ? domain.start : u;
  glm::dvec3 left[2];
  glm::dvec3 right[2];
  derivatives(curve, {&before, 1}, 1, {&left[0].x, 6}, {.side = Side::left});
  derivatives(curve, {&behind, 1}, 1, {&right[0].x, 6}, {.side = Side::right});
  return std::atan2(length_of(glm::cross(left[1], right[1])), glm::dot(left[1], right[1]));
}

std::vector<double> corners_above(const NurbsCurve& curve, double angle) {
  std::vector<double> corners = corners_of({&curve, 1});
  std::erase_if(corners, [&](double u) { return kink_angle(curve, u) <= angle; });
  return corners;
}

}  // namespace splinecore
