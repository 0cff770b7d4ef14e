#include "splinecore/tessellate/axis_samples.hpp"

#include <algorithm>

namespace splinecore {

AxisSamples sample_axis(const KnotVector& knots, int resolution) {
  std::vector<double> parameters;
  std::vector<Side> sides;
  AxisSamples axis;
  const auto add = [&](double u, Side side, bool new_line, bool face_follows) {
    if (new_line) ++axis.line_count;
    parameters.push_back(u);
    sides.push_back(side);
    axis.line.push_back(axis.line_count - 1);
    axis.face_follows.push_back(face_follows);
  };
  const int span_count = static_cast<int>(knots.spans().size());
  // A closed direction of fewer than three strips would fold onto itself.
  if (knots.periodic()) resolution = std::max(resolution, (2 + span_count) / span_count);
  for (int i = 0; i < span_count; ++i) {
    const Interval span = knots.span_interval(i);
    const int times = multiplicity(knots, span.start);
    const bool from_both_sides = i > 0 && times >= knots.degree();
    if (from_both_sides) add(span.start, Side::left, true, false);
    add(span.start, Side::right, !from_both_sides || times > knots.degree(), true);
    for (int k = 1; k < resolution; ++k) {
      add(span.start + span.length() * (static_cast<double>(k) / resolution), Side::right, true, true);
    }
  }
  const Interval range = knots.domain();
  const bool closes = knots.periodic() && multiplicity(knots, range.start) <= knots.degree();
  add(range.end, Side::left, !closes, false);
  if (closes) axis.line.back() = 0;
  axis.samples = Samples::make(knots, parameters, 1, sides);
  return axis;
}

}  // namespace splinecore
