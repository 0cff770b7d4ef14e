#include "tensor_fit.hpp"

#include <algorithm>

#include "along.hpp"
#include "least_squares_fit.hpp"
#include "system.hpp"

namespace splinecore {

std::vector<double> fitted_rows(const FittedAxis& axis, std::span<const double> values, std::size_t columns) {
  const bool holds_ends = axis.fixed_ends && !axis.knots.periodic();
  const Held held = holds_ends ? Held{1, 1} : Held{};
  const LeastSquaresFit fit(axis.knots, axis.parameters, axis.weights, axis.smoothing, held);
  std::vector<double> controls;
  controls.reserve(axis.count() * columns);
  for (std::size_t i = 0; i < axis.count(); ++i) {
    const bool is_last = holds_ends && i + 1 == axis.count();
    const auto row = is_last ? values.last(columns) : values.first(columns);
    controls.insert(controls.end(), row.begin(), row.end());
  }
  fit.solve(values, columns, controls);
  return controls;
}

std::vector<double> transposed(std::span<const double> values, std::size_t rows, std::size_t columns) {
  std::vector<double> out(values.size());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) std::copy_n(&values[3 * (i * columns + j)], 3, &out[3 * (j * rows + i)]);
  }
  return out;
}

std::vector<glm::dvec4> tensor_fit(const FittedAxis& u, const FittedAxis& v, std::span<const double> values) {
  const std::size_t width = v.parameters.size();
  const std::vector<double> rows = along("u", [&] { return fitted_rows(u, values, 3 * width); });
  const std::vector<double> columns =
      along("v", [&] { return fitted_rows(v, transposed(rows, u.count(), width), 3 * u.count()); });
  const std::vector<double> controls = transposed(columns, v.count(), u.count());
  std::vector<glm::dvec4> points;
  points.reserve(u.count() * v.count());
  for (std::size_t i = 0; i < controls.size(); i += 3) {
    const glm::dvec3 point(controls[i], controls[i + 1], controls[i + 2]);
    require_control_point(point);
    points.emplace_back(point, 1.0);
  }
  return points;
}

}  // namespace splinecore
