#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The squared distance of a piece from a point as a quotient of polynomials, |N|² / W² with N = X - W p, by their
/// Bernstein coefficients. For a number s, |N|² - s W² tells by its coefficients where the piece comes no nearer than
/// the square root of s (Johnson and Cohen 1998 use the like for lower bounds).
class DistanceForm {
 public:
  /// Pieces of so many control points along u and v; a curve has one column.
  DistanceForm(std::size_t rows, std::size_t columns);

  /// @param net  homogeneous control points, row after row
  void set(const glm::dvec4* net, const glm::dvec3& point) noexcept;

  /// Whether no coefficient of |N|² - s W² is below zero, rounding apart: no point of the piece is nearer.
  bool is_farther(double s) const noexcept;

  /// Whether |N|² - s W², which has a minimum of zero at a place in [0, 1]², is shown by its coefficients to be nowhere
  /// less, rounding apart: it is convex, or falls everywhere towards the sides on which the place lies, or of one
  /// parameter first falls and then rises. Then no point of the piece is nearer than the root of s.
  bool is_least(double s, double u, double v) noexcept;

 private:
  double rounding(double s) const noexcept;
  bool is_convex(double error) const noexcept;
  template <std::size_t kColumns>
  void set_row(const glm::dvec4* net, const glm::dvec3& point) noexcept;
  void set_rows(const glm::dvec4* net, const glm::dvec3& point) noexcept;
  void multiply_rows() noexcept;

  std::size_t rows_;
  std::size_t columns_;
  std::size_t stride_;  ///< of rows of control points: a multiple of four
  std::size_t width_;   ///< of rows of coefficients
  std::vector<double> choices_;  ///< binomials of control points, row after row
  std::vector<double> shares_;   ///< one over those of coefficients
  std::vector<double> scaled_;   ///< control points times their binomials, coordinate by coordinate
  std::vector<glm::dvec4> row_;  ///< those of a single row, point by point
  std::vector<double> squares_;  ///< coefficients of |N|²
  std::vector<double> weights_;  ///< and of W²
  std::vector<double> sums_;     ///< coefficients of |N|² - s W²
  double largest_square_ = 0.0;
  double largest_weight_ = 0.0;
};

}  // namespace splinecore
#pragma GCC visibility pop
