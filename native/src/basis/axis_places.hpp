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
        found_{nullptr, spans_.data(), tables_.finder.bounds(), knots.spans().data(), tables_.all_rows(knots, order),
               tables_.size(order), rows_.data()} {}
  AxisPlaces(const AxisPlaces&) = delete;
  AxisPlaces& operator=(const AxisPlaces&) = delete;

  /// Finds the spans of up to kMost parameters, which stay where they are. @param first  the number of the first one
  const ScatteredSpans& locate(std::span<const double> u, std::size_t first, Side side) {
    found_.u = u.data();
    if (!kernels().are_between(domain_.start, domain_.end, u.data(), u.size())) {
      for (std::size_t i = 0; i < u.size(); ++i) moved_[i] = admitted(u[i], side, first + i);
      found_.u = moved_.data();
    }
    tables_.finder.find_all(found_.u, u.size(), side, spans_.data());
    for (std::size_t i = 0; found_.table == nullptr && i < u.size(); ++i) {
      rows_[i] = tables_.rows(knots_, spans_[i], order_);
    }
    return found_;
  }

  /// One of them, moved into the domain.
  double parameter(std::size_t i) const noexcept { return found_.u[i]; }

  /// The first control point that it depends on.
  int first(std::size_t i) const noexcept { return found_.first_knots[spans_[i]] - knots_.degree(); }

 private:
  double admitted(double u, Side side, std::size_t i) const {
    return u > domain_.start && u < domain_.end ? u : knots_.admit(u, side, i, name_);
  }

  const KnotVector& knots_;
  KnotTables& tables_;
  Interval domain_;
  int order_;
  const char* name_;
  std::array<double, kMost> moved_;
  std::array<std::int32_t, kMost> spans_;
  std::array<const double*, kMost> rows_;
  ScatteredSpans found_;
};

}  // namespace splinecore
#pragma GCC visibility pop
