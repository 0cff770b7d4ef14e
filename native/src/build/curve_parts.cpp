#include "curve_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/nearest.hpp"

namespace splinecore {

NurbsCurve part_of(const NurbsCurve& curve, const Interval& range) {
  NurbsCurve part = curve;
  if (range.end < part.domain().end) part = split(part, range.end).first;
  if (range.start > part.domain().start) part = split(part, range.start).second;
  return part;
}

std::vector<glm::dvec3> samples_of(const NurbsCurve& curve) {
  constexpr int kLooks = 8;
  std::vector<double> at;
  for (std::size_t i = 0; i < curve.knot_vector().spans().size(); ++i) {
    const Interval span = curve.knot_vector().span_interval(static_cast<int>(i));
    for (int k = 0; k <= kLooks; ++k) at.push_back(std::lerp(span.start, span.end, static_cast<double>(k) / kLooks));
  }
  std::vector<glm::dvec3> points(at.size());
  evaluate(curve, at, std::span(&points[0].x, 3 * points.size()));
  return points;
}

bool is_covered(const NurbsCurve& curve, std::span<const NurbsCurve> others, double tolerance) {
  const std::vector<glm::dvec3> samples = samples_of(curve);
  std::vector<double> least(samples.size(), std::numeric_limits<double>::infinity());
  std::vector<NearestOnCurve> found(samples.size());
  for (const NurbsCurve& other : others) {
    nearest(other, samples, found, 1);
    for (std::size_t i = 0; i < samples.size(); ++i) least[i] = std::min(least[i], found[i].distance);
  }
  return std::ranges::max(least) <= tolerance;
}

}  // namespace splinecore
