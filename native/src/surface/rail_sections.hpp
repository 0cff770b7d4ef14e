#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit/row_spline.hpp"
#include "fitted_rows.hpp"
#include "splinecore/surface/sweep.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The sections of a sweep on one knot vector, and how they change along its rail.
class RailSections {
 public:
  /// @param unit  by which lengths of sections are divided
  /// @throws InvalidShape as sweep()
  RailSections(std::span<const RailSection> sections, const NurbsCurve& rail, double unit);

  const KnotVector& knots() const noexcept { return knots_; }

  /// Whether it is the same everywhere.
  bool is_one() const noexcept { return !along_; }

  /// Where they change less smoothly than between.
  std::vector<RowJoint> joints() const;

  /// @throws InvalidShape where weights that are all positive in the sections are not between them
  void require_weights(const FittedRows& rows) const;

  /// Homogeneous control points at parameters of the rail, row after row.
  std::vector<glm::dvec4> at(std::span<const double> parameters) const;

 private:
  KnotVector knots_;
  std::vector<glm::dvec4> first_;
  std::optional<RowSpline> along_;  ///< where there are several
  std::vector<std::optional<double>> level_weights_;  ///< of several: those that all sections have in common
  bool are_positive_ = false;                         ///< all weights of several
  bool goes_round_ = false;
};

}  // namespace splinecore
#pragma GCC visibility pop
