#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "derivative_products.hpp"
#include "held.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// One direction of a plate.
struct PlateAxis {
  KnotVector knots;    ///< of a domain near 1
  double length;       ///< of the plate: what the domain stands for
  Held held;           ///< rows of control points that stay; none of periodic knots
};

/// What a direction of a plate knows of its functions: means of products of their derivatives of orders 0, 1 and 2, and
/// the same between the differences that are control points of derivatives.
struct PlateDirection {
  PlateDirection(const PlateAxis& axis, bool is_outer);

  std::size_t free() const noexcept { return count - held.start - held.end; }
  bool is_held(std::size_t i) const noexcept { return i < held.start || i >= count - held.end; }
  std::size_t partner(std::size_t i, std::size_t k) const noexcept { return bands[0].partner(i, k); }
  bool has(std::size_t i, std::size_t k) const noexcept { return bands[0].has(i, k); }
  std::size_t place(std::size_t i) const noexcept;

  std::size_t count;
  bool is_folded;           ///< a period's functions in the order 0, n - 1, 1, n - 2, …: neighbors stay near
  Held held;
  std::array<ProductBand, 3> bands;          ///< of derivatives 0, 1 and 2
  std::array<ProductBand, 3> masses;         ///< the same between control points of the derivatives
  std::array<std::vector<double>, 2> steps;  ///< control point i of the next derivative, beside i less i - 1 of this one
};

}  // namespace splinecore
#pragma GCC visibility pop
