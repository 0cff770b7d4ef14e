#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "splinecore/base/axis.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Bernstein coefficients of a polynomial piece over [0, 1]², row after row, rows along u: of a patch, of its weight,
/// of a derivative. Those of a curve are one column.
template <class Value>
struct BernsteinNet {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Value> values;

  static BernsteinNet of_curve(std::vector<Value> points) {
    const std::size_t count = points.size();
    return {count, 1, std::move(points)};
  }

  std::size_t count(Axis axis) const noexcept { return axis == Axis::u ? rows : columns; }
  int degree(Axis axis) const noexcept { return static_cast<int>(count(axis)) - 1; }

  const Value& at(std::size_t i, std::size_t j) const noexcept { return values[i * columns + j]; }
  Value& at(std::size_t i, std::size_t j) noexcept { return values[i * columns + j]; }

  /// At the four corners of the piece it has the values itself.
  std::array<Value, 4> corners() const {
    return {values.front(), values[columns - 1], values[values.size() - columns], values.back()};
  }

  /// De Casteljau at a parameter: the part before it stays, `after` takes the other one, in the memory that it has.
  void cut(Axis axis, double t, BernsteinNet& after);

  /// The same at the middle.
  void halve(Axis axis, BernsteinNet& second) { cut(axis, 0.5, second); }

  /// The first derivative along a direction, of one degree less.
  BernsteinNet derivative(Axis axis) const;

  /// Between which numbers the values of the piece lie (hull property).
  template <class Projection = std::identity>
  std::pair<double, double> range(Projection projection = {}) const {
    const auto [low, high] = std::ranges::minmax(values, {}, projection);
    return {std::invoke(projection, low), std::invoke(projection, high)};
  }

  friend bool operator==(const BernsteinNet&, const BernsteinNet&) = default;
};

extern template struct BernsteinNet<double>;
extern template struct BernsteinNet<glm::dvec2>;
extern template struct BernsteinNet<glm::dvec3>;
extern template struct BernsteinNet<glm::dvec4>;

/// The weights of a homogeneous piece.
BernsteinNet<double> weights_of(const BernsteinNet<glm::dvec4>& piece);

/// The piece of a curve on one of the spans of its knots.
/// @param points  homogeneous, unrolled
BernsteinNet<glm::dvec4> bezier_piece(const KnotVector& knots, int span, const glm::dvec4* points);

/// Writes its degree + 1 values.
void write_bezier_piece(const KnotVector& knots, int span, const glm::dvec4* points, glm::dvec4* out);

/// The same of the degree + 1 points alone that the piece depends on.
void write_bezier_piece(const SquareRows& matrix, const glm::dvec4* points, glm::dvec4* out);

/// The piece of a patch on one of the spans of each of its knot vectors.
/// @param points  homogeneous, unrolled, row after row
BernsteinNet<glm::dvec4> bezier_piece(const KnotVector& knots_u, int span_u, const KnotVector& knots_v, int span_v,
                                      const glm::dvec4* points);

/// The same of the points alone that it depends on.
/// @param width  from one row of them to the next
BernsteinNet<glm::dvec4> bezier_piece(const SquareRows& matrix_u, const SquareRows& matrix_v, const glm::dvec4* points,
                                      std::size_t width);

}  // namespace splinecore
#pragma GCC visibility pop
