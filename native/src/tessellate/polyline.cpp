#include "splinecore/tessellate/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/one_sign.hpp"
#include "base/sort_by.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/curve/finite_arcs.hpp"

namespace splinecore {

namespace {

/// The ends of the piece, and `resolution` steps in what it holds of every span.
std::vector<double> parameters_of(const KnotVector& knots, Interval piece, int resolution) {
  std::vector<double> parameters;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    const Interval part{std::max(span.start, piece.start), std::min(span.end, piece.end)};
    if (!(part.start < part.end)) continue;
    for (int k = 0; k < resolution; ++k) {
      parameters.push_back(part.start + part.length() * (static_cast<double>(k) / resolution));
    }
  }
  parameters.push_back(piece.end);
  return parameters;
}

/// Whether the end of a piece is a finite point. Ends inside the domain are poles or gaps.
bool is_finite_end(const NurbsCurve& curve, double u) {
  const Interval range = curve.domain();
  const bool inside = u > range.start && u < range.end;
  return !inside || multiplicity(curve.knot_vector(), u) > curve.degree();
}

void append_finite(const NurbsCurve& curve, const std::vector<double>& parameters, Side side,
                   std::vector<double>& points) {
  std::vector<double> all(3 * parameters.size());
  evaluate(curve, parameters, std::span(all), {side, AtInfinity::nan});
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::isnan(all[3 * i]) || is_at_infinity(curve, parameters[i], side)) continue;
    points.insert(points.end(), all.begin() + 3 * i, all.begin() + 3 * i + 3);
  }
}

bool runs_to_infinity(const NurbsCurve& curve, Interval piece) {
  return !is_finite_end(curve, piece.start) || !is_finite_end(curve, piece.end) ||
         is_at_infinity(curve, piece.start, Side::right) || is_at_infinity(curve, piece.end, Side::left);
}

/// The samples of one piece that are finite.
std::vector<double> piece_points(const NurbsCurve& curve, Interval piece, int resolution) {
  // Samples next to infinity are left out, so a piece that runs there needs some more.
  constexpr int kFewest = 4;
  if (runs_to_infinity(curve, piece)) resolution = std::max(resolution, kFewest);
  std::vector<double> parameters = parameters_of(curve.knot_vector(), piece, resolution);
  if (!is_finite_end(curve, piece.start)) parameters.erase(parameters.begin());
  parameters.pop_back();
  std::vector<double> points;
  append_finite(curve, parameters, Side::right, points);
  if (is_finite_end(curve, piece.end)) append_finite(curve, {piece.end}, Side::left, points);
  return points;
}

/// The samples of a piece that is finite everywhere.
std::vector<double> sampled(const NurbsCurve& curve, Interval piece, int resolution) {
  std::vector<double> parameters = parameters_of(curve.knot_vector(), piece, resolution);
  parameters.pop_back();
  std::vector<double> points;
  append_finite(curve, parameters, Side::right, points);
  append_finite(curve, {piece.end}, Side::left, points);
  return points;
}

/// Whether a curve in one piece returns to where it began.
bool is_closed(const NurbsCurve& curve, const std::vector<double>& points) {
  const double start = curve.domain().start;
  if (points.empty() || is_at_infinity(curve, start, Side::right)) return false;
  if (curve.periodic()) return multiplicity(curve.knot_vector(), start) <= curve.degree();
  return points.size() > 6 && std::equal(points.begin(), points.begin() + 3, points.end() - 3);
}

/// Where the arcs within reach lie in the domain; those of a periodic curve may begin in one period and end in the
/// next.
std::vector<Interval> arcs_within(const NurbsCurve& curve, double reach, std::span<const glm::dvec3> around) {
  std::vector<Interval> arcs;
  for (const NurbsCurve& arc : finite_arcs(curve, reach, around)) arcs.push_back(arc.domain());
  if (!curve.periodic()) return arcs;
  const double period = curve.domain().length();
  for (std::size_t i = 0, count = arcs.size(); i < count; ++i) {
    arcs.push_back({arcs[i].start - period, arcs[i].end - period});
  }
  sort_by(arcs, [](const Interval& arc) { return arc.start; });
  return arcs;
}

/// pieces(), as far as the arcs within reach go.
std::vector<Interval> pieces_within(const NurbsCurve& curve, double reach, std::span<const glm::dvec3> around) {
  if (around.empty() && has_one_sign(curve.points(), &glm::dvec4::w)) return pieces(curve);
  const std::vector<Interval> arcs = arcs_within(curve, reach, around);
  std::vector<Interval> within;
  for (const Interval& piece : pieces(curve)) {
    bool is_open = false;
    for (const Interval& arc : arcs) {
      const Interval part{std::max(arc.start, piece.start), std::min(arc.end, piece.end)};
      if (!(part.start < part.end)) continue;
      if (is_open && within.back().end == part.start) {
        within.back().end = part.end;
      } else {
        within.push_back(part);
      }
      is_open = true;
    }
  }
  return within;
}

}  // namespace

std::vector<Polyline> polylines(const NurbsCurve& curve, int resolution, std::optional<double> reach,
                                std::span<const glm::dvec3> around) {
  constexpr int kMaxResolution = 4096;
  constexpr double kMaxSamples = 1 << 22;
  if (resolution < 1 || resolution > kMaxResolution) {
    throw InvalidShape("resolution = " + std::to_string(resolution) + " is outside [1, " +
                       std::to_string(kMaxResolution) + "]");
  }
  if (static_cast<double>(curve.knot_vector().spans().size()) * resolution > kMaxSamples) {
    throw InvalidShape("the polyline would have more than 2^22 points: lower the resolution");
  }
  if (reach && !(*reach > 0.0 && std::isfinite(*reach))) {
    throw InvalidShape("reach = " + text_of(*reach) + " is not a positive length");
  }
  const std::vector<Interval> all = reach ? pieces_within(curve, *reach, around) : pieces(curve);
  std::vector<Polyline> lines;
  for (const Interval& piece : all) {
    Polyline line{reach ? sampled(curve, piece, resolution) : piece_points(curve, piece, resolution), false};
    if (all.size() == 1 && piece == curve.domain() && is_closed(curve, line.points)) {
      line.closed = true;
      line.points.resize(line.points.size() - 3);
    }
    if (line.points.size() > 3) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace splinecore
