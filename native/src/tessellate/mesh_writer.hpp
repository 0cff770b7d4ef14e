#pragma once

#include <map>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "splinecore/tessellate/tessellation.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A corner of a face: its vertex, and where the patch's normal is taken.
struct FaceCorner {
  std::int32_t vertex;
  std::size_t sample;
  double u;
  double v;
};

/// Writes vertices and faces into a Tessellation, and samples of patches that lie on no grid.
class MeshWriter {
 public:
  /// The grids of the tessellation are there, and its sample_count_ is theirs.
  MeshWriter(const PatchSet& set, Tessellation& mesh) : set_(set), mesh_(mesh), first_(mesh.sample_count_) {}

  std::int32_t add_vertex(std::size_t sample);

  /// The sample of a patch there, seen from these sides.
  std::size_t sample_at(std::size_t patch, double u, double v, Side side_u, Side side_v);

  /// A face of three or four corners, counter-clockwise seen from where S_u x S_v points, unless it has shrunk to
  /// an edge.
  /// @param is_border  of the edge from each corner to the next: the normal may jump across it
  void add_face(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border);

  /// As add_face(), but nothing where a face with the same vertices is there.
  void add_face_once(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border);

  /// Vertices that no face needs go; what add_face() and sample_at() gave is put into its final order.
  void finish();

 private:
  using Seam = Tessellation::Seam;

  void drop_unused_vertices();
  void place_samples();

  const PatchSet& set_;
  Tessellation& mesh_;
  std::size_t first_;  // samples from this one on are not on grids
  std::map<std::tuple<std::size_t, double, double, Side, Side>, std::size_t> samples_;
  std::map<std::tuple<std::size_t, Side, Side>, std::size_t> scatter_of_;
  std::vector<std::pair<std::size_t, std::size_t>> sample_places_;  // scatter, number in it
  std::set<std::vector<std::int32_t>> known_faces_;
};

}  // namespace splinecore
#pragma GCC visibility pop
