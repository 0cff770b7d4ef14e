#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "knot_tables.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Finds the places of parameters on a knot vector, some at once.
class AxisPlaces {
 public:
  static constexpr std::size_t kMost = 64;

  /// @param order  of the highest derivative wanted, 2 at most
  AxisPlaces(const KnotVector& knots, int order, const char* name)
      : knots_(knots), tables_(knots.tables()), domain_(knots.domain()), order_(order), name_(name),
        rows_(tables_.all_rows(knots, order)), size_(tables_.size(order)), bounds_(tables_.finder.bounds()),
        starts_(knots.spans().data()), degree_(knots.degree()) {}

  /// Finds the spans of up to kMost parameters. @param first  the number of the first one
  void locate(std::span<const double> u, std::size_t first, Side side) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      const bool is_inside = u[i] > domain_.start && u[i] < domain_.end;
      u_[i] = is_inside ? u[i] : knots_.admit(u[i], side, first + i, name_);
    }
    tables_.finder.find_all(u_.data(), u.size(), side, spans_.data());
  }

  /// One of them, moved into the domain.
  double parameter(std::size_t i) const noexcept { return u_[i]; }

  /// The first control point that it depends on.
  int first(std::size_t i) const noexcept { return starts_[spans_[i]] - degree_; }

  void write(std::size_t i, BasisPlace& place) const {
    using Pair = double __attribute__((vector_size(2 * sizeof(double))));
    const std::int32_t span = spans_[i];
    const double start = bounds_[span];
    const double end = bounds_[span + 1];
    const Pair parts = Pair{u_[i] - start, end - u_[i]} / Pair{end - start, end - start};
    place.t = parts[0];
    place.s = parts[1];
    place.rows = rows_ != nullptr ? rows_ + static_cast<std::size_t>(span) * size_ : tables_.rows(knots_, span, order_);
  }

 private:
  const KnotVector& knots_;
  KnotTables& tables_;
  Interval domain_;
  int order_;
  const char* name_;
  const double* rows_;
  std::size_t size_;
  const double* bounds_;
  const int* starts_;
  int degree_;
  std::array<double, kMost> u_;
  std::array<std::int32_t, kMost> spans_;
};

}  // namespace splinecore
#pragma GCC visibility pop
