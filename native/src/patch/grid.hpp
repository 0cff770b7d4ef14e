#pragma once

#include <memory_resource>
#include <optional>
#include <span>
#include <utility>
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

/// Numbers where a register of the widest lanes is loaded at once.
struct alignas(kMostLanes * sizeof(double)) LaneRow {
  double numbers[kMostLanes];
};

/// The columns of a grid, as many at once as a kernel takes where they lie in one span.
class GridColumns {
 public:
  GridColumns(const Samples& v, std::pmr::memory_resource* memory);

  /// For normals. @param scale  by what slopes are multiplied
  GridColumns(const Samples& v, double scale, std::pmr::memory_resource* memory);

  /// @param written  bytes that a call writes
  GridBlocks blocks(std::size_t written) const noexcept {
    constexpr std::size_t kNear = std::size_t{1} << 24;  // what caches may keep from one call to the next
    return {blocks_.data(), blocks_.size(), ranges_.data(), ranges_.size(), width_, columns_, written > kNear};
  }

  /// Numbers that a kernel needs for so many rows of columns.
  std::size_t scratch_size(std::size_t rows) const noexcept { return 4 * rows * width_; }

 private:
  void fill(const Samples& v, int order, double scale);
  void number_points(std::size_t of_block);

  std::pmr::vector<GridBlock> blocks_;
  std::pmr::vector<LaneRow> weights_;
  std::pmr::vector<GridRange> ranges_;
  std::size_t width_ = 0;
  std::size_t columns_ = 0;
};

/// A row of a grid.
GridRow grid_row(const Samples& u, std::size_t i);

/// The rows of a grid for normals.
class GridRows {
 public:
  /// @param scale  by what slopes are multiplied
  GridRows(const Samples& u, double scale, std::pmr::memory_resource* memory);

  /// The rows as columns of the grid with u and v exchanged, made when they are first asked for, by one thread.
  const GridColumns& turned() const {
    if (!turned_) turned_.emplace(u_, scale_, slopes_.get_allocator().resource());
    return *turned_;
  }

  GridRow row(std::size_t i, const NormalRounding& rounding) const noexcept {
    const auto first = static_cast<std::size_t>(u_.first(i));
    return {first, u_.weights(i).data(), slopes_.data() + i * width_, sizes_[i], rounding};
  }

 private:
  const Samples& u_;
  double scale_;
  mutable std::optional<GridColumns> turned_;
  std::size_t width_;
  std::pmr::vector<double> slopes_;
  std::pmr::vector<double> sizes_;
};

/// By what derivatives along a direction are multiplied where normals are wanted: a power of two, about the length of
/// its domain.
double slope_scale(const KnotVector& knots);

/// The parameters of a grid as the kernels take them: the same for all patches on the same knots.
struct GridPlan {
  GridPlan(const Samples& at_u, const Samples& at_v, std::pmr::memory_resource* memory)
      : u(at_u), v(at_v), columns(v, memory) {}

  /// For normals of patches on the knots of one.
  GridPlan(const Samples& at_u, const Samples& at_v, const NurbsPatch& on, std::pmr::memory_resource* memory)
      : u(at_u), v(at_v), columns(v, slope_scale(on.knot_vector(Axis::v)), memory),
        rows(std::in_place, u, slope_scale(on.knot_vector(Axis::u)), memory) {}

  const Samples& u;
  const Samples& v;
  GridColumns columns;
  std::optional<GridRows> rows;  ///< for normals alone
};

}  // namespace splinecore
#pragma GCC visibility pop
