#include "lines.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/given_points.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec4> line_of(std::span<const glm::dvec4> net, const Lines& lines, std::size_t line) {
  std::vector<glm::dvec4> points(lines.size);
  for (std::size_t i = 0; i < lines.size; ++i) points[i] = net[lines.at(line, i)];
  return points;
}

/// A line of homogeneous points after a verb.
struct HomogeneousLine {
  KnotVector knots;
  std::vector<glm::dvec4> points;
};

using Verb = std::function<NurbsCurve(const NurbsCurve&)>;

HomogeneousLine changed(const KnotVector& knots, std::vector<glm::dvec4> points, bool rational, const Verb& verb) {
  std::vector<glm::dvec4> weights;
  for (glm::dvec4& point : points) {
    weights.emplace_back(point.w, 0.0, 0.0, 1.0);
    point.w = 1.0;
  }
  const NurbsCurve places = verb(NurbsCurve::make(knots, std::move(points)));
  HomogeneousLine line{places.knot_vector(), {places.points().begin(), places.points().end()}};
  for (glm::dvec4& point : line.points) point.w = 1.0;
  if (!rational) return line;
  const NurbsCurve changed_weights = verb(NurbsCurve::make(knots, std::move(weights)));
  for (std::size_t i = 0; i < line.points.size(); ++i) line.points[i].w = changed_weights.points()[i].x;
  return line;
}

/// Gives the points of a line that are old ones the form in which those were given. They come in the old order.
/// @param wide  where the old homogeneous points lie
void keep_given(std::span<const glm::dvec4> old, const Lines& wide, std::span<const glm::dvec4> old_given,
                const Lines& old_lines, std::span<const glm::dvec4> points, std::span<glm::dvec4> given,
                const Lines& lines, std::size_t line) {
  const auto less = [](const glm::dvec4& a, const glm::dvec4& b) {
    return std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
  };
  std::vector<std::size_t> order(old_lines.size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto at = [&](std::size_t j) -> const glm::dvec4& { return old[wide.at(line, j)]; };
  std::ranges::stable_sort(order, less, at);
  std::size_t expected = 0;
  for (std::size_t i = 0; i < lines.size; ++i) {
    const auto equal = std::ranges::equal_range(order, points[lines.at(line, i)], less, at);
    if (equal.empty()) continue;
    // Of equal ones the next in the old order, or the first of all.
    const auto next = std::ranges::lower_bound(equal, expected);
    const std::size_t j = next == equal.end() ? equal.front() : *next;
    given[lines.at(line, i)] = old_given[old_lines.at(line, j)];
    expected = j + 1;
  }
}

}  // namespace

Lines lines_of(const NurbsPatch& patch, Axis axis) {
  return {axis, static_cast<std::size_t>(patch.count(across(axis))), static_cast<std::size_t>(patch.count(axis))};
}

Lines homogeneous_lines_of(const NurbsPatch& patch, Axis axis) {
  Lines lines = lines_of(patch, axis);
  (axis == Axis::u ? lines.step : lines.next) = patch.knot_vector(Axis::v).unrolled_count();
  return lines;
}

NurbsPatch with_axis(const NurbsPatch& patch, Axis axis, const KnotVector& knots, std::vector<glm::dvec4> points) {
  return axis == Axis::u ? NurbsPatch::make(knots, patch.knot_vector(Axis::v), std::move(points))
                         : NurbsPatch::make(patch.knot_vector(Axis::u), knots, std::move(points));
}

NurbsPatch applied(const PointMatrix& matrix, const NurbsPatch& patch, Axis axis) {
  const Lines old = lines_of(patch, axis);
  const Lines lines(axis, old.count, matrix.knots().count());
  const Lines wide = homogeneous_lines_of(patch, axis);
  const glm::dvec4* const old_points = patch.homogeneous_points().data();
  std::vector<glm::dvec4> points(lines.count * lines.size);
  for (std::size_t i = 0; i < lines.count; ++i) {
    matrix.apply(old_points + wide.at(i, 0), wide.step, points.data() + lines.at(i, 0), lines.step);
  }
  GivenPoints given = as_given_from(patch, points);
  for (std::size_t i = 0; i < lines.count; ++i) {
    matrix.keep_untouched(given.old.data() + old.at(i, 0), old.step, given.made.data() + lines.at(i, 0), lines.step);
  }
  return with_axis(patch, axis, matrix.knots(), std::move(given.made));
}

NurbsPatch selected(const NurbsPatch& patch, Axis axis, const Selection& selection) {
  const Lines old = lines_of(patch, axis);
  const Lines lines(axis, old.count, selection.indices.size());
  std::vector<glm::dvec4> points(lines.count * lines.size);
  for (std::size_t line = 0; line < lines.count; ++line) {
    for (std::size_t i = 0; i < lines.size; ++i) {
      points[lines.at(line, i)] = patch.points()[old.at(line, selection.indices[i])];
    }
  }
  return with_axis(patch, axis, selection.knots, std::move(points));
}

NurbsPatch cut(const NurbsPatch& patch, Axis axis, double u) {
  const std::vector<double> copies(missing_for_cut(patch.knot_vector(axis), u), u);
  return copies.empty() ? patch : refine(patch, axis, copies);
}

NurbsPatch along(const NurbsPatch& patch, Axis axis, const Verb& verb) {
  const Lines old = lines_of(patch, axis);
  const Lines wide = homogeneous_lines_of(patch, axis);
  const auto old_points = patch.homogeneous_points();
  std::optional<KnotVector> knots;
  std::vector<glm::dvec4> points;
  for (std::size_t i = 0; i < old.count; ++i) {
    breathe(100 * old.size);
    const HomogeneousLine after =
        changed(patch.knot_vector(axis), line_of(old_points, wide, i), patch.rational(), verb);
    const Lines lines(axis, old.count, after.points.size());
    points.resize(lines.count * lines.size);
    for (std::size_t k = 0; k < lines.size; ++k) points[lines.at(i, k)] = after.points[k];
    if (!knots) knots = after.knots;
  }
  GivenPoints given = as_given_from(patch, points);
  const Lines lines(axis, old.count, knots->count());
  for (std::size_t i = 0; i < lines.count; ++i) {
    keep_given(old_points, wide, given.old, old, points, given.made, lines, i);
  }
  return with_axis(patch, axis, *knots, std::move(given.made));
}

BezierPatch as_bezier(const NurbsPatch& patch) {
  return BezierPatch::make(patch.count(Axis::u), patch.count(Axis::v), {patch.points().begin(), patch.points().end()});
}

BezierCurve as_bezier(const NurbsCurve& line) { return BezierCurve::make({line.points().begin(), line.points().end()}); }

}  // namespace splinecore
