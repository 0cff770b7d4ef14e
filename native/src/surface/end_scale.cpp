#include "end_scale.hpp"

#include <cmath>
#include <cstddef>

namespace splinecore {

EndScale EndScale::of(const NurbsCurve& curve) {
  const auto points = curve.points();
  return {1.0 / points.front().w, 1.0 / points.back().w};
}

bool EndScale::is_level() const { return std::abs(end - start) <= 0x1p-50 * std::abs(start); }

std::array<double, 2> scaled_weight_slopes(const NurbsCurve& curve) {
  const EndScale scale = EndScale::of(curve);
  const auto knots = curve.knot_vector().knots();
  const auto degree = static_cast<std::size_t>(curve.degree());
  const auto points = curve.points();
  const std::size_t last = points.size() - 1;
  const double change = scale.is_level() ? 0.0 : scale.end - scale.start;
  const double start = static_cast<double>(degree) / (knots[degree + 1] - knots[1]);
  const double end = static_cast<double>(degree) / (knots[knots.size() - 2] - knots[knots.size() - degree - 2]);
  return {scale.start * start * (points[1].w - points[0].w) + change * points[0].w,
          scale.at(1.0) * end * (points[last].w - points[last - 1].w) + change * points[last].w};
}

}  // namespace splinecore
