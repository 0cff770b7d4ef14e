#include "splinecore/surface/loft.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "base/length.hpp"
#include "base/positive_weights.hpp"
#include "base/quotient.hpp"
#include "fit/row_spline.hpp"
#include "going_on.hpp"
#include "kept_continuity.hpp"
#include "loft_sections.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/interpolate_patch.hpp"

namespace splinecore {

namespace {

bool is_smooth(LoftStyle style) { return style != LoftStyle::loose && style != LoftStyle::straight; }

bool is_free(const LoftEnd& end) { return !end.tangent && !end.flat && !end.neighbour; }

void require_end(const LoftEnd& end, bool is_at_pole, const char* name) {
  const std::string which = name;
  if (end.tangent.has_value() + end.flat.has_value() + end.neighbour.has_value() > 1) {
    throw InvalidShape("the " + which + " has more than one of tangent, flat and neighbour");
  }
  if (end.flat && !is_at_pole) throw InvalidShape("the " + which + " is flat: only a section that is a point can be");
  for (const auto& vector : {end.tangent, end.flat}) {
    if (vector && !(is_finite(*vector) && length_of(*vector) > 0.0)) {
      throw InvalidShape("the tangent or normal at the " + which + " has no direction");
    }
  }
  if (!end.neighbour) return;
  const LoftNeighbour& neighbour = *end.neighbour;
  if (neighbour.continuity < 0 || neighbour.continuity > 3) {
    throw InvalidShape("continuity " + std::to_string(neighbour.continuity) + " at the " + which + ": 0 to 3 is expected");
  }
  if (!(neighbour.strength > 0.0 && std::isfinite(neighbour.strength))) {
    throw InvalidShape("strength = " + text_of(neighbour.strength) + " at the " + which + ": above 0 is expected");
  }
}

void require_options(std::span<const LoftSection> sections, const LoftOptions& options) {
  const std::size_t count =
      sections.size() + options.start.neighbour.has_value() + options.end.neighbour.has_value();
  const std::size_t least = options.closing == Closing::closed ? 3 : 2;
  if (count < least) {
    throw InvalidShape("a loft of " + std::to_string(count) + " sections: at least " + std::to_string(least) + " are needed");
  }
  const auto is_pole = [](const LoftSection& section) { return std::holds_alternative<glm::dvec3>(section); };
  require_end(options.start, !sections.empty() && is_pole(sections.front()), "start");
  require_end(options.end, !sections.empty() && is_pole(sections.back()), "end");
  if (is_free(options.start) && is_free(options.end)) return;
  if (options.closing == Closing::closed) throw InvalidShape("a closed loft has no start and no end");
  if (!is_smooth(options.style)) throw InvalidShape("a loose or straight loft goes on from nothing: it has no tangents at its ends");
}

/// Points of all sections at parameters where all are in sight: a grid, u by sections.
std::vector<glm::dvec3> grid_of(const LoftSections& sections) {
  constexpr int kPlaces = 64;
  const Interval domain = sections.knots.domain();
  std::vector<double> at(kPlaces);
  for (int k = 0; k < kPlaces; ++k) at[k] = domain.start + domain.length() * (k + 0.5) / kPlaces;
  const std::size_t count = sections.rows.size();
  std::vector<glm::dvec3> points(kPlaces * count);
  for (std::size_t j = 0; j < count; ++j) {
    const NurbsCurve curve = NurbsCurve::from_homogeneous(sections.knots, sections.rows[j].near);
    std::vector<glm::dvec3> line(kPlaces);
    evaluate(curve, at, {&line.front().x, 3 * line.size()}, {.at_infinity = AtInfinity::nan});
    for (int k = 0; k < kPlaces; ++k) points[k * count + j] = line[k];
  }
  std::vector<glm::dvec3> in_sight;
  for (int k = 0; k < kPlaces; ++k) {
    const auto line = std::span(points).subspan(k * count, count);
    if (std::ranges::all_of(line, [](const glm::dvec3& p) { return is_finite(p); })) {
      in_sight.insert(in_sight.end(), line.begin(), line.end());
    }
  }
  if (in_sight.empty()) throw InvalidShape("the sections are nowhere in sight together");
  return in_sight;
}

Parametrisation parametrisation_of(LoftStyle style) {
  if (style == LoftStyle::tight) return Parametrisation::centripetal;
  return style == LoftStyle::uniform ? Parametrisation::uniform : Parametrisation::chordal;
}

/// Parameters along v, and how fast points then run on average.
struct Pace {
  std::vector<double> parameters;
  double speed;

  double step_at(bool is_end) const {
    return is_end ? parameters.back() - *(parameters.end() - 2) : parameters[1] - parameters[0];
  }
};

Pace pace_along(const LoftSections& sections, const LoftOptions& options) {
  const std::vector<glm::dvec3> points = grid_of(sections);
  const PointGrid grid{points, points.size() / sections.rows.size(), sections.rows.size()};
  const auto parameters = [&](Parametrisation kind) { return parameters_of(grid, Axis::v, kind, options.closing); };
  Pace pace{options.parameters, 0.0};
  try {
    const double length = parameters(Parametrisation::chordal).back();
    if (pace.parameters.empty()) {
      pace.parameters = parameters(parametrisation_of(options.style));
      const double last = pace.parameters.back();
      for (double& parameter : pace.parameters) parameter /= last;
    }
    pace.speed = length / (pace.parameters.back() - pace.parameters.front());
  } catch (const InvalidShape&) {
    throw InvalidShape("two sections that follow each other are one");
  }
  return pace;
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
  if (!(sum > 0.0)) throw InvalidShape("a pole cannot be flat: the section beside it lies along the normal");
  return scaled(1.0 / sum, std::move(found));
}

/// Derivatives along v at an end, of the homogeneous rows.
/// @param speed  elsewhere; below 0 at the end, where v leads to it
/// @param step   of v to the next section
std::vector<std::vector<double>> leaving(const LoftEnd& end, const LeavingRows& out, const SectionRow& own,
                                         const SectionRow& beside, double speed, double step) {
  constexpr double kRoom = 0.25;
  if (end.tangent) return {numbers_of(scaled(std::abs(speed), weighted(own.near, *end.tangent)))};
  if (end.flat) return {numbers_of(scaled(speed, along_plane(own, beside, *end.flat)))};
  std::vector<std::vector<double>> rows;
  if (out.empty()) return rows;
  const double given = speed_of(own.near, out[0]);
  if (!(given > 0.0)) throw InvalidShape("a neighbour stands still across its side: nothing goes on from there");
  const double pace = end.neighbour->strength * speed / given;
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

RowSpline spline_along(const LoftSections& sections, const LoftOptions& options) {
  const Pace pace = pace_along(sections, options);
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

/// @throws InvalidShape if weights that are all positive in the sections are not between them.
void require_weights(const LoftSections& sections, std::span<const glm::dvec4> controls, bool is_blend) {
  const bool are_positive = std::ranges::all_of(
      sections.rows, [](const SectionRow& row) { return have_positive_weights(row.points); });
  if (!are_positive || have_positive_weights(controls)) return;
  if (is_blend) {
    throw InvalidShape("the weights of the sides go on so differently that between them some would not stay positive: smaller "
                       "strengths, or a lower continuity, have less of that");
  }
  throw InvalidShape(
      "the weights of the sections differ so much that between them some would not stay positive: "
      "a straight or loose loft, or one within a tolerance, has no such trouble");
}

}  // namespace

Approximation<NurbsPatch> loft(std::span<const LoftSection> sections, const LoftOptions& options) {
  require_options(sections, options);
  const LoftSections made = loft_sections(sections, options);
  const RowSpline spline = spline_along(made, options);
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
  std::vector<glm::dvec4> points = made.space.leave(near);
  const bool has_own_ends = options.closing == Closing::open;
  for (std::size_t i = 0; i < count_u && has_own_ends; ++i) {
    points[i * count_v] = made.rows.front().points[i];
    points[i * count_v + count_v - 1] = made.rows.back().points[i];
  }
  return {NurbsPatch::make(made.knots, spline.knots, std::move(points)), made.error};
}

NurbsPatch blend(const LoftNeighbour& from, const LoftNeighbour& to, bool is_aligned) {
  LoftOptions options;
  options.is_aligned = is_aligned;
  options.start.neighbour = from;
  options.end.neighbour = to;
  NurbsPatch made = loft({}, options).value;
  require_continuity(made, Border::v_start, from, "the first patch");
  require_continuity(made, Border::v_end, to, "the second patch");
  return made;
}

}  // namespace splinecore
