#include <algorithm>
#include <cmath>
#include <string>

#include "least_squares_fit.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/rebuild.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// One direction of a patch: its new knots, and where the old patch is looked at.
struct Direction {
  KnotVector knots;
  QuadratureNodes nodes;

  std::size_t count() const { return static_cast<std::size_t>(knots.count()); }
};

Direction direction_of(const NurbsPatch& patch, Axis axis, const RebuiltDirection& wanted) {
  constexpr int kMoreForQuotients = 8;
  const KnotVector& old = patch.knot_vector(axis);
  try {
    KnotVector knots = even_knots(wanted.degree, wanted.count, old.domain(), old.periodic());
    const int count = std::max(old.degree(), wanted.degree) + 1 + (patch.rational() ? kMoreForQuotients : 0);
    QuadratureNodes nodes = quadrature_nodes(breaks_of(old, knots), count, !old.periodic());
    return {std::move(knots), std::move(nodes)};
  } catch (const InvalidShape& error) {
    throw InvalidShape("along " + std::string(axis == Axis::u ? "u" : "v") + ": " + error.what());
  }
}

/// Control points for rows of values at the nodes, all columns at once; the ends are those of the values.
std::vector<double> solved(const Direction& direction, std::span<const double> values, std::size_t columns) {
  const bool is_open = !direction.knots.periodic();
  const Held held = is_open ? Held{1, 1} : Held{};
  const LeastSquaresFit fit(direction.knots, direction.nodes.parameters, direction.nodes.weights, {}, held);
  std::vector<double> controls;
  controls.reserve(direction.count() * columns);
  for (std::size_t i = 0; i < direction.count(); ++i) {
    const bool is_last = is_open && i + 1 == direction.count();
    const auto row = is_last ? values.last(columns) : values.first(columns);
    controls.insert(controls.end(), row.begin(), row.end());
  }
  fit.solve(values, columns, controls);
  return controls;
}

/// Rows and columns of points exchanged.
std::vector<double> transposed(std::span<const double> values, std::size_t rows, std::size_t columns) {
  std::vector<double> out(values.size());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) std::copy_n(&values[3 * (i * columns + j)], 3, &out[3 * (j * rows + i)]);
  }
  return out;
}

}  // namespace

Approximation<NurbsPatch> rebuild(const NurbsPatch& patch, const RebuiltDirection& u, const RebuiltDirection& v) {
  const Direction along_u = direction_of(patch, Axis::u, u);
  const Direction along_v = direction_of(patch, Axis::v, v);
  const std::size_t nodes_u = along_u.nodes.parameters.size();
  const std::size_t nodes_v = along_v.nodes.parameters.size();
  std::vector<double> values(3 * nodes_u * nodes_v);
  evaluate_grid(patch, along_u.nodes.parameters, along_v.nodes.parameters, std::span(values));
  const std::vector<double> rows = solved(along_u, values, 3 * nodes_v);
  const std::vector<double> columns = solved(along_v, transposed(rows, along_u.count(), nodes_v), 3 * along_u.count());
  const std::vector<double> controls = transposed(columns, along_v.count(), along_u.count());
  std::vector<glm::dvec4> points;
  points.reserve(along_u.count() * along_v.count());
  for (std::size_t i = 0; i < controls.size(); i += 3) {
    const glm::dvec3 point(controls[i], controls[i + 1], controls[i + 2]);
    require_control_point(point);
    points.emplace_back(point, 1.0);
  }
  NurbsPatch made = NurbsPatch::make(along_u.knots, along_v.knots, std::move(points));
  const double error = largest_distance(patch, made);
  if (!std::isfinite(error)) throw InvalidShape("a patch that runs to infinity cannot be rebuilt");
  return {std::move(made), error};
}

}  // namespace splinecore
