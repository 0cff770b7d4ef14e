#include "rows_beside.hpp"

#include <cstddef>

#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

std::vector<std::vector<glm::dvec3>> rows_beside(const KnotVector& knots, const KnotVector& inwards,
                                                 const std::vector<std::vector<glm::dvec3>>& across) {
  const std::size_t orders = across.size();
  RowConditions given{interpolation_places(knots), std::vector<std::vector<double>>(across.front().size()), {}, {}};
  for (const auto& values : across) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      given.rows[i].insert(given.rows[i].end(), {values[i].x, values[i].y, values[i].z});
    }
  }
  const RowSpline spline = spline_through(given, knots.degree(), Closing::open, {knots.knots().begin(), knots.knots().end()});
  const double start[] = {inwards.domain().start};
  const Samples at_start = Samples::make(inwards, start, static_cast<int>(orders) - 1);
  std::vector<std::vector<glm::dvec3>> rows;
  for (std::size_t order = 0; order < orders; ++order) {
    const auto weights = at_start.weights(0, static_cast<int>(order));
    std::vector<glm::dvec3> row;
    for (std::size_t i = 0; i < given.rows.size(); ++i) {
      const double* const p = &spline.controls[3 * (i * orders + order)];
      glm::dvec3 point(p[0], p[1], p[2]);
      for (std::size_t j = 0; j < order; ++j) point -= weights[j] * rows[j][i];
      row.push_back(point / weights[order]);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace splinecore
