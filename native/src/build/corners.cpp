#include "splinecore/build/corners.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/printable.hpp"
#include "curve_ends.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/fillet.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/conic/arcs.hpp"
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
  std::optional<NurbsCurve> bridge;  ///< none where the corner stays
  double behind;
};

/// What parts of the runs before and behind a corner may be taken where others take theirs, too.
struct Shares {
  double before = 1.0;
  double behind = 1.0;
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
    cuts.push_back(
        cut_at(part(runs[0], domain.middle(), domain.end), part(runs[0], domain.start, domain.middle()), Shares{}));
  } else {
    const auto share = [&](std::size_t run) { return is_round || (run > 0 && run < corners) ? 0.5 : 1.0; };
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t next = (i + 1) % runs.size();
      cuts.push_back(cut_at(runs[i], runs[next], Shares{share(i), share(next)}));
    }
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
    if (i < corners && cuts[i].bridge) made.push_back(*cuts[i].bridge);
  }
  return is_closed(curve) ? with_one_end(chained(made)) : chained(made);
}

/// The arc that is nearest to a corner, if there is one.
std::optional<CornerCut> nearest_arc(const NurbsCurve& before, const NurbsCurve& behind, double radius,
                                     const glm::dvec3& normal) {
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
  if (!nearest) return std::nullopt;
  return CornerCut{nearest->a, nearest->arc, nearest->b};
}

CornerCut arc_at(const NurbsCurve& before, const NurbsCurve& behind, double radius) {
  const DirectedEnd in = end_of(before);
  const glm::dvec3 normal = glm::cross(in.tangent, start_of(behind).tangent);
  const std::string where = place_text(in.point);
  if (!(glm::length(normal) > kSmooth)) throw InvalidShape("the curve turns back at " + where);
  const auto found = nearest_arc(before, behind, radius, normal);
  if (!found) throw InvalidShape("no arc of radius " + text_of(radius) + " fits at the corner " + where);
  return *found;
}

/// The parameter at a length from another one, on the way to its start or end.
double parameter_beside(const NurbsCurve& curve, double from, double by) {
  const auto found = parameter_along(curve, lengths_at_parameters(curve, std::span(&from, 1)).front() + by);
  if (found) return *found;
  throw InvalidShape("the curve to " + place_text(end_of(curve).point) + " is too short for a chamfer of " + text_of(std::abs(by)));
}

double length_of(const NurbsCurve& curve) {
  const double end = curve.domain().end;
  return lengths_at_parameters(curve, std::span(&end, 1)).front();
}

bool is_line(const NurbsCurve& curve) {
  return curve.points().size() == 2 && curve.points()[0].w == curve.points()[1].w;
}

CornerCut corner_left(const NurbsCurve& before, const NurbsCurve& behind) {
  return {before.domain().end, std::nullopt, behind.domain().start};
}

/// The arc between two lines that begins at a length before their corner and ends as far behind it.
CornerCut arc_between_lines(const NurbsCurve& before, const NurbsCurve& behind, double taken) {
  const double from = before.domain().end - taken / length_of(before) * before.domain().length();
  const double to = behind.domain().start + taken / length_of(behind) * behind.domain().length();
  return {from, arc_from_tangent(point_at(before, from), end_of(before).tangent, point_at(behind, to)), to};
}

/// The largest arc up to a radius that takes no more than its shares.
CornerCut arc_within(const NurbsCurve& before, const NurbsCurve& behind, double radius, const Shares& shares) {
  constexpr double kSameRadius = 0x1p-44;
  const glm::dvec3 in = end_of(before).tangent;
  const glm::dvec3 out = start_of(behind).tangent;
  const glm::dvec3 normal = glm::cross(in, out);
  if (!(glm::length(normal) > kSmooth)) return corner_left(before, behind);
  const double room_before = shares.before * length_of(before);
  const double room_behind = shares.behind * length_of(behind);
  if (is_line(before) && is_line(behind)) {
    const double tangent_of_half = glm::length(normal) / (1.0 + glm::dot(in, out));
    return arc_between_lines(before, behind, std::min({radius * tangent_of_half, room_before, room_behind}));
  }
  const double first = shares.before == 1.0 ? before.domain().start : parameter_beside(before, before.domain().end, -room_before);
  const double last = shares.behind == 1.0 ? behind.domain().end : parameter_beside(behind, behind.domain().start, room_behind);
  const auto fitting = [&](double of) {
    auto found = nearest_arc(before, behind, of, normal);
    if (found && (found->before < first || found->behind > last)) found.reset();
    return found;
  };
  if (const auto found = fitting(radius)) return *found;
  CornerCut best = corner_left(before, behind);
  double low = 0.0;
  double high = radius;
  while (high - low > kSameRadius * high && high > 0.0) {
    const double middle = low + 0.5 * (high - low);
    const auto found = fitting(middle);
    (found ? low : high) = middle;
    if (found) best = *found;
  }
  return best;
}

CornerCut line_at(const NurbsCurve& before, const NurbsCurve& behind, double length) {
  const double from = parameter_beside(before, before.domain().end, -length);
  const double to = parameter_beside(behind, behind.domain().start, length);
  return {from, line_between(point_at(before, from), point_at(behind, to)), to};
}

/// The line that takes no more than its shares, at the same length on both sides.
CornerCut line_within(const NurbsCurve& before, const NurbsCurve& behind, double length, const Shares& shares) {
  const glm::dvec3 normal = glm::cross(end_of(before).tangent, start_of(behind).tangent);
  if (!(glm::length(normal) > kSmooth)) return corner_left(before, behind);
  return line_at(before, behind, std::min({length, shares.before * length_of(before), shares.behind * length_of(behind)}));
}

void require_length(double length, const char* name) {
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape(std::string("the ") + name + " is not above 0");
}

}  // namespace

NurbsCurve rounded(const NurbsCurve& curve, double radius, bool shrinks) {
  require_length(radius, "radius");
  return with_corners_cut(curve, [&](const NurbsCurve& before, const NurbsCurve& behind, const Shares& shares) {
    return shrinks ? arc_within(before, behind, radius, shares) : arc_at(before, behind, radius);
  });
}

NurbsCurve chamfered(const NurbsCurve& curve, double length, bool shrinks) {
  require_length(length, "length");
  return with_corners_cut(curve, [&](const NurbsCurve& before, const NurbsCurve& behind, const Shares& shares) {
    return shrinks ? line_within(before, behind, length, shares) : line_at(before, behind, length);
  });
}

}  // namespace splinecore
