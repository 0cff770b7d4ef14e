#include "kink.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/length.hpp"
#include "fitted_together.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/curve_frame.hpp"

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

std::optional<double> hidden_turn(const NurbsCurve& curve, double angle) {
  constexpr double kParted = 0x1p-44;
  const Interval domain = curve.domain();
  const double step = kParted * std::max(std::abs(domain.start), std::abs(domain.end));
  for (const Side side : {Side::left, Side::right}) {
    const bool is_left = side == Side::left;
    std::vector<double> at;
    std::vector<double> beside;
    for (const double knot : curve.knot_vector().knots()) {
      if (knot < domain.start || knot > domain.end || knot == (is_left ? domain.start : domain.end)) continue;
      at.push_back(knot);
      beside.push_back(is_left ? std::max(domain.start, knot - step) : std::min(domain.end, knot + step));
    }
    std::vector<MovingFrame> frames(at.size());
    std::vector<MovingFrame> frames_beside(at.size());
    frenet_frames(curve, at, frames, side);
    frenet_frames(curve, beside, frames_beside, is_left ? Side::right : Side::left);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (length_of(frames[i].tangent - frames_beside[i].tangent) > angle) return at[i];
    }
  }
  return {};
}

}  // namespace splinecore
