#include "axis_samples.hpp"

namespace splinecore {

AxisSamples sample_axis(const KnotVector& knots, const std::vector<MeshSpan>& spans, int resolution) {
  std::vector<double> parameters;
  std::vector<Side> sides;
  AxisSamples axis;
  const auto add = [&](double u, Side side) {
    parameters.push_back(u);
    sides.push_back(side);
    return static_cast<int>(parameters.size()) - 1;
  };
  const auto add_line = [&](double u, Side side) {
    axis.first.push_back(add(u, side));
    axis.last.push_back(axis.first.back());
  };
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Interval& range = spans[i].range;
    if (i > 0 && spans[i].is_crease) add_line(spans[i - 1].range.end, Side::left);
    if (i > 0 && spans[i].is_crease && !spans[i].is_gap) {
      axis.last.back() = add(range.start, Side::right);
    } else {
      add_line(range.start, Side::right);
    }
    axis.span_starts.push_back(axis.line_count() - 1);
    for (int k = 1; k < resolution; ++k) {
      add_line(range.start + range.length() * (static_cast<double>(k) / resolution), Side::right);
    }
  }
  add_line(knots.domain().end, Side::left);
  axis.samples = Samples::make(knots, parameters, 1, sides);
  return axis;
}

}  // namespace splinecore
