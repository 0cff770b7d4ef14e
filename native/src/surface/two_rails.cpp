#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "base/require.hpp"
#include "base/rounding.hpp"
#include "build/fit_options.hpp"
#include "closes.hpp"
#include "fitted_rows.hpp"
#include "fitted_together.hpp"
#include "kink.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "rail_frames.hpp"
#include "rail_sections.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/surface/rail_matrices.hpp"
#include "splinecore/surface/sweep.hpp"

namespace splinecore {

namespace {

/// Both rails over one domain, about 1 large.
struct Rails {
  NurbsCurve first;
  NurbsCurve second;
};

/// A place between the rails: x of the frame goes from one to the other.
struct PlaceBetween {
  RailPlace place;
  double width;
};

glm::dvec3 unit(const glm::dvec3& v) { return v / length_of(v); }

/// Even places inside a span.
std::vector<double> inside(const Interval& span) {
  constexpr int kInSpan = 8;
  std::vector<double> at;
  for (int k = 0; k < kInSpan; ++k) at.push_back(span.start + span.length() * (k + 0.5) / kInSpan);
  return at;
}

std::vector<glm::dvec3> points_of(const NurbsCurve& rail, std::span<const double> at, Side side) {
  std::vector<glm::dvec3> points(at.size());
  if (!at.empty()) evaluate(rail, at, std::span(&points.front().x, 3 * points.size()), {.side = side});
  return points;
}

std::vector<glm::dvec3> directions_of(const NurbsCurve& rail, std::span<const double> at, Side side) {
  std::vector<MovingFrame> frames(at.size());
  frenet_frames(rail, at, frames, side);
  std::vector<glm::dvec3> found;
  for (const MovingFrame& frame : frames) found.push_back(frame.tangent);
  return found;
}

/// At right angles to x, towards an upright direction or one that the rails run at right angles to.
glm::dvec3 height_of(const glm::dvec3& x, const glm::dvec3& towards, double at) {
  constexpr double kAlong = 1e-7;
  const glm::dvec3 high = towards - glm::dot(towards, x) * x;
  if (length_of(high) > kAlong * length_of(towards)) return unit(high);
  throw InvalidShape("at " + text_of(at) + " the way from one rail to the other lies along the upright direction or the rails");
}

/// The way that both rails run, by their unit tangents.
glm::dvec3 along_both(const glm::dvec3& first, const glm::dvec3& second, double at) {
  constexpr double kAgainst = 1e-7;
  const glm::dvec3 sum = first + second;
  if (!is_finite(sum) || length_of(sum) > kAgainst) return sum;
  throw InvalidShape("at " + text_of(at) + " the rails run against each other: reverse one of them");
}

std::vector<PlaceBetween> places_between(const Rails& rails, std::span<const double> at, Side side, const TwoRailOptions& options) {
  const std::vector<glm::dvec3> from = points_of(rails.first, at, side);
  const std::vector<glm::dvec3> to = points_of(rails.second, at, side);
  std::vector<glm::dvec3> along;
  if (!options.up) {
    along = directions_of(rails.first, at, side);
    const std::vector<glm::dvec3> other = directions_of(rails.second, at, side);
    for (std::size_t i = 0; i < along.size(); ++i) along[i] = along_both(along[i], other[i], at[i]);
  }
  std::vector<PlaceBetween> places;
  for (std::size_t i = 0; i < at.size(); ++i) {
    constexpr double kMeet = 0x1p-40;
    const double width = length_of(to[i] - from[i]);
    if (!(width > kMeet)) throw InvalidShape("the rails meet at " + text_of(at[i]) + ": there is no room for a section");
    const glm::dvec3 x = (to[i] - from[i]) / width;
    const glm::dvec3 y = height_of(x, options.up ? *options.up : glm::cross(along[i], x), at[i]);
    places.push_back({{from[i], {glm::cross(x, y), x, y}}, width});
  }
  return places;
}

/// Those at the end of a stretch from before it.
std::vector<PlaceBetween> places_between(const Rails& rails, std::span<const double> at, const Interval& stretch,
                                         const TwoRailOptions& options) {
  std::vector<PlaceBetween> places;
  while (places.size() < at.size()) {
    const auto rest = at.subspan(places.size());
    const bool is_end = rest.front() == stretch.end;
    const auto other = std::ranges::find_if(rest, [&](double v) { return (v == stretch.end) != is_end; });
    const auto part = rest.first(static_cast<std::size_t>(other - rest.begin()));
    const std::vector<PlaceBetween> found = places_between(rails, part, is_end ? Side::left : Side::right, options);
    places.insert(places.end(), found.begin(), found.end());
  }
  return places;
}

/// Sections go from one rail to the other: x from 0 to the width there.
/// @returns how far its ends, or it itself where they are elsewhere, pass by a rail, as a part of the width
/// @throws InvalidShape of one that is near neither
double gap_at_rails(const RailSection& section, double width, std::size_t index) {
  constexpr double kTouches = 1e-3;
  const std::array<glm::dvec3, 2> rails{glm::dvec3(0.0), glm::dvec3(width, 0.0, 0.0)};
  std::array<NearestOnCurve, 2> found;
  nearest(section.curve, rails, found, 1);
  const Interval domain = section.curve.domain();
  const std::vector<glm::dvec3> ends = points_of(section.curve, std::vector{domain.start, domain.end}, Side::left);
  std::array<double, 2> gaps{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double of_ends = std::min(distance_of(ends[0], rails[i]), distance_of(ends[1], rails[i]));
    gaps[i] = (of_ends <= kTouches * width ? of_ends : found[i].distance) / width;
  }
  if (std::min(gaps[0], gaps[1]) <= kTouches) return std::max(gaps[0], gaps[1]);
  throw InvalidShape("sections" + index_text(index) +
                     " touches neither rail: where it is, x is to go from 0, on the first one, to " + text_of(width) +
                     ", on the second one");
}

struct SectionsBetween {
  std::vector<RailSection> sections;  ///< of which x is 1 at the second rail
  double gap = 0.0;                   ///< by which they pass by rails, as a part of the width
};

SectionsBetween of_width_one(const Rails& rails, std::span<const RailSection> sections, double unit_length,
                                      const TwoRailOptions& options) {
  SectionsBetween made;
  for (const RailSection& section : sections) {
    const double at = std::clamp(section.at, rails.first.domain().start, rails.first.domain().end);
    const double width = places_between(rails, std::span(&at, 1), rails.first.domain(), options)[0].width;
    made.gap = std::max(made.gap, gap_at_rails(section, width * unit_length, made.sections.size()));
    std::vector<glm::dvec4> points(section.curve.points().begin(), section.curve.points().end());
    for (glm::dvec4& p : points) {
      const glm::dvec3 near = glm::dvec3(p) / unit_length;
      p = options.is_height_scaled ? glm::dvec4(near / width, p.w) : glm::dvec4(near.x / width, near.y, near.z, p.w);
    }
    made.sections.push_back({section.curve.with_points(std::move(points)), section.at});
  }
  return made;
}

NurbsCurve closed_smoothly(const NurbsCurve& rail) { return closes(rail) ? made_periodic(rail).value : rail; }

Rails prepared(const NurbsCurve& first, const NurbsCurve& second, const NearSpace& space) {
  NurbsCurve a = closed_smoothly(first);
  NurbsCurve b = with_domain(closed_smoothly(second), a.domain());
  if (!a.periodic() || !b.periodic()) {
    a = clamped(a);
    b = clamped(b);
  }
  return {a.with_points(space.enter(a.points())), b.with_points(space.enter(b.points()))};
}

/// @param negligible  angles of corners that are none
std::vector<double> breaks_of(const Rails& rails, bool has_up, double negligible) {
  const NurbsCurve both[] = {rails.first, rails.second};
  const Interval domain = rails.first.domain();
  std::vector<double> breaks{domain.start};
  std::vector<double> corners = corners_of(both);
  std::erase_if(corners, [&](double u) { return std::max(kink_angle(rails.first, u), kink_angle(rails.second, u)) <= negligible; });
  for (const double corner : corners) {
    const bool is_end = corner == domain.start || corner == domain.end;
    if (!has_up && (!is_end || rails.first.periodic())) {
      throw InvalidShape("a rail has a corner at " + text_of(corner) + ": round it first, or give an upright direction");
    }
    if (!is_end) breaks.push_back(corner);
  }
  breaks.push_back(domain.end);
  return breaks;
}

/// @throws InvalidShape if on the whole, by their tangents, rails run against each other
void require_one_way(const Rails& rails) {
  double with = 0.0;
  for (const NurbsCurve* const by : {&rails.first, &rails.second}) {
    const KnotVector& knots = by->knot_vector();
    for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
      const Interval span = knots.span_interval(i);
      const std::vector<double> at = inside(span);
      const std::vector<glm::dvec3> first = directions_of(rails.first, at, Side::right);
      const std::vector<glm::dvec3> second = directions_of(rails.second, at, Side::right);
      for (std::size_t k = 0; k < at.size(); ++k) {
        const double cosine = glm::dot(first[k], second[k]);
        if (std::isfinite(cosine)) with += span.length() * cosine;
      }
    }
  }
  constexpr double kAgainst = -1e-6;
  if (with >= kAgainst * rails.first.domain().length()) return;
  throw InvalidShape("the rails run against each other: reverse one of them");
}

void require_options(const TwoRailOptions& options) {
  if (options.tolerance) require_positive(*options.tolerance);
  if (options.up && !(is_finite(*options.up) && length_of(*options.up) > 0.0)) {
    throw InvalidShape("the upright direction is zero or not finite");
  }
}

}  // namespace

Approximation<NurbsPatch> sweep(const NurbsCurve& rail, const NurbsCurve& second, std::span<const RailSection> sections,
                                const TwoRailOptions& options) {
  require_options(options);
  const NearSpace space(together(rail.points(), second.points()));
  const Rails rails = prepared(rail, second, space);
  require_one_way(rails);
  const SectionsBetween between = of_width_one(rails, sections, space.length(1.0), options);
  const RailSections along(between.sections, rails.first, 1.0);
  const auto rows_at = [&](std::span<const double> at, const Interval& stretch) {
    const std::vector<PlaceBetween> places = places_between(rails, at, stretch, options);
    std::vector<glm::dvec4> rows = along.at(at);
    const std::size_t width = rows.size() / at.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto& [place, apart] = places[i / width];
      const double high = options.is_height_scaled ? apart : 1.0;
      const glm::dvec3 out = in_frame(place.frame, glm::dvec3(rows[i]) * glm::dvec3(apart, high, high));
      rows[i] = glm::dvec4(out + rows[i].w * place.point, rows[i].w);
    }
    return rows;
  };
  const double within = options.tolerance ? *options.tolerance / space.length(1.0) : 0x1p-20;
  const std::vector<double> breaks = breaks_of(rails, options.up.has_value(), kKinkShare * within);
  const bool goes_round = rails.first.periodic() && breaks.size() == 2;
  RowDomain domain{breaks, joints_at(rails.first.knot_vector()), goes_round ? Closing::closed : Closing::open};
  std::ranges::copy(joints_at(rails.second.knot_vector()), std::back_inserter(domain.joints));
  std::ranges::copy(along.joints(), std::back_inserter(domain.joints));
  const FittedRows rows = said_outside(space, [&] { return fitted_rows(rows_at, domain, within); });
  along.require_weights(rows);
  const NurbsPatch near = patch_of(along.knots(), rows);
  const double off_rails = between.gap > kRoundingOfPlace ? between.gap * largest_distance(rails.first, rails.second) : 0.0;
  return {near.with_points(space.leave(near.points())), space.length(rows.error + off_rails)};
}

std::vector<glm::dmat4> rail_matrices(const NurbsCurve& rail, const NurbsCurve& second, std::span<const double> at,
                                      const TwoRailOptions& options) {
  require_options(options);
  const NearSpace space(together(rail.points(), second.points()));
  const Rails rails = prepared(rail, second, space);
  std::vector<glm::dmat4> matrices;
  for (const PlaceBetween& one : places_between(rails, at, rails.first.domain(), options)) {
    matrices.push_back(matrix_of(one.place, space));
  }
  return matrices;
}

}  // namespace splinecore
