#include "second_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/quotient.hpp"

namespace splinecore {

namespace {

/// Squared, so that a root is drawn of the largest alone.
double size_of(const glm::dvec3& difference) { return glm::dot(difference, difference); }
double size_of(double difference) { return difference * difference; }

/// The largest of the differences of a net, first and second ones, as those of the polynomial's derivatives.
struct NetDifferences {
  double u = 0.0;
  double v = 0.0;
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
};

/// The size that is largest of `count` values.
template <class At>
double largest_of(std::size_t count, At at) {
  double found = 0.0;
  for (std::size_t k = 0; k < count; ++k) found = std::max(found, size_of(at(k)));
  return std::sqrt(found);
}

/// The same over a lattice of rows.
template <class At>
double largest_of(std::size_t rows, std::size_t columns, At at) {
  double found = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) found = std::max(found, size_of(at(i, j)));
  }
  return std::sqrt(found);
}

template <class Value>
void add_second_differences(const Value* p, std::size_t rows, std::size_t columns, NetDifferences& found) {
  const auto m = static_cast<double>(rows - 1);
  const auto n = static_cast<double>(columns - 1);
  if (rows > 2) {
    found.uu = m * (m - 1) * largest_of((rows - 2) * columns, [&](std::size_t k) {
                 return p[k + 2 * columns] - 2.0 * p[k + columns] + p[k];
               });
  }
  if (rows > 1 && columns > 1) {
    found.uv = m * n * largest_of(rows - 1, columns - 1, [&](std::size_t i, std::size_t j) {
                 const Value* at = p + i * columns + j;
                 return at[columns + 1] - at[columns] - at[1] + at[0];
               });
  }
  if (columns > 2) {
    found.vv = n * (n - 1) * largest_of(rows, columns - 2, [&](std::size_t i, std::size_t j) {
                 const Value* at = p + i * columns + j;
                 return at[2] - 2.0 * at[1] + at[0];
               });
  }
}

template <class Value>
void add_first_differences(const Value* p, std::size_t rows, std::size_t columns, NetDifferences& found) {
  const auto m = static_cast<double>(rows - 1);
  const auto n = static_cast<double>(columns - 1);
  if (rows > 1) found.u = m * largest_of((rows - 1) * columns, [&](std::size_t k) { return p[k + columns] - p[k]; });
  if (columns > 1) {
    found.v = n * largest_of(rows, columns - 1, [&](std::size_t i, std::size_t j) {
                const Value* at = p + i * columns + j;
                return at[1] - at[0];
              });
  }
}

/// What bounds are at most where all weights are above 0: four of them have a sum.
constexpr double kLargestBound = 1e300;

}  // namespace

void PieceBounds::center(const glm::dvec4* points, std::size_t count, std::size_t middle, Centered& seen) const {
  seen.points.resize(count);
  const glm::dvec3 origin = project(points[middle]);
  if (!rational_) {
    for (std::size_t k = 0; k < count; ++k) seen.points[k] = glm::dvec3(points[k]) - origin;
    return;
  }
  seen.weights.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    seen.points[k] = glm::dvec3(points[k]) - points[k].w * origin;
    seen.weights[k] = points[k].w;
  }
  seen.least = std::ranges::min(seen.weights);
}

/// Bounds for coordinates, or for heights, with the weights of a piece.
template <class Value>
SecondDerivativeBounds PieceBounds::bounds_of(const Value* values, const Centered& seen, std::size_t rows,
                                              std::size_t columns) const {
  NetDifferences point;
  add_second_differences(values, rows, columns, point);
  if (!rational_) return {point.uu, point.uv, point.vv};
  const double least = seen.least;
  NetDifferences weight;
  add_first_differences(values, rows, columns, point);
  add_first_differences(seen.weights.data(), rows, columns, weight);
  add_second_differences(seen.weights.data(), rows, columns, weight);
  double reach = 0.0;
  for (std::size_t k = 0; k < rows * columns; ++k) {
    reach = std::max(reach, size_of(values[k] / seen.weights[k]));
  }
  reach = std::sqrt(reach);
  // The quotient rule, term by term: S_uu = (A_uu - 2 W_u S_u - W_uu S) / W.
  const double su = (point.u + weight.u * reach) / least;
  const double sv = (point.v + weight.v * reach) / least;
  const auto finite = [](double bound) { return std::min(bound, kLargestBound); };
  return {finite((point.uu + 2.0 * weight.u * su + weight.uu * reach) / least),
          finite((point.uv + weight.u * sv + weight.v * su + weight.uv * reach) / least),
          finite((point.vv + 2.0 * weight.v * sv + weight.vv * reach) / least)};
}

SecondDerivativeBounds PieceBounds::bounds() {
  const std::size_t middle = piece_->rows / 2 * piece_->columns + piece_->columns / 2;
  center(piece_->values.data(), piece_->values.size(), middle, seen_);
  if (!(seen_.least > 0.0)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  return bounds_of(seen_.points.data(), seen_, piece_->rows, piece_->columns);
}

SecondDerivativeBounds PieceBounds::bounds_along(const glm::dvec3& normal) {
  heights_.resize(seen_.points.size());
  for (std::size_t k = 0; k < heights_.size(); ++k) heights_[k] = glm::dot(normal, seen_.points[k]);
  return bounds_of(heights_.data(), seen_, piece_->rows, piece_->columns);
}

double PieceBounds::side_distance(int side) {
  const std::size_t count = side < 2 ? piece_->columns : piece_->rows;
  const std::size_t at = side % 2 == 0 ? 0 : (side < 2 ? piece_->rows : piece_->columns) - 1;
  side_points_.resize(count);
  for (std::size_t k = 0; k < count; ++k) side_points_[k] = side < 2 ? piece_->at(at, k) : piece_->at(k, at);
  center(side_points_.data(), count, count / 2, side_);
  return bounds_of(side_.points.data(), side_, side < 2 ? 1 : count, side < 2 ? count : 1).distance();
}

}  // namespace splinecore
