#pragma once

#include "base/placement.hpp"
#include "curve/rescale.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A curve in its place, with weights and parameters brought near 1: they change no direction and no curvature, and
/// their powers would leave the range of numbers.
struct NearCurve {
  NurbsCurve curve;
  Placement placement;
  int parameters;  ///< were divided by this power of two
};

inline NearCurve near_origin(const NurbsCurve& curve, const Placement& placement) {
  const Scales scales = scales_of(curve);
  const NurbsCurve there = placed(curve, placement);
  if (scales.weights == 0 && scales.parameters == 0) return {there, placement, 0};
  return {divided(there, {.coordinates = 0, .weights = scales.weights, .parameters = scales.parameters}), placement,
          scales.parameters};
}

inline NearCurve near_origin(const NurbsCurve& curve) { return near_origin(curve, placement_of(curve.points())); }

}  // namespace splinecore
#pragma GCC visibility pop
