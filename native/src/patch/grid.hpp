#pragma once

#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The points of a patch, as the kernels take them.
GridForm form_of(const NurbsPatch& patch);

/// The first of the points that functions from these on are for.
const double* corner_of(const GridForm& form, int first_u, int first_v);

/// The columns of a grid, as many at once as a kernel takes where they lie in one span.
class GridColumns {
 public:
  explicit GridColumns(const Samples& v);

  /// For normals. @param reach  the size of the points @param scale  of the slopes
  GridColumns(const Samples& v, double reach, double scale);

  GridBlocks blocks() const noexcept {
    return {blocks_.data(), blocks_.size(), ranges_.data(), ranges_.size(), width_, columns_};
  }

  /// Numbers that a kernel needs for so many rows of columns.
  std::size_t scratch_size(std::size_t rows) const noexcept { return 4 * rows * width_; }

 private:
  void fill(const Samples& v, int order, double reach, double scale);
  void number_points(std::size_t of_block);

  std::vector<GridBlock> blocks_;
  std::vector<double> weights_;
  std::vector<GridRange> ranges_;
  std::size_t width_ = 0;
  std::size_t columns_ = 0;
};

/// What rounding may leave of a sum of points that reach so far; the slopes of functions multiply it.
double rounding_of(double reach);

/// A row of a grid.
GridRow grid_row(const Samples& u, std::size_t i);

/// The same for normals. @param slopes  takes the slopes, times the scale
GridRow grid_row(const Samples& u, std::size_t i, double reach, double scale, std::vector<double>& slopes);

}  // namespace splinecore
#pragma GCC visibility pop
