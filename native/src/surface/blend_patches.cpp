#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "kept_continuity.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/surface/loft.hpp"

namespace splinecore {

namespace {

struct PlaceAlong {
  glm::dvec3 point;
  glm::dvec3 way;
};

PlaceAlong place_at(const NurbsCurve& curve, double at) {
  PlaceAlong place;
  glm::dvec3 jet[2];
  derivatives(curve, {&at, 1}, 1, std::span(&jet[0].x, 6));
  place.point = jet[0];
  place.way = jet[1];
  return place;
}

/// How a closed side of a neighbor lies to the end of a blend that begins elsewhere.
struct SeamTurn {
  double later;      ///< by how much of the period it begins later, from -1/2 to 1/2
  bool is_reversed;  ///< it runs the other way
};

/// @returns none where it begins where the blend does
std::optional<SeamTurn> turn_at_end(const NurbsPatch& blend, const LoftNeighbor& to) {
  constexpr double kSame = 0x1p-30;
  const NurbsCurve end = boundary(blend, Border::v_end);
  if (!end.periodic()) return {};
  const NurbsCurve side = boundary(to.patch, to.side);
  const PlaceAlong seam = place_at(side, side.domain().start);
  const Interval domain = end.domain();
  if (distance_of(place_at(end, domain.start).point, seam.point) <= kSame * extent(end.points())) return {};
  NearestOnCurve found;
  nearest(end, {&seam.point, 1}, {&found, 1});
  const double share = (found.parameter - domain.start) / domain.length();
  return SeamTurn{share - std::round(share), glm::dot(place_at(end, found.parameter).way, seam.way) < 0.0};
}

/// From 0 to 1 with three derivatives that are 0 at both ends.
double rise(double t) { return t * t * t * t * (35.0 - t * (84.0 - t * (70.0 - 20.0 * t))); }

/// The same surface, but for little, run through so that its lines across end where the side of the second patch begins.
NurbsPatch turned_to_seam(const NurbsPatch& blend, const LoftNeighbor& from, LoftNeighbor to, const SeamTurn& turn, bool is_calm) {
  constexpr int kLeast = 8;
  constexpr double kMore = 24.0;     // sections for a whole turn
  constexpr double kMoved = 0x1p-14;  // of the size, for few knots
  const Interval along = blend.knot_vector(Axis::u).domain();
  const Interval across = blend.knot_vector(Axis::v).domain();
  const int count = kLeast + static_cast<int>(std::ceil(kMore * std::abs(turn.later)));
  LoftOptions options;
  options.is_aligned = false;
  options.is_calm = is_calm;
  options.tolerance = kMoved * extent(blend.points());
  options.degree = std::max(from.continuity, to.continuity) > 2 ? 5 : 3;
  options.parameters = {0.0};
  std::vector<LoftSection> sections;
  for (int k = 1; k < count; ++k) {
    const double t = static_cast<double>(k) / count;
    const NurbsCurve line = isocurve(blend, Axis::v, across.start + t * across.length());
    const double later = turn.later * rise(t);
    const double start = along.start + (later - std::floor(later)) * along.length();
    sections.emplace_back(start > along.start && start < along.end ? with_seam_at(line, start) : line);
    options.parameters.push_back(t);
  }
  options.parameters.push_back(1.0);
  if (turn.is_reversed) to.patch = reversed(to.patch, axis_of(to.side) == Axis::u ? Axis::v : Axis::u);
  options.start.neighbor = from;
  options.end.neighbor = std::move(to);
  return loft(sections, options).value;
}

}  // namespace

NurbsPatch blend(const LoftNeighbor& from, const LoftNeighbor& to, bool is_aligned, bool is_calm) {
  LoftOptions options;
  options.is_aligned = is_aligned;
  options.is_calm = is_calm;
  options.start.neighbor = from;
  options.end.neighbor = to;
  NurbsPatch made = loft({}, options).value;
  if (is_aligned) {
    if (const auto turn = turn_at_end(made, to)) made = turned_to_seam(made, from, to, *turn, is_calm);
  }
  require_continuity(made, Border::v_start, from, "the first patch");
  require_continuity(made, Border::v_end, to, "the second patch");
  return made;
}

}  // namespace splinecore
