#include "edge_rows.hpp"

#include <algorithm>

#include "lines.hpp"

namespace splinecore {

namespace {

/// Where point (row, column) of a net lies, rows counted from a side.
class EdgePlaces {
 public:
  EdgePlaces(const NurbsPatch& patch, Border side)
      : lines_(lines_of(patch, axis_of(side))), is_at_end_(is_at_end(side)) {}

  int rows() const { return static_cast<int>(lines_.size); }
  std::size_t at(int row, std::size_t column) const {
    return lines_.at(column, is_at_end_ ? lines_.size - 1 - row : row);
  }

 private:
  Lines lines_;
  bool is_at_end_;
};

/// From the side to knot number `i` beyond it.
double step_to(const KnotVector& knots, Border side, int i) {
  const auto all = knots.knots();
  const std::size_t place = knots.degree() + i;
  return is_at_end(side) ? all.back() - all[all.size() - 1 - place] : all[place] - all.front();
}

}  // namespace

double first_step(const NurbsPatch& patch, Border side) { return step_to(patch.knot_vector(axis_of(side)), side, 1); }

EdgeRows edge_rows(const NurbsPatch& patch, Border side, const std::vector<std::size_t>& columns, Heading heading,
                   double unit) {
  const EdgePlaces places(patch, side);
  EdgeRows found;
  for (int row = 0; row < std::min(kMostRows, places.rows()); ++row) {
    for (const std::size_t column : columns) found.rows[row].push_back(patch.points()[places.at(row, column)]);
  }
  const KnotVector& knots = patch.knot_vector(axis_of(side));
  const double degree = knots.degree();
  const double sign = heading == Heading::into_patch ? 1.0 : -1.0;
  const double first = degree / (step_to(knots, side, 1) / unit);
  found.coefficients[0] = {1.0, 0.0, 0.0};
  found.coefficients[1] = {-sign * first, sign * first, 0.0};
  if (knots.degree() < 2) return found;
  // The difference quotients of the first two derivative points (The NURBS Book, eq. 3.4 and 3.8).
  const double second = degree / (step_to(knots, side, 2) / unit);
  const double bend = (degree - 1.0) / (step_to(knots, side, 1) / unit);
  found.coefficients[2] = {bend * first, -bend * (first + second), bend * second};
  return found;
}

NurbsPatch with_edge_rows(const NurbsPatch& patch, Border side, const std::vector<std::size_t>& columns,
                          const EdgeRows& rows, int count) {
  const EdgePlaces places(patch, side);
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (int row = 0; row < count; ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) points[places.at(row, columns[i])] = rows.rows[row][i];
  }
  return patch.with_points(std::move(points));
}

}  // namespace splinecore
