#include "loft_sections.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "aligned_sections.hpp"
#include "base/quotient.hpp"
#include "closes.hpp"
#include "rebuild_together.hpp"
#include "ribbon.hpp"
#include "section_corners.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

/// A section and, behind it, rows that stay beside it: of a neighbor's ribbon.
struct Bundle {
  std::vector<NurbsCurve> rows;
  double width = 0.0;  ///< of the ribbon; 0 of a section
  bool is_turned = false;  ///< it is to run the other way
};

bool is_pole(const LoftSection& section) { return std::holds_alternative<glm::dvec3>(section); }

/// The bundle made periodic if each of its rows closes, up to rounding.
Bundle closed_up(Bundle bundle) {
  if (!std::ranges::all_of(bundle.rows, closes)) return bundle;
  for (NurbsCurve& row : bundle.rows) row = made_periodic(row).value;
  return bundle;
}

Bundle bundle_of(const LoftNeighbor& neighbor) {
  Ribbon ribbon = ribbon_of(neighbor.patch, neighbor.side);
  return {std::move(ribbon.rows), ribbon.width};
}

std::vector<Bundle> bundles_of(std::span<const LoftSection> sections, const LoftOptions& options) {
  if (!options.turned.empty() && options.turned.size() != sections.size()) {
    throw InvalidShape("turned has " + std::to_string(options.turned.size()) + " values for " +
                       std::to_string(sections.size()) + " sections");
  }
  std::vector<Bundle> bundles;
  if (options.start.neighbor) bundles.push_back(bundle_of(*options.start.neighbor));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (!is_pole(sections[i])) {
      bundles.push_back({{std::get<NurbsCurve>(sections[i])}, 0.0, !options.turned.empty() && options.turned[i]});
      continue;
    }
    const bool is_outer = (i == 0 && !options.start.neighbor) || (i + 1 == sections.size() && !options.end.neighbor);
    if (!is_outer || options.closing == Closing::closed) {
      throw InvalidShape("sections" + index_text(i) + " is a point: only the first and the last section of an open loft may be");
    }
    if (!is_finite(std::get<glm::dvec3>(sections[i]))) throw InvalidShape("sections" + index_text(i) + " is not finite");
  }
  if (options.end.neighbor) bundles.push_back(bundle_of(*options.end.neighbor));
  if (bundles.empty()) throw InvalidShape("all sections are points: a curve is needed");
  return bundles;
}

NurbsCurve near_curve(const NurbsCurve& curve, const NearSpace& space) {
  return curve.with_points(space.enter(curve.points()));
}

NearSpace space_of(const std::vector<Bundle>& bundles, std::span<const LoftSection> sections) {
  std::vector<glm::dvec4> all;
  for (const Bundle& bundle : bundles) all.insert(all.end(), bundle.rows[0].points().begin(), bundle.rows[0].points().end());
  for (const LoftSection& section : sections) {
    if (is_pole(section)) all.emplace_back(std::get<glm::dvec3>(section), 1.0);
  }
  return NearSpace(all);
}

std::vector<NurbsCurve> near_sections(const std::vector<Bundle>& bundles, const NearSpace& space) {
  std::vector<NurbsCurve> near;
  for (const Bundle& bundle : bundles) near.push_back(near_curve(bundle.rows[0], space));
  return near;
}

/// @param corners  that are matched, if any are
void align(std::vector<Bundle>& bundles, const NearSpace& space, const std::optional<SectionCorners>& corners) {
  const std::vector<NurbsCurve> near = near_sections(bundles, space);
  const std::vector<SectionTurn> turns = corners ? turns_by_corners(near, *corners) : turns_of(near);
  for (std::size_t i = 0; i < bundles.size(); ++i) {
    for (NurbsCurve& row : bundles[i].rows) row = turned(row, turns[i]);
  }
}

/// Corners of sections that can be matched.
std::optional<SectionCorners> corners_to_match(const std::vector<Bundle>& bundles, const NearSpace& space,
                                               const LoftOptions& options) {
  if (options.corners == LoftCorners::free) return {};
  SectionCorners found = section_corners(near_sections(bundles, space), options.is_aligned);
  return found.are_as_many() ? std::optional(std::move(found)) : std::nullopt;
}

/// All rows with their corners at the same parameters, as they run now.
void match_corners(std::vector<Bundle>& bundles, const NearSpace& space) {
  const bool are_periodic = std::ranges::all_of(bundles, [](const Bundle& bundle) { return bundle.rows[0].periodic(); });
  for (Bundle& bundle : bundles) {
    for (NurbsCurve& row : bundle.rows) {
      if (!are_periodic && row.periodic()) row = clamped(row);
    }
  }
  const std::vector<NurbsCurve> near = near_sections(bundles, space);
  const SectionCorners corners = section_corners(near, false);
  if (!corners.are_as_many()) return;
  const std::vector<double> wanted = mean_corners(near, corners);
  for (std::size_t i = 0; i < bundles.size(); ++i) {
    for (NurbsCurve& row : bundles[i].rows) row = repaced(row, corners.at[i], wanted, near[0].domain());
  }
}

/// Sections that go round and run as those before them: so does the first beside the last, or that is shared among all.
void close(std::vector<Bundle>& bundles, const NearSpace& space) {
  const double share = turn_left(near_curve(bundles.back().rows[0], space), near_curve(bundles.front().rows[0], space));
  if (share == 0.0) return;
  std::vector<NurbsCurve> sections;
  for (const Bundle& bundle : bundles) sections.push_back(bundle.rows[0]);
  sections = turned_evenly(sections, share);
  for (std::size_t i = 0; i < bundles.size(); ++i) bundles[i].rows[0] = std::move(sections[i]);
}

void turn(std::vector<Bundle>& bundles) {
  for (Bundle& bundle : bundles) {
    for (NurbsCurve& row : bundle.rows) {
      if (bundle.is_turned) row = reversed(row);
    }
  }
}

/// The sections, not the sides of neighbors, on few knots. @returns how far they were moved
double rebuild(std::vector<Bundle>& bundles, double tolerance) {
  std::vector<NurbsCurve> curves;
  int degree = 3;
  for (const Bundle& bundle : bundles) {
    if (bundle.width > 0.0) {
      degree = std::max(degree, bundle.rows[0].degree());
    } else {
      curves.push_back(bundle.rows[0]);
    }
  }
  if (curves.empty()) return 0.0;
  auto rebuilt = rebuild_together(curves, degree, tolerance);
  std::size_t next = 0;
  for (Bundle& bundle : bundles) {
    if (bundle.width == 0.0) bundle.rows[0] = std::move(rebuilt.value[next++]);
  }
  return rebuilt.error;
}

/// Knots over [0, 1] with those that are one up to rounding once, and how often each would be there at a degree.
void add_knots(const NurbsCurve& curve, int degree, std::vector<std::pair<double, int>>& knots) {
  const Interval domain = curve.domain();
  const auto all = curve.knot_vector().knots();
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    while (end < all.size() && all[end] == all[i]) ++end;
    const double at = (all[i] - domain.start) / domain.length();
    if (at > 0.0 && at < 1.0) knots.emplace_back(at, static_cast<int>(end - i) + degree - curve.degree());
    i = end;
  }
}

/// @throws InvalidShape if rows that all have their knots would have too many control points
void require_room(const std::vector<NurbsCurve>& rows) {
  constexpr double kSame = 0x1p-40;
  constexpr double kMost = 0x1p20;
  constexpr double kShared = 4.0;  // as many as so many sections have: they share most
  const int degree = std::ranges::max(rows, {}, &NurbsCurve::degree).degree();
  std::vector<std::pair<double, int>> knots;
  std::size_t most = 0;
  for (const NurbsCurve& row : rows) {
    add_knots(row, degree, knots);
    most = std::max(most, row.points().size());
  }
  std::ranges::sort(knots);
  double count = degree + 1.0;
  for (std::size_t i = 0; i < knots.size();) {
    int copies = 0;
    const double at = knots[i].first;
    for (; i < knots.size() && knots[i].first - at <= kSame; ++i) copies = std::max(copies, knots[i].second);
    count += copies;
  }
  const double points = count * static_cast<double>(rows.size());
  if (points <= kMost || count <= kShared * static_cast<double>(most)) return;
  throw InvalidShape("the sections do not share their knots: together they have too many, the surface would have " +
                     std::to_string(static_cast<long long>(points)) +
                     " control points. With a tolerance they are approximated within it on fewer knots");
}

std::vector<NurbsCurve> rows_of(const std::vector<Bundle>& bundles) {
  std::vector<NurbsCurve> all;
  for (const Bundle& bundle : bundles) all.insert(all.end(), bundle.rows.begin(), bundle.rows.end());
  return all;
}

/// How far curves that were made compatible were moved by that.
double moved_by(const std::vector<NurbsCurve>& rows, const std::vector<NurbsCurve>& made) {
  double error = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const NurbsCurve plain = rows[i].periodic() && !made[i].periodic() ? clamped(rows[i]) : rows[i];
    const NurbsCurve before = plain.domain() == made[i].domain() ? plain : with_domain(plain, made[i].domain());
    if (!std::ranges::includes(made[i].knot_vector().knots(), before.knot_vector().knots())) {
      error = std::max(error, largest_distance(before, made[i]));
    }
  }
  return error;
}

/// All rows on one knot vector. Knots that are one but for rounding of what made them are one where that moves no section by more
/// than rounding. @returns how far they were moved
double make_compatible(std::vector<Bundle>& bundles, double knot_distance, const NearSpace& space) {
  constexpr double kSame = 0x1p-40;
  const std::vector<NurbsCurve> rows = rows_of(bundles);
  if (knot_distance == 0.0) require_room(rows);
  std::vector<NurbsCurve> made = compatible(rows, std::max(knot_distance, kSame));
  double error = moved_by(rows, made);
  if (knot_distance < kSame && !(error <= space.length(kSame))) {
    made = compatible(rows, knot_distance);
    error = moved_by(rows, made);
  }
  std::size_t next = 0;
  for (Bundle& bundle : bundles) {
    for (NurbsCurve& row : bundle.rows) row = made[next++];
  }
  return knot_distance > 0.0 || error > space.length(kSame) ? error : 0.0;
}

/// What the weights of a section are divided by.
double factor_of(const NurbsCurve& section, SectionWeights weights) {
  if (weights == SectionWeights::kept || !section.rational()) return 1.0;
  double sum = 0.0;
  for (const glm::dvec4& p : section.points()) sum += p.w;
  return sum == 0.0 ? 1.0 : sum / static_cast<double>(section.points().size());
}

NurbsCurve with_weights_divided(const NurbsCurve& curve, double factor) {
  if (factor == 1.0) return curve;
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& p : points) p = p.w == 0.0 ? p / factor : glm::dvec4(glm::dvec3(p), p.w / factor);
  return curve.with_points(std::move(points));
}

LeavingRows leaving_rows(const Bundle& bundle, int count, const NearSpace& space) {
  Ribbon near{{}, bundle.width};
  for (const NurbsCurve& row : bundle.rows) near.rows.push_back(near_curve(row, space));
  LeavingRows rows;
  for (int order = 1; order <= count; ++order) rows.push_back(derivative_out(near, order));
  return rows;
}

SectionRow row_of(std::vector<glm::dvec4> points, const NearSpace& space) {
  std::vector<glm::dvec4> near = homogeneous(space.enter(points));
  return {std::move(points), std::move(near)};
}

/// A point as often as a section has control points, with the weights of these.
SectionRow pole_row(const glm::dvec3& pole, const SectionRow& beside, const NearSpace& space) {
  std::vector<glm::dvec4> points;
  for (const glm::dvec4& p : beside.points) points.emplace_back(pole, p.w);
  SectionRow row = row_of(std::move(points), space);
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    if (row.points[i].w == 0.0) row.points[i] = row.near[i] = glm::dvec4(0.0);
  }
  return row;
}

}  // namespace

std::vector<std::size_t> corner_counts(std::span<const LoftSection> sections, const LoftOptions& options) {
  std::vector<Bundle> bundles = bundles_of(sections, options);
  for (Bundle& bundle : bundles) bundle = closed_up(std::move(bundle));
  const auto near = near_sections(bundles, space_of(bundles, sections));
  std::vector<std::size_t> counts;
  for (const auto& corners : section_corners(near, options.is_aligned).at) counts.push_back(corners.size());
  const auto is_pole_at = [&](bool is_end) { return !sections.empty() && is_pole(is_end ? sections.back() : sections.front()); };
  if (is_pole_at(false)) counts.insert(counts.begin(), 0);
  if (is_pole_at(true)) counts.push_back(0);
  return counts;
}

LoftSections loft_sections(std::span<const LoftSection> sections, const LoftOptions& options) {
  std::vector<Bundle> bundles = bundles_of(sections, options);
  for (Bundle& bundle : bundles) bundle = closed_up(std::move(bundle));
  const NearSpace space = space_of(bundles, sections);
  const std::optional<SectionCorners> corners = corners_to_match(bundles, space, options);
  if (options.is_aligned) align(bundles, space, corners);
  turn(bundles);
  if (corners) match_corners(bundles, space);
  const bool is_turned = std::ranges::any_of(options.turned, std::identity());
  if (options.is_aligned && options.closing == Closing::closed && !is_turned) close(bundles, space);
  double error = options.tolerance ? rebuild(bundles, *options.tolerance) : 0.0;
  error += make_compatible(bundles, options.knot_distance, space);
  for (Bundle& bundle : bundles) {
    const double factor = factor_of(bundle.rows[0], options.weights);
    for (NurbsCurve& row : bundle.rows) row = with_weights_divided(row, factor);
  }
  LoftSections made{space, bundles[0].rows[0].knot_vector(), {}, {}, {}, error};
  for (const Bundle& bundle : bundles) {
    made.rows.push_back(row_of({bundle.rows[0].points().begin(), bundle.rows[0].points().end()}, space));
  }
  if (options.start.neighbor) {
    made.leaving_start = leaving_rows(bundles.front(), options.start.neighbor->continuity, space);
  }
  if (options.end.neighbor) made.leaving_end = leaving_rows(bundles.back(), options.end.neighbor->continuity, space);
  if (!sections.empty() && is_pole(sections.front())) {
    made.rows.insert(made.rows.begin(), pole_row(std::get<glm::dvec3>(sections.front()), made.rows.front(), space));
  }
  if (!sections.empty() && is_pole(sections.back())) {
    made.rows.push_back(pole_row(std::get<glm::dvec3>(sections.back()), made.rows.back(), space));
  }
  return made;
}

}  // namespace splinecore
