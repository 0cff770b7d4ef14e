#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "basis/banded.hpp"
#include "bending.hpp"
#include "held.hpp"
#include "span_sums.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Control points by least squares of values at parameters, for any number of columns at once, in time linear in the
/// parameters (The NURBS Book, §9.4.1).
///
/// Sums of products are taken in Bernstein's form, span by span. The normal equations are solved for what is left
/// (Björck 1996, §6.6.5: "corrected seminormal equations"), so that the result is as good as the functions allow.
class LeastSquaresFit {
 public:
  /// @param parameters  in order, in the domain; they stay where they are as long as this
  /// @param weights     of the squares, positive ones, or none for 1 each
  /// @param smoothing   times the integral of the squared second derivative is added to the sum of squares
  /// @param shortest    spans that are shorter bend for nothing
  LeastSquaresFit(KnotVector knots, std::span<const double> parameters, std::span<const double> weights,
                  double smoothing, const Held& held, double shortest = 0.0);

  /// Improves control points, `columns` numbers each, until rounding is left.
  /// @throws InvalidShape if the values do not determine them.
  void solve(std::span<const double> values, std::size_t columns, std::span<double> controls) const;

  /// The same for points, three numbers each.
  /// @returns the largest distance of one from the curve at its parameter, on each span
  std::vector<double> solve_points(std::span<const double> points, std::span<double> controls) const;

  /// Parameters of span i: from ends()[i - 1], or 0, to ends()[i].
  std::span<const std::size_t> ends() const noexcept { return ends_; }

 private:
  std::size_t width() const noexcept { return static_cast<std::size_t>(knots_.degree()) + 1; }
  std::size_t first_of(std::size_t span) const { return static_cast<std::size_t>(knots_.spans()[span]) + 1 - width(); }
  SpanParameters parameters_of(std::size_t span) const;
  double energy_of(double length) const;
  void place();
  void add_products();
  void require_points() const;
  void require_energy_leaves_points() const;
  InvalidShape undetermined() const;
  auto rows_of(std::span<const double> values, std::size_t columns) const;
  BandedRows free_rows() const;
  std::vector<int> balance(BandedRows& rows) const;
  void solve_free(const BandedRows& rows, std::span<double> right, std::size_t columns) const;
  template <class Sums>
  double improve(std::size_t columns, double size, std::span<double> controls, const Sums& residual_sums) const;
  template <class Sums>
  void residual_sums(std::size_t columns, std::span<const double> controls, std::span<double> right,
                     const Sums& sums_of) const;
  void bezier_points(std::size_t span, std::span<const double> controls, std::size_t columns,
                     std::span<double> out) const;
  void add_bending(std::size_t columns, std::span<const double> controls, std::span<double> right) const;

  KnotVector knots_;
  std::span<const double> parameters_;
  std::span<const double> weights_;
  double weight_scale_ = 1.0;
  double smoothing_;
  Held held_;
  std::vector<double> bending_;    ///< of one piece over [0, 1], where slope_ has no products; none without smoothing
  std::optional<Bending> slope_;   ///< of knots near 1
  double slope_factor_ = 0.0;      ///< what it is multiplied by
  std::vector<std::size_t> ends_;  ///< of each span the index behind its last parameter
  std::vector<double> products_;   ///< row i: of function i with itself and the next `degree` ones
};

}  // namespace splinecore
#pragma GCC visibility pop
