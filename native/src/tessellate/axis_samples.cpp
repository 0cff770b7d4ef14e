#include "splinecore/tessellate/axis_samples.hpp"

namespace splinecore {

AxisSamples sample_axis(const KnotVector& knots, int resolution) {
  std::vector<double> parameters;
  std::vector<Side> sides;
  AxisSamples axis;
  const auto add_line = [&](double u, Side side) {
    axis.first.push_back(static_cast<int>(parameters.size()));
    axis.last.push_back(static_cast<int>(parameters.size()));
    parameters.push_back(u);
    sides.push_back(side);
  };
  const int span_count = static_cast<int>(knots.spans().size());
  for (int i = 0; i < span_count; ++i) {
    const Interval span = knots.span_interval(i);
    const int times = multiplicity(knots, span.start);
    const bool is_inner_crease = i > 0 && times >= knots.degree();
    if (is_inner_crease) add_line(span.start, Side::left);
    if (is_inner_crease && times == knots.degree()) {
      axis.last.back() = static_cast<int>(parameters.size());
      parameters.push_back(span.start);
      sides.push_back(Side::right);
    } else {
      add_line(span.start, Side::right);
    }
    axis.span_starts.push_back(axis.line_count() - 1);
    for (int k = 1; k < resolution; ++k) {
      add_line(span.start + span.length() * (static_cast<double>(k) / resolution), Side::right);
    }
  }
  add_line(knots.domain().end, Side::left);
  axis.samples = Samples::make(knots, parameters, 1, sides);
  return axis;
}

}  // namespace splinecore
