#include "splinecore/surface/loft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <glm/geometric.hpp>
#include <string>

#include "base/length.hpp"
#include "base/positive_weights.hpp"
#include "base/quotient.hpp"
#include "calm_loft.hpp"
#include "fit/row_spline.hpp"
#include "going_on.hpp"
#include "loft_misses.hpp"
#include "loft_pace.hpp"
#include "loft_sections.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

std::string short_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

bool is_smooth(LoftStyle style) { return style != LoftStyle::loose && style != LoftStyle::straight; }

bool is_free(const LoftEnd& end) { return !end.tangent && !end.flat && !end.neighbor; }

void require_end(const LoftEnd& end, bool is_at_pole, const char* name) {
  const std::string which = name;
  if (end.tangent.has_value() + end.flat.has_value() + end.neighbor.has_value() > 1) {
    throw InvalidShape("the " + which + " has more than one of tangent, flat and neighbor");
  }
  if (end.flat && !is_at_pole) throw InvalidShape("the " + which + " is flat: only a section that is a point can be");
  for (const auto& vector : {end.tangent, end.flat}) {
    if (vector && !(is_finite(*vector) && length_of(*vector) > 0.0)) {
      throw InvalidShape("the tangent or normal at the " + which + " has no direction");
    }
  }
  if (!(end.flat_speed > 0.0 && std::isfinite(end.flat_speed))) {
    throw InvalidShape("flat_speed = " + text_of(end.flat_speed) + " at the " + which + ": above 0 is expected");
  }
  if (!end.neighbor) return;
  const LoftNeighbor& neighbor = *end.neighbor;
  if (neighbor.continuity < 0 || neighbor.continuity > 3) {
    throw InvalidShape("continuity " + std::to_string(neighbor.continuity) + " at the " + which + ": 0 to 3 is expected");
  }
  if (!(neighbor.strength > 0.0 && std::isfinite(neighbor.strength))) {
    throw InvalidShape("strength = " + text_of(neighbor.strength) + " at the " + which + ": above 0 is expected");
  }
}

void require_options(std::span<const LoftSection> sections, const LoftOptions& options) {
  const std::size_t count =
      sections.size() + options.start.neighbor.has_value() + options.end.neighbor.has_value();
  const std::size_t least = options.closing == Closing::closed ? 3 : 2;
  if (count < least) {
    throw InvalidShape("a loft of " + std::to_string(count) + " sections: at least " + std::to_string(least) + " are needed");
  }
  const auto is_pole = [](const LoftSection& section) { return std::holds_alternative<glm::dvec3>(section); };
  require_end(options.start, !sections.empty() && is_pole(sections.front()), "start");
  require_end(options.end, !sections.empty() && is_pole(sections.back()), "end");
  if (is_free(options.start) && is_free(options.end)) return;
  if (options.closing == Closing::closed) throw InvalidShape("a closed loft has no start and no end");
  if (!is_smooth(options.style)) throw InvalidShape("a loose or straight loft cannot continue a surface: it has no tangents at its ends");
}

/// Of each point the same: where w is its weight, w times the vector.
std::vector<glm::dvec4> weighted(std::span<const glm::dvec4> row, const glm::dvec3& vector) {
  std::vector<glm::dvec4> found;
  for (const glm::dvec4& p : row) found.emplace_back(p.w * vector, 0.0);
  return found;
}

/// From a pole to the section beside it, along the plane with this normal; of mean length 1.
std::vector<glm::dvec4> along_plane(const SectionRow& pole, const SectionRow& beside, const glm::dvec3& normal) {
  const glm::dvec3 up = normal / length_of(normal);
  std::vector<glm::dvec4> found;
  double sum = 0.0;
  for (std::size_t i = 0; i < pole.near.size(); ++i) {
    const double w = pole.near[i].w;
    glm::dvec3 way(0.0);
    if (w != 0.0) way = glm::dvec3(beside.near[i]) / beside.near[i].w - glm::dvec3(pole.near[i]) / w;
    way -= glm::dot(way, up) * up;
    sum += length_of(way) / static_cast<double>(pole.near.size());
    found.emplace_back(w * way, 0.0);
  }
  if (!(sum > 0.0)) throw InvalidShape("a pole cannot be flat: the section next to it lies along the normal");
  return scaled(1.0 / sum, std::move(found));
}

/// Derivatives along v at an end, of the homogeneous rows.
/// @param speed  elsewhere; below 0 at the end, where v leads to it
/// @param step   of v to the next section
std::vector<std::vector<double>> leaving(const LoftEnd& end, const LeavingRows& out, const SectionRow& own,
                                         const SectionRow& beside, double speed, double step) {
  constexpr double kRoom = 0.25;
  if (end.tangent) return {numbers_of(scaled(std::abs(speed), weighted(own.near, *end.tangent)))};
  if (end.flat) return {numbers_of(scaled(end.flat_speed * speed, along_plane(own, beside, *end.flat)))};
  std::vector<std::vector<double>> rows;
  if (out.empty()) return rows;
  const double given = speed_of(own.near, out[0]);
  if (!(given > 0.0)) throw InvalidShape("a neighbor has a zero derivative across its side: it cannot be continued there");
  const double pace = end.neighbor->strength * speed / given;
  for (const auto& row : going_on(own.near, out, pace, kRoom * step)) rows.push_back(numbers_of(row));
  return rows;
}

int degree_along(std::size_t conditions, std::size_t rows, const LoftOptions& options) {
  constexpr int kOfTwo = 7;
  if (options.style == LoftStyle::straight) return 1;
  const int most = static_cast<int>(conditions) - 1;
  return std::min(rows == 2 && options.knots.empty() ? std::max(options.degree, kOfTwo) : options.degree, most);
}

/// Weights that are the same in all rows, and whose derivatives are 0, are those of the control points to the last digit.
void keep_level_weights(const RowConditions& given, RowSpline& spline) {
  const std::size_t numbers = given.rows.front().size();
  for (std::size_t at = 3; at < numbers; at += 4) {
    const double weight = given.rows.front()[at];
    const auto is_level = [&](const std::vector<double>& row) { return row[at] == weight; };
    const auto is_still = [&](const std::vector<double>& row) { return row[at] == 0.0; };
    if (!std::ranges::all_of(given.rows, is_level) || !std::ranges::all_of(given.start, is_still) ||
        !std::ranges::all_of(given.end, is_still)) {
      continue;
    }
    for (std::size_t i = at; i < spline.controls.size(); i += numbers) spline.controls[i] = weight;
  }
}

RowSpline spline_along(const LoftSections& sections, const LoftOptions& options, const Pace& pace) {
  RowConditions given;
  given.parameters = pace.parameters;
  for (const SectionRow& row : sections.rows) given.rows.push_back(numbers_of(row.near));
  const auto& rows = sections.rows;
  given.start = leaving(options.start, sections.leaving_start, rows.front(), rows[1], pace.speed, pace.step_at(false));
  given.end = leaving(options.end, sections.leaving_end, rows.back(), rows[rows.size() - 2], -pace.speed, pace.step_at(true));
  const std::size_t conditions = given.rows.size() + given.start.size() + given.end.size();
  const int degree = degree_along(conditions, given.rows.size(), options);
  if (options.style != LoftStyle::loose) {
    RowSpline through = spline_through(given, degree, options.closing, options.knots);
    keep_level_weights(given, through);
    return through;
  }
  RowSpline spline{knots_through(given, degree, options.closing, options.knots), {}};
  for (const auto& row : given.rows) spline.controls.insert(spline.controls.end(), row.begin(), row.end());
  return spline;
}

/// How far the surface misses sections by rounding, in their space.
/// @throws InvalidShape if that is more than is allowed
double miss_of(const LoftSections& sections, const RowSpline& spline, const Pace& pace, const LoftOptions& options) {
  constexpr double kMost = 0x1p-20;
  if (options.style == LoftStyle::loose) return 0.0;
  const double miss = largest_miss(sections, spline, pace.parameters);
  if (miss <= (options.tolerance ? *options.tolerance / sections.space.length(1.0) : kMost)) return miss;
  throw InvalidShape("between sections the surface would run off by " + short_text(farthest_control(spline)) +
                     " times their size, so that rounding would make it miss them by " +
                     short_text(sections.space.length(miss)) +
                     ": a lower degree, or parameters and knots more like the distances of the sections, have less of that");
}

/// @throws InvalidShape if weights that are all positive in the sections are not between them.
void require_weights(const LoftSections& sections, std::span<const glm::dvec4> controls, bool is_blend) {
  const bool are_positive = std::ranges::all_of(
      sections.rows, [](const SectionRow& row) { return have_positive_weights(row.points); });
  if (!are_positive || have_positive_weights(controls)) return;
  if (is_blend) {
    throw InvalidShape("the weights continue so differently from the sides that between them some would not stay positive: smaller "
                       "strengths, or a lower continuity, have less of that");
  }
  throw InvalidShape(
      "the weights of the sections differ so much that between them some would not stay positive: "
      "a straight or loose loft, or one within a tolerance, has no such trouble");
}

Approximation<NurbsPatch> lofted(std::span<const LoftSection> sections, const LoftOptions& options) {
  const LoftSections made = loft_sections(sections, options);
  const Pace pace = pace_along(made, options);
  const RowSpline spline = spline_along(made, options, pace);
  const auto count_u = made.rows.front().points.size();
  const auto count_v = static_cast<std::size_t>(spline.knots.count());
  std::vector<glm::dvec4> near(count_u * count_v);
  for (std::size_t j = 0; j < count_v; ++j) {
    for (std::size_t i = 0; i < count_u; ++i) {
      const double* const p = &spline.controls[4 * (j * count_u + i)];
      near[i * count_v + j] = as_given(glm::dvec4(p[0], p[1], p[2], p[3]));
    }
  }
  require_weights(made, near, sections.empty());
  const double miss = miss_of(made, spline, pace, options);
  std::vector<glm::dvec4> points = made.space.leave(near);
  const bool has_own_ends = options.closing == Closing::open;
  for (std::size_t i = 0; i < count_u && has_own_ends; ++i) {
    points[i * count_v] = made.rows.front().points[i];
    points[i * count_v + count_v - 1] = made.rows.back().points[i];
  }
  return {NurbsPatch::make(made.knots, spline.knots, std::move(points)), made.error + made.space.length(miss)};
}

}  // namespace

LoftSurface loft(std::span<const LoftSection> sections, const LoftOptions& options) {
  require_options(sections, options);
  return calm_loft(options, [&](const LoftOptions& calmer) { return lofted(sections, calmer); });
}

}  // namespace splinecore
