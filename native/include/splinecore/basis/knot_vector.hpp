#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"

namespace splinecore {

class KnotTables;

/// Rows of weights that lie somewhere else, as many in each as there are rows.
class SquareRows {
 public:
  SquareRows(const double* first, std::size_t size, std::size_t step) : first_(first), size_(size), step_(step) {}

  std::size_t size() const noexcept { return size_; }
  std::span<const double> operator[](std::size_t row) const noexcept { return {first_ + row * step_, size_}; }

 private:
  const double* first_;
  std::size_t size_;
  std::size_t step_;
};

/// A degree and its non-decreasing knots: what places parameters among control points.
///
/// Plain: n + degree + 1 knots for n control points; the domain is [u_degree, u_n].
/// Periodic: n + 1 knots, one period, for n control points; the parameter is taken modulo
/// the period, and control point i has the knots u_{i-degree+1} … u_i as its polar values.
/// Immutable; copies share one state, with the tables of spans, each built when it is first asked for.
class KnotVector {
 public:
  /// @throws InvalidShape if the degree is outside [0, kMaxDegree], there are too few knots,
  ///         a knot is not finite or decreases, or has multiplicity above degree + 1.
  static KnotVector make(int degree, std::vector<double> knots, bool periodic = false);

  /// The knots of one Bezier segment on [0, 1].
  static KnotVector bezier(int degree);

  /// Knots for `count` points, simple and one apart inside, of multiplicity degree + 1 at the ends.
  static KnotVector clamped(int degree, int count);

  /// Knots 0, 1, 2, … for `count` points: the curve touches no end point.
  static KnotVector uniform(int degree, int count);

  /// Knots 0, 1, …, count: a closed curve of `count` points.
  static KnotVector periodic_uniform(int degree, int count);

  int degree() const noexcept { return state_->degree; }
  bool periodic() const noexcept { return state_->periodic; }

  /// The knots as they were given.
  std::span<const double> knots() const noexcept { return state_->knots; }

  /// How many control points belong to these knots.
  int count() const noexcept { return state_->count; }

  /// Every knot that a parameter of the domain depends on: the same as knots() where plain,
  /// with `degree` more on each side where periodic.
  std::span<const double> unrolled() const noexcept { return state_->unrolled; }

  /// count(), and where periodic `degree` more: points repeat from the start.
  int unrolled_count() const noexcept;

  /// False where the functions exist but nowhere add up to 1 (fewer than degree + 1 of them).
  bool has_domain() const noexcept { return !state_->spans.empty(); }

  /// @throws InvalidShape where there is none.
  Interval domain() const;

  /// For each span of positive length in the domain, the index of its start in unrolled().
  std::span<const int> spans() const noexcept { return state_->spans; }

  /// The parameters of spans()[i].
  Interval span_interval(int i) const noexcept;

  /// The parameter moved into the domain: modulo the period, or clamped where it lies outside
  /// by at most 4 ulp of the domain's larger end.
  /// @throws InvalidShape naming u and its index if it lies outside, or is not finite.
  double admit(double u, Side side, std::optional<std::size_t> index = {}, const char* name = "u") const;

  /// Position in spans() of the span that holds an admitted parameter. At a knot Side::right
  /// takes the span that starts there, Side::left the one that ends there.
  int span_of(double u, Side side) const;

  /// Of span i: row j holds the coefficients, over the degree + 1 control points spans()[i] - degree …, of the j-th
  /// Bezier point of the piece on that span. All lie in [0, 1]. They stay as long as a copy of the vector does.
  /// Blossoms, after Ramshaw 1989; the triangle is algorithm A2.2 of The NURBS Book.
  SquareRows bezier_matrix(int i) const;

  /// What evaluation computes of the spans, each when it is first asked for; shared by copies.
  KnotTables& tables() const noexcept { return *state_->tables; }

  friend bool operator==(const KnotVector& a, const KnotVector& b) noexcept;

 private:
  struct State;
  struct State {
    int degree = 0;
    bool periodic = false;
    int count = 0;
    std::vector<double> knots;
    std::vector<double> periods;        ///< the knots unrolled, where periodic
    std::span<const double> unrolled;
    std::vector<int> spans;
    std::shared_ptr<KnotTables> tables;
  };

  explicit KnotVector(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// How often the value occurs among the knots; where periodic, within one period.
int multiplicity(const KnotVector& knots, double u) noexcept;

}  // namespace splinecore
