#include "splinecore/build/corners.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/printable.hpp"
#include "curve_ends.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/fillet.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/continuity.hpp"

namespace splinecore {

namespace {

/// A tangent that turns by less goes on.
constexpr double kSmooth = 1e-6;

/// Where a run of a curve ends, what goes from there to the next one, and where that starts.
struct CornerCut {
  double before;
  NurbsCurve bridge;
  double behind;
};

/// The runs of a curve between its corners.
struct SmoothRuns {
  std::vector<NurbsCurve> runs;
  bool is_round;  ///< whether there is a corner between the last and the first one, too
};

SmoothRuns runs_of(const NurbsCurve& curve) {
  std::vector<double> corners;
  for (const Joint& joint : joints(curve, kSmooth)) {
    if (joint.continuity.g == 0) corners.push_back(joint.u);
  }
  const bool goes_round = is_closed(curve) && !corners.empty();
  // The seam is a joint, at the start or the end; where it is no corner the first run goes over it.
  return {goes_round || !corners.empty() ? parts(curve, corners) : std::vector{curve}, goes_round};
}

/// The curve with a cut at each of its corners.
template <class CutAt>
NurbsCurve with_corners_cut(const NurbsCurve& curve, CutAt cut_at) {
  const auto [runs, is_round] = runs_of(curve);
  const std::size_t corners = is_round ? runs.size() : runs.size() - 1;
  if (corners == 0) return curve;
  std::vector<CornerCut> cuts;
  if (corners == 1 && is_round) {
    const Interval domain = runs[0].domain();
    cuts.push_back(cut_at(part(runs[0], domain.middle(), domain.end), part(runs[0], domain.start, domain.middle())));
  } else {
    for (std::size_t i = 0; i < corners; ++i) cuts.push_back(cut_at(runs[i], runs[(i + 1) % runs.size()]));
  }
  std::vector<NurbsCurve> made;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Interval domain = runs[i].domain();
    const double start = i > 0 ? cuts[i - 1].behind : is_round ? cuts.back().behind : domain.start;
    const double end = i < corners ? cuts[i].before : domain.end;
    if (end - start < -kNothing * domain.length()) {
      throw InvalidShape("what replaces the corners at both ends of the run to " + place_text(end_of(runs[i]).point) +
                         " does not fit on it");
    }
    if (end - start > kNothing * domain.length()) made.push_back(part(runs[i], start, end));
    if (i < corners) made.push_back(cuts[i].bridge);
  }
  return is_closed(curve) ? with_one_end(chained(made)) : chained(made);
}

CornerCut arc_at(const NurbsCurve& before, const NurbsCurve& behind, double radius) {
  const DirectedEnd in = end_of(before);
  const DirectedEnd out = start_of(behind);
  const glm::dvec3 normal = glm::cross(in.tangent, out.tangent);
  const std::string where = place_text(in.point);
  if (!(glm::length(normal) > kSmooth)) throw InvalidShape("the curve turns back at " + where);
  const Fillet* nearest = nullptr;
  double least = 0.0;
  const std::vector<Fillet> found = fillets(before, behind, radius, normal);
  for (const Fillet& fillet : found) {
    if (!fillet.goes_on_a || !fillet.goes_on_b) continue;
    const double away = (before.domain().end - fillet.a) / before.domain().length() +
                        (fillet.b - behind.domain().start) / behind.domain().length();
    if (nearest && away >= least) continue;
    nearest = &fillet;
    least = away;
  }
  if (!nearest) throw InvalidShape("no arc of radius " + text_of(radius) + " fits at the corner " + where);
  return {nearest->a, nearest->arc, nearest->b};
}

/// The parameter at a length from another one, on the way to its start or end.
double parameter_beside(const NurbsCurve& curve, double from, double by) {
  const auto found = parameter_along(curve, lengths_at_parameters(curve, std::span(&from, 1)).front() + by);
  if (found) return *found;
  throw InvalidShape("the curve to " + place_text(end_of(curve).point) + " is too short for a chamfer of " + text_of(std::abs(by)));
}

CornerCut line_at(const NurbsCurve& before, const NurbsCurve& behind, double length) {
  const double from = parameter_beside(before, before.domain().end, -length);
  const double to = parameter_beside(behind, behind.domain().start, length);
  return {from, line_between(point_at(before, from), point_at(behind, to)), to};
}

void require_length(double length, const char* name) {
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape(std::string("the ") + name + " is not above 0");
}

}  // namespace

NurbsCurve rounded(const NurbsCurve& curve, double radius) {
  require_length(radius, "radius");
  return with_corners_cut(
      curve, [&](const NurbsCurve& before, const NurbsCurve& behind) { return arc_at(before, behind, radius); });
}

NurbsCurve chamfered(const NurbsCurve& curve, double length) {
  require_length(length, "length");
  return with_corners_cut(
      curve, [&](const NurbsCurve& before, const NurbsCurve& behind) { return line_at(before, behind, length); });
}

}  // namespace splinecore
