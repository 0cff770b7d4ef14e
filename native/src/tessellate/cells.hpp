#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "mesh_spans.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/tessellate/tessellation.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A rectangle in the parameters of a patch.
struct MeshCell {
  Place u0 = 0;
  Place u1 = 0;
  Place v0 = 0;
  Place v1 = 0;
  friend bool operator==(const MeshCell&, const MeshCell&) = default;
};

/// What becomes of a rectangle: a cell, or two halves.
enum class Cut : char { none, across_u, across_v };

/// @throws InvalidShape if there are as many cells as there may be.
void require_room_for_cells(std::size_t count);

/// What a cell costs, about, in steps of breathe().
inline constexpr std::size_t kStepsOfCell = 500;

/// A patch as it is cut: near the origin and of size 1, and what is asked for there.
struct PlacedPatch {
  PlacedPatch(const NurbsPatch& given, const Fineness& wanted);

  NurbsPatch patch;
  Fineness fineness;
  int weight_exponent;
};

/// Cuts a part of a patch into rectangles each fine enough, none across a knot and none more than 16 times as long
/// as wide; in a closed direction none wider than a third, so that no two faces have the same corners.
class CellCutter {
 public:
  /// @param spans  of u and v, which must outlive this, as the patch must
  CellCutter(const PlacedPatch& placed, const std::array<std::vector<MeshSpan>, 2>& spans, const MeshCell& whole,
             bool closed_u, bool closed_v);

  /// Rows of spans: across u.
  std::size_t rows() const noexcept { return static_cast<std::size_t>((whole_.u1 - whole_.u0) / kSpan); }
  std::size_t columns() const noexcept { return static_cast<std::size_t>((whole_.v1 - whole_.v0) / kSpan); }

  /// How the rectangles of a row are cut, one after the other: of each its cut, then those of its halves, the one with
  /// the lower parameters first. Rows may be asked for from several threads.
  /// @throws InvalidShape if all rows so far take more than 2^21 cells, or a weight is not above 0 however small
  ///         they are.
  std::vector<Cut> cuts_of_row(std::size_t row);

 private:
  const PlacedPatch& placed_;
  const std::array<std::vector<MeshSpan>, 2>& spans_;
  MeshCell whole_;
  std::array<Place, 2> widest_;  ///< no cell is wider
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace splinecore
#pragma GCC visibility pop
