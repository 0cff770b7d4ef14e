#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "least_squares_fit.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// One direction of a plate.
struct PlateAxis {
  KnotVector knots;    ///< of a domain near 1
  double length;       ///< of the plate: what the domain stands for
  Held held;           ///< rows of control points that stay; none of periodic knots
};

/// A symmetric matrix of functions that share a span: in row i those with i - degree to i + degree, around a period.
struct PlateBand {
  std::vector<double> values;
  std::size_t width;

  double at(std::size_t i, std::size_t k) const noexcept { return values[i * width + k]; }
};

/// What a direction of a plate knows of its functions: means of products of their derivatives of orders 0, 1 and 2.
///
/// A derivative's control points are differences (The NURBS Book, §3.3), and so each mean of products is one of
/// functions of a lower degree between differences. Where knots lie near each other the numbers of its matrix are so
/// large that rounding them is as if a plane were bent; differences of control points are not.
struct PlateDirection {
  PlateDirection(const PlateAxis& axis, bool is_outer);

  std::size_t free() const noexcept { return count - held.start - held.end; }
  bool is_held(std::size_t i) const noexcept { return i < held.start || i >= count - held.end; }
  std::size_t partner(std::size_t i, std::size_t k) const noexcept { return (i + k + count - degree) % count; }
  bool has(std::size_t i, std::size_t k) const noexcept {
    return is_periodic || (i + k >= degree && i + k < count + degree);
  }
  std::size_t place(std::size_t i) const noexcept;
  std::size_t next(std::size_t i) const noexcept { return i + 1 < count ? i + 1 : 0; }
  std::size_t previous(std::size_t i) const noexcept { return i > 0 ? i - 1 : count - 1; }

  std::size_t count;
  std::size_t degree;
  bool is_periodic;
  bool is_folded;           ///< a period's functions in the order 0, n - 1, 1, n - 2, …: neighbours stay near
  Held held;
  std::array<PlateBand, 3> bands;            ///< of derivatives 0, 1 and 2
  std::array<PlateBand, 3> masses;           ///< the same between control points of the derivatives
  std::array<std::vector<double>, 2> steps;  ///< control point i of the next derivative, beside i less i - 1 of this one
};

}  // namespace splinecore
#pragma GCC visibility pop
