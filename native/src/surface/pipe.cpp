#include "splinecore/surface/pipe.hpp"

#include <glm/geometric.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/build/sweeps.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

NurbsCurve unit_circle() {
  return made_periodic(circle(glm::dvec3(0.0), 1.0, glm::dvec3(0.0, 0.0, 1.0))).value;
}

/// The end of the axis at a rim, and the way out there.
struct AxisEnd {
  glm::dvec3 point;
  glm::dvec3 out;
};

AxisEnd axis_end(const NurbsCurve& axis, bool is_start) {
  const double at = is_start ? axis.domain().start : axis.domain().end;
  const Side side = is_start ? Side::right : Side::left;
  AxisEnd end;
  evaluate(axis, std::span(&at, 1), std::span(&end.point.x, 3), {.side = side});
  MovingFrame frame;
  frenet_frames(axis, std::span(&at, 1), std::span(&frame, 1), side);
  end.out = is_start ? -frame.tangent : frame.tangent;
  return end;
}

/// From the rim to the middle.
NurbsPatch flat_cap(const NurbsCurve& rim, const AxisEnd& end) {
  std::vector<glm::dvec4> middle;
  for (const glm::dvec4& p : rim.points()) middle.emplace_back(end.point, p.w);
  return ruled(rim, rim.with_points(std::move(middle)));
}

/// A quarter circle from each point of the rim to the tip.
NurbsPatch round_cap(const NurbsCurve& rim, const AxisEnd& end, double radius) {
  const double half = std::sqrt(0.5);
  const glm::dvec3 rise = radius * end.out;
  std::vector<glm::dvec4> net;
  for (const glm::dvec4& p : rim.points()) {
    net.push_back(p);
    net.emplace_back(glm::dvec3(p) + rise, half * p.w);
    net.emplace_back(end.point + rise, p.w);
  }
  return NurbsPatch::make(rim.knot_vector(), KnotVector::bezier(2), std::move(net));
}

NurbsPatch cap_of(const NurbsPatch& mantle, const NurbsCurve& axis, bool is_start, PipeCaps caps) {
  const NurbsCurve rim = boundary(mantle, is_start ? Border::v_start : Border::v_end);
  const AxisEnd end = axis_end(axis, is_start);
  const double start = rim.domain().start;
  glm::dvec3 on_rim;
  evaluate(rim, std::span(&start, 1), std::span(&on_rim.x, 3));
  const double radius = length_of(on_rim - end.point);
  const NurbsPatch cap = caps == PipeCaps::flat ? flat_cap(rim, end) : round_cap(rim, end, radius);
  return is_start ? reversed(cap, Axis::u) : cap;
}

}  // namespace

Approximation<std::vector<NurbsPatch>> pipe(const NurbsCurve& axis, std::span<const RailNumber> radii, PipeCaps caps,
                                            std::optional<double> tolerance, std::optional<NurbsCurve> scale) {
  if (radii.empty()) throw InvalidShape("there is no radius");
  for (const RailNumber& radius : radii) {
    if (!(radius.value > 0.0 && std::isfinite(radius.value))) {
      throw InvalidShape("a radius of " + text_of(radius.value) + ": above 0 is expected");
    }
  }
  const RailSection section{unit_circle(), axis.domain().start};
  SweepOptions options;
  options.scales.assign(radii.begin(), radii.end());
  options.tolerance = tolerance;
  options.scale = std::move(scale);
  Approximation<NurbsPatch> mantle = sweep(axis, std::span(&section, 1), options);
  std::vector<NurbsPatch> made{mantle.value};
  const bool has_ends = !axis.periodic() && !is_closed(axis);
  for (const bool is_start : {true, false}) {
    if (has_ends && caps != PipeCaps::none) made.push_back(cap_of(mantle.value, axis, is_start, caps));
  }
  return {std::move(made), mantle.error};
}

}  // namespace splinecore
