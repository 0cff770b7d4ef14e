#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// One direction of a patch that is to be near a grid of values.
struct FittedAxis {
  KnotVector knots;
  std::vector<double> parameters;  ///< of the rows of values, in order, in the domain
  std::vector<double> weights;     ///< of their squares; empty: 1 each
  double smoothing = 0.0;
  bool fixed_ends = true;          ///< if plain: the first and last control points are the first and last values

  std::size_t count() const { return static_cast<std::size_t>(knots.count()); }
};

/// Control points for rows of values at the parameters, `columns` numbers each, all columns at once.
std::vector<double> fitted_rows(const FittedAxis& axis, std::span<const double> values, std::size_t columns);

/// Control points of weight 1 for three numbers at each pair of parameters, first along u, then along v.
std::vector<glm::dvec4> tensor_fit(const FittedAxis& u, const FittedAxis& v, std::span<const double> values);

/// Rows and columns of points exchanged.
std::vector<double> transposed(std::span<const double> values, std::size_t rows, std::size_t columns);

}  // namespace splinecore
#pragma GCC visibility pop
