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
      : knots_(knots), tables_(knots.tables()), domain_(knots.domain()), order_(order), name_(name) {
    for (int k = 0; k <= order; ++k) {
      rows_[k] = tables_.all_derivative_rows(knots, k);
      size_[k] = tables_.derivatives[k].size();
    }
  }

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
  int first(std::size_t i) const noexcept { return knots_.spans()[spans_[i]] - knots_.degree(); }

  void write(std::size_t i, BasisPlace& place) const {
    const double start = tables_.finder.bounds()[spans_[i]];
    const double end = tables_.finder.bounds()[spans_[i] + 1];
    place.t = (u_[i] - start) / (end - start);
    place.s = (end - u_[i]) / (end - start);
    for (int k = 0; k <= order_; ++k) {
      place.rows[k] = rows_[k] != nullptr ? rows_[k] + static_cast<std::size_t>(spans_[i]) * size_[k]
                                          : tables_.derivative_rows(knots_, spans_[i], k);
    }
  }

 private:
  const KnotVector& knots_;
  KnotTables& tables_;
  Interval domain_;
  int order_;
  const char* name_;
  const double* rows_[3] = {};
  std::size_t size_[3] = {};
  std::array<double, kMost> u_;
  std::array<std::int32_t, kMost> spans_;
};

}  // namespace splinecore
#pragma GCC visibility pop
