#pragma once

#include <array>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh_parts.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A corner of a face: its vertex, and where the patch's normal is taken.
struct FaceCorner {
  std::int32_t vertex;
  std::size_t sample;
  double u;
  double v;
};

/// Writes vertices and faces into the parts of a mesh, and samples of patches that lie on no grid.
class MeshWriter {
 public:
  /// The grids of the mesh are there, and its sample_count is theirs.
  MeshWriter(const PatchSet& set, MeshParts& mesh)
      : set_(set), mesh_(mesh), first_(mesh.sample_count), scatter_of_(4 * set.patches().size(), -1) {}

  std::int32_t add_vertex(std::size_t sample);

  /// A sample of a patch, seen from these sides, that nobody has asked for.
  std::size_t new_sample(std::size_t patch, double u, double v, Side side_u, Side side_v);

  /// The sample there, the same whoever asks.
  std::size_t sample_at(std::size_t patch, double u, double v, Side side_u, Side side_v);

  /// Room for so many faces of four corners.
  void reserve_faces(std::size_t count);

  /// A face of three or four corners, counter-clockwise seen from where S_u x S_v points, unless it has shrunk to
  /// an edge.
  /// @param is_border  of the edge from each corner to the next: the normal may jump across it
  void add_face(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border);

  /// As add_face(), but nothing where a face with the same vertices is there.
  void add_face_once(std::size_t patch, std::span<const FaceCorner> corners, std::span<const char> is_border);

  /// Vertices that no face needs go; what add_face() and sample_at() gave is put into its final order.
  void finish();

 private:
  using Seam = MeshParts::Seam;

  void drop_unused_vertices();
  void place_samples();

  const PatchSet& set_;
  MeshParts& mesh_;
  std::size_t first_;  // samples from this one on are not on grids
  struct SampleKey {
    std::size_t patch;
    double u, v;
    Side side_u, side_v;
    friend bool operator==(const SampleKey&, const SampleKey&) = default;
  };
  struct SampleHash {
    std::size_t operator()(const SampleKey& key) const noexcept;
  };
  std::unordered_map<SampleKey, std::size_t, SampleHash> samples_;
  std::vector<int> scatter_of_;  ///< of each patch and pair of sides; -1 where there is none yet
  std::vector<std::pair<std::size_t, std::size_t>> sample_places_;  // scatter, number in it
  std::set<std::vector<std::int32_t>> known_faces_;
  std::size_t domain_patch_ = static_cast<std::size_t>(-1);  ///< whose domains are at hand
  std::array<Interval, 2> domains_;
};

}  // namespace splinecore
#pragma GCC visibility pop
