#include "splinecore/tessellate/polyline.hpp"

#include <algorithm>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// The ends of the piece and the steps of every span inside it.
std::vector<double> parameters_of(const KnotVector& knots, Interval piece, int resolution) {
  std::vector<double> parameters{piece.start};
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (int k = 0; k < resolution; ++k) {
      const double u = span.start + span.length() * (static_cast<double>(k) / resolution);
      if (u > piece.start && u < piece.end) parameters.push_back(u);
    }
  }
  parameters.push_back(piece.end);
  return parameters;
}

/// Whether a piece ends in a finite point. Ends inside the domain are poles or gaps.
bool is_finite_at(const NurbsCurve& curve, double u, Side side) {
  const Interval range = curve.domain();
  const bool inside = u > range.start && u < range.end;
  if (inside && multiplicity(curve.knot_vector(), u) <= curve.degree()) return false;
  glm::dvec4 h;
  evaluate_homogeneous(curve, {&u, 1}, {&h, 1}, side);
  return h.w != 0.0;
}

/// The samples of one piece, without an end that lies at infinity.
std::vector<double> piece_points(const NurbsCurve& curve, Interval piece, int resolution) {
  std::vector<double> parameters = parameters_of(curve.knot_vector(), piece, resolution);
  if (!is_finite_at(curve, piece.start, Side::right)) parameters.erase(parameters.begin());
  parameters.pop_back();
  const std::size_t inner = 3 * parameters.size();
  const bool has_end = is_finite_at(curve, piece.end, Side::left);
  std::vector<double> points(inner + (has_end ? 3 : 0));
  evaluate(curve, parameters, std::span(points).first(inner));
  if (has_end) evaluate(curve, {&piece.end, 1}, std::span(points).last(3), {.side = Side::left});
  return points;
}

/// Whether a curve in one piece returns to where it began.
bool is_closed(const NurbsCurve& curve, const std::vector<double>& points) {
  const double start = curve.domain().start;
  if (curve.periodic()) return multiplicity(curve.knot_vector(), start) <= curve.degree();
  return points.size() > 6 && std::equal(points.begin(), points.begin() + 3, points.end() - 3);
}

}  // namespace

std::vector<Polyline> polylines(const NurbsCurve& curve, int resolution) {
  constexpr int kMaxResolution = 4096;
  if (resolution < 1 || resolution > kMaxResolution) {
    throw InvalidShape("resolution = " + std::to_string(resolution) + " is outside [1, " +
                       std::to_string(kMaxResolution) + "]");
  }
  const std::vector<Interval> all = pieces(curve);
  std::vector<Polyline> lines;
  for (const Interval& piece : all) {
    Polyline line{piece_points(curve, piece, resolution), false};
    if (all.size() == 1 && is_closed(curve, line.points)) {
      line.closed = true;
      line.points.resize(line.points.size() - 3);
    }
    if (line.points.size() > 3) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace splinecore
