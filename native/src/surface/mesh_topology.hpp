#pragma once

#include <cstddef>
#include <vector>

#include "splinecore/surface/catmull_clark.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A side of a face, from one corner to the next. Sides are numbered face after face.
struct FaceSide {
  int face;
  int corner;    ///< where it begins, among those of the face
  int from;      ///< the point
  int twin;      ///< the side of the other face along the edge, or -1
};

/// Which faces meet along the edges of a mesh, and about its points.
class MeshTopology {
 public:
  /// @throws InvalidShape as catmull_clark()
  explicit MeshTopology(const ControlMesh& mesh);

  const std::vector<FaceSide>& sides() const noexcept { return sides_; }
  const FaceSide& side(int i) const { return sides_[static_cast<std::size_t>(i)]; }
  int first_side(int face) const { return first_[static_cast<std::size_t>(face)]; }
  int corners(int face) const { return first_side(face + 1) - first_side(face); }
  int next(int side) const { return turned(side, 1); }
  int before(int side) const { return turned(side, -1); }
  int to(int i) const { return side(next(i)).from; }

  /// Sides that begin at a point, counterclockwise about it; of a point on the border from the border on. None for a point
  /// without faces.
  const std::vector<int>& fan(int point) const { return fans_[static_cast<std::size_t>(point)]; }
  bool is_on_border(int point) const { return is_on_border_[static_cast<std::size_t>(point)]; }

  /// Whether four faces meet there, or on the border two, or one.
  bool is_regular(int point) const;

 private:
  int turned(int side, int by) const;
  void find_twins(const ControlMesh& mesh);
  void find_fans(const ControlMesh& mesh);

  std::vector<FaceSide> sides_;
  std::vector<int> first_;  ///< side of each face, and one more
  std::vector<std::vector<int>> fans_;
  std::vector<bool> is_on_border_;
};

}  // namespace splinecore
#pragma GCC visibility pop
