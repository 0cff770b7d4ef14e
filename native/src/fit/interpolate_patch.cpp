#include "splinecore/fit/interpolate_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "along.hpp"
#include "base/length.hpp"
#include "grid.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// Of an evaluation: beside the largest coordinate.
constexpr double kAccurateGrid = 1e-13;

constexpr std::size_t kNoPoint = std::numeric_limits<std::size_t>::max();

/// The system of one direction; all lines of points along it are right sides.
struct DirectionSystem {
  KnotVector knots;
  BandedRows rows;
  std::vector<std::size_t> points;  ///< of each row; of rows that ask for a derivative of zero none
};

InterpolationOptions options_of(const FitDirection& direction) {
  InterpolationOptions options;
  options.degree = direction.degree;
  options.closing = direction.closing;
  options.ends = direction.ends;
  options.knots = direction.knots;
  return options;
}

DirectionSystem direction_of(const FitDirection& given, std::size_t count) {
  const std::vector<glm::dvec3> places(count, glm::dvec3(0.0));
  const InterpolationOptions options = options_of(given);
  require_interpolation(count, given.parameters, options);
  const std::vector<Condition> conditions = conditions_of(places, given.parameters, options);
  KnotVector knots = knots_for(sites_of(conditions), given.parameters, options);
  BandedRows rows = system_of(knots, conditions).rows;
  DirectionSystem made{std::move(knots), std::move(rows), {}};
  for (const Condition& condition : conditions) {
    made.points.push_back(condition.order == 0 ? condition.point : kNoPoint);
  }
  return made;
}

/// The grid's rows as right sides along u: control points along u, for each point along v.
std::vector<glm::dvec3> solved_along_u(const PointGrid& grid, const DirectionSystem& u) {
  const std::size_t width = grid.count_v;
  std::vector<glm::dvec3> values(u.points.size() * width, glm::dvec3(0.0));
  for (std::size_t i = 0; i < u.points.size(); ++i) {
    if (u.points[i] != kNoPoint) std::ranges::copy(grid.points.subspan(u.points[i] * width, width), &values[i * width]);
  }
  solve(u.knots, u.rows, {&values.front().x, 3 * values.size()}, 3 * width);
  return values;
}

/// Solves along v for some columns of points along u at a time, which lie side by side meanwhile and stay near.
std::vector<glm::dvec4> control_points(const PointGrid& grid, const DirectionSystem& u, const DirectionSystem& v) {
  const std::vector<glm::dvec3> along_u = solved_along_u(grid, u);
  const std::size_t count_u = u.points.size();
  const std::size_t count_v = v.points.size();
  constexpr std::size_t kTogether = 64;
  std::vector<glm::dvec4> points(count_u * count_v);
  std::vector<glm::dvec3> values(count_v * std::min(count_u, kTogether));
  for (std::size_t first = 0; first < count_u; first += kTogether) {
    const std::size_t number = std::min(kTogether, count_u - first);
    for (std::size_t i = 0; i < number; ++i) {
      for (std::size_t j = 0; j < count_v; ++j) {
        const std::size_t from = v.points[j];
        values[j * number + i] = from == kNoPoint ? glm::dvec3(0.0) : along_u[(first + i) * grid.count_v + from];
      }
    }
    solve(v.knots, v.rows, {&values.front().x, 3 * count_v * number}, 3 * number);
    for (std::size_t i = 0; i < number; ++i) {
      for (std::size_t j = 0; j < count_v; ++j) {
        require_control_point(values[j * number + i]);
        points[(first + i) * count_v + j] = {values[j * number + i], 1.0};
      }
    }
  }
  return points;
}

/// Of the patch from its points: its rows where it passes those of the grid, then their points.
double largest_distance(const NurbsPatch& patch, const PointGrid& grid, const DirectionSystem& u,
                        const DirectionSystem& v) {
  const std::size_t count_u = u.points.size();
  const std::size_t count_v = v.points.size();
  std::vector<glm::dvec3> line(count_v);
  double largest = 0.0;
  for (std::size_t a = 0; a < count_u; ++a) {
    if (u.points[a] == kNoPoint) continue;
    breathe(4 * (u.rows.width + v.rows.width) * count_v);
    std::ranges::fill(line, glm::dvec3(0.0));
    for (std::size_t k = 0; k < u.rows.width; ++k) {
      const glm::dvec4* const row = &patch.points()[(u.rows.first[a] + k) % count_u * count_v];
      const double weight = u.rows.row(a)[k];
      for (std::size_t j = 0; j < count_v && weight != 0.0; ++j) line[j] += weight * glm::dvec3(row[j]);
    }
    for (std::size_t b = 0; b < count_v; ++b) {
      if (v.points[b] == kNoPoint) continue;
      glm::dvec3 point(0.0);
      std::size_t j = static_cast<std::size_t>(v.rows.first[b]) % count_v;
      for (const double weight : v.rows.row(b)) {
        point += weight * line[j];
        if (++j == count_v) j = 0;
      }
      largest = std::max(largest, distance_of(point, grid.points[u.points[a] * grid.count_v + v.points[b]]));
    }
  }
  return largest;
}

/// The same as the patch is evaluated, row after row.
double measured_distance(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u,
                         std::span<const double> v) {
  std::vector<glm::dvec3> row(grid.count_v);
  double largest = 0.0;
  for (std::size_t i = 0; i < grid.count_u; ++i) {
    evaluate_grid(patch, u.subspan(i, 1), v.first(grid.count_v), {&row.front().x, 3 * row.size()});
    for (std::size_t j = 0; j < row.size(); ++j) {
      largest = std::max(largest, distance_of(row[j], grid.points[i * grid.count_v + j]));
    }
  }
  return largest;
}

}  // namespace

Approximation<NurbsPatch> interpolate(const PointGrid& grid, const FitDirection& u, const FitDirection& v) {
  require_grid(grid);
  const DirectionSystem along_u = along("u", [&] { return direction_of(u, grid.count_u); });
  const DirectionSystem along_v = along("v", [&] { return direction_of(v, grid.count_v); });
  NurbsPatch patch = NurbsPatch::make(along_u.knots, along_v.knots, control_points(grid, along_u, along_v));
  const double largest = largest_coordinate(grid.points);
  double error = largest_distance(patch, grid, along_u, along_v);
  const double measured = measured_distance(patch, grid, u.parameters, v.parameters);
  // Less than that is left by the evaluation itself.
  if (!(measured <= kAccurateGrid * largest)) error = std::max(error, measured);
  require_passing(error, largest);
  return {std::move(patch), error};
}

}  // namespace splinecore
