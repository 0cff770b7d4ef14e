#pragma once

#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The points of a patch, as the kernels take them.
GridForm form_of(const NurbsPatch& patch);

/// The columns of a grid, four by four where they lie in one span.
class GridColumns {
 public:
  /// @param reach  the size of the points, for normals
  GridColumns(const Samples& v, int order, double reach = 0.0);

  GridBlocks blocks() const noexcept { return {blocks_.data(), blocks_.size(), low_, high_}; }

  /// Numbers that a kernel needs for so many rows of columns.
  std::size_t scratch_size(std::size_t rows) const noexcept { return 4 * rows * (high_ - low_ + 1); }

 private:
  std::vector<GridBlock> blocks_;
  std::vector<double> weights_;
  std::size_t low_ = 0;
  std::size_t high_ = 0;
};

/// What rounding may leave of a sum of points that reach so far; the slopes of functions multiply it.
double rounding_of(double reach);

/// A row of a grid. @param order  1 for normals
GridRow grid_row(const Samples& u, std::size_t i, int order, double reach = 0.0);

}  // namespace splinecore
