#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

struct MeshParts;

/// How fine a mesh is to be.
struct Fineness {
  double distance;  ///< no point of the surface lies farther from the mesh; infinite for any
  double angle;     ///< radians, between normals at 3 x 3 places of each face, which is a 1024th of a span at least;
                    ///< infinite for any
  double smallest = 0.0;  ///< faces are not cut for their angle across a direction in which they are shorter
};

/// The mesh of a patch set: everything but positions (lecture row S22).
///
/// Faces are wound so that their normals are S_u x S_v; a collapsed edge is one vertex with triangles around
/// it. It is made once and evaluated for as many positions of the points as come.
class Tessellation {
 public:
  /// A fixed number of faces per span: grids of quads.
  ///
  /// Where the sides of an edge (panels_of()) would have vertices at other places, all take those of the side that has
  /// most, and triangles lead over to the grid, which has two strips then at least. A closed direction has three.
  /// @throws InvalidShape if a resolution is outside [1, 4096] or there would be more than 2^22 samples.
  static Tessellation make(const PatchSet& set, int resolution_u, int resolution_v);

  /// As many faces as the shape of the set asks for: few where it is flat, and along straight lines.
  ///
  /// Crack-free across every side that two patches have in common (panels_of()), whatever their degrees, knots
  /// and numbers of faces. Quads, and triangles where cells of different sizes meet.
  /// The same in every bit whatever the threads.
  /// @param threads  at most, 0 for one a core where there is enough to do; none outlives the call
  /// @throws InvalidShape if a number is not above 0 (the smallest: is below 0), there would be more than 2^21 cells,
  ///         or a patch runs to infinity.
  static Tessellation adaptive(const PatchSet& set, const Fineness& fineness, int threads = 0);

  /// Whether the set has the patches, on the same knots and with the same sides in common, that this was made for.
  bool fits(const PatchSet& set) const;

  /// Whether the set has the patches that this was made for, whatever their points. Of one that
  /// PatchSet::with_points() made of the same set, this is to compare two pointers.
  bool has_patches_of(const PatchSet& set) const;

  /// Whether a set fits of which `before` does; both have the patches. Looks at nothing but sides that may have come
  /// apart, or opened: of points that moved, and not one by having the same rows of the pool.
  bool still_fits(const PatchSet& set, const PatchSet& before) const;

  std::size_t vertex_count() const noexcept;

  /// Where the corners of each face start in corner_vertices().
  std::span<const std::int32_t> face_starts() const noexcept;
  std::span<const std::int32_t> face_patches() const noexcept;
  std::span<const std::int32_t> corner_vertices() const noexcept;

  /// u, v of each corner, scaled to [0, 1] over the patch's domain.
  std::span<const float> corner_uvs() const noexcept;

  /// x, y, z of each vertex and of the normal at each corner, (0, 0, 0) where the surface has none, of a set with the
  /// same patches. Whether their sides lie on one another as they did is for fits() to say.
  void evaluate(const PatchSet& set, std::span<float> positions, std::span<float> corner_normals) const;

  /// The positions only, for a shape that is being dragged.
  void evaluate_positions(const PatchSet& set, std::span<float> positions) const;

  /// The same in every bit where `positions` are those of `before`, a set with the same patches: what depends on no
  /// point that differs stays. After an error they are of neither.
  void update_positions(const PatchSet& set, const PatchSet& before, std::span<float> positions) const;

  /// Pairs of vertices between which the surface has an angle above `angle` (radians), of the
  /// corner normals that evaluate() gave. Only edges of patches and knots without C1 can be sharp.
  std::vector<std::int32_t> sharp_edges(std::span<const float> corner_normals, double angle) const;

 private:
  explicit Tessellation(MeshParts parts);

  std::shared_ptr<const MeshParts> parts_;
};

}  // namespace splinecore
