#include "power.hpp"

namespace splinecore {

namespace {

/// One coordinate of all rows.
using Column = std::vector<DoubleDouble>;

/// The rows with work(column) done to each of their four coordinates.
template <class Work>
std::vector<glm::dvec4> by_column(std::span<const glm::dvec4> rows, Work work) {
  std::vector<glm::dvec4> result(rows.size());
  for (int axis = 0; axis < 4; ++axis) {
    Column column;
    for (const glm::dvec4& row : rows) column.emplace_back(row[axis]);
    work(column);
    for (std::size_t i = 0; i < rows.size(); ++i) result[i][axis] = column[i].rounded();
  }
  return result;
}

void shift_column(Column& c, const DoubleDouble& shift) {
  const std::size_t degree = c.size() - 1;
  for (std::size_t done = 0; done < degree; ++done) {
    for (std::size_t k = degree; k-- > done;) c[k] = c[k] + shift * c[k + 1];
  }
}

/// Forward differences of the first value, order by order, in place of values.
void take_differences(Column& c) {
  const std::size_t degree = c.size() - 1;
  for (std::size_t level = 0; level < degree; ++level) {
    for (std::size_t k = degree; k-- > level;) c[k + 1] = c[k + 1] - c[k];
  }
}

/// The inverse of take_differences().
void sum_differences(Column& c) {
  const std::size_t degree = c.size() - 1;
  for (std::size_t level = degree; level-- > 0;) {
    for (std::size_t k = level; k < degree; ++k) c[k + 1] = c[k + 1] + c[k];
  }
}

/// length^k / C(degree, k) for each k: a Taylor coefficient times it is a difference of Bernstein ones.
Column difference_factors(std::size_t count, const DoubleDouble& length) {
  Column factors(count, 1.0);
  for (std::size_t k = 1; k < count; ++k) {
    const DoubleDouble ratio = DoubleDouble(static_cast<double>(k)) / static_cast<double>(count - k);
    factors[k] = factors[k - 1] * length * ratio;
  }
  return factors;
}

}  // namespace

std::vector<glm::dvec4> taylor_shifted(std::span<const glm::dvec4> coefficients, const DoubleDouble& shift) {
  if (shift.high == 0.0) return {coefficients.begin(), coefficients.end()};
  return by_column(coefficients, [&](Column& column) { shift_column(column, shift); });
}

std::vector<glm::dvec4> power_to_bernstein(std::span<const glm::dvec4> coefficients, double origin, Interval range) {
  const DoubleDouble shift = exact_sum(range.start, -origin);
  const Column factors = difference_factors(coefficients.size(), exact_sum(range.end, -range.start));
  return by_column(coefficients, [&](Column& column) {
    shift_column(column, shift);
    for (std::size_t k = 0; k < column.size(); ++k) column[k] = column[k] * factors[k];
    sum_differences(column);
  });
}

std::vector<glm::dvec4> bernstein_to_power(std::span<const glm::dvec4> points, Interval range, double origin) {
  const DoubleDouble shift = exact_sum(origin, -range.start);
  const Column factors = difference_factors(points.size(), exact_sum(range.end, -range.start));
  return by_column(points, [&](Column& column) {
    take_differences(column);
    for (std::size_t k = 0; k < column.size(); ++k) column[k] = column[k] / factors[k];
    shift_column(column, shift);
  });
}

}  // namespace splinecore
