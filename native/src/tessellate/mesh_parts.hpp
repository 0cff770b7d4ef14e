#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "axis_samples.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/panels.hpp"
#include "splinecore/patch/patch_set.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a Tessellation is made of.
struct MeshParts {
  /// Samples one after the other in a row of a grid, the first by its number there, and the vertices that have them.
  struct Run {
    std::int32_t sample;
    std::int32_t count;
    std::int32_t vertex;
  };
  struct Grid {
    AxisSamples u;
    AxisSamples v;
    std::size_t first_sample;
    std::vector<Run> runs = {};  // in the samples' order
  };
  /// Samples of one patch, all from the same sides of its knots. Those of vertices come first, by spans in u, then v.
  struct Scatter {
    std::size_t patch;
    PatchOptions sides;
    std::vector<double> u;
    std::vector<double> v;
    std::size_t first_sample;
    std::vector<std::int32_t> vertices = {};
  };
  /// The side of a mesh edge that a face lies on.
  struct Seam {
    std::int32_t low_vertex, high_vertex;
    std::int32_t low_corner, high_corner;
  };

  explicit MeshParts(const PatchSet& set) : patches(set.topology()), panels(panels_of(set)) {}

  std::shared_ptr<const std::vector<IndexedPatch>> patches;
  std::vector<Panel> panels;
  std::vector<Grid> grids;        // of each patch, by count
  std::vector<Scatter> scatters;  // beside grids, or all where it is adaptive
  std::size_t sample_count = 0;
  std::vector<std::size_t> vertex_samples;
  std::vector<std::size_t> corner_samples;
  std::vector<std::int32_t> corner_vertices;
  std::vector<std::int32_t> face_starts;
  std::vector<std::int32_t> face_patches;
  std::vector<float> corner_uvs;
  std::vector<Seam> seams;  // sorted by vertices
  std::vector<char> loose;  // of each row of the pool: whether sides on it may come apart or open
};

/// Gives what vertices are evaluated from its final order: those on a span of a patch are found at once then.
void place_vertices(const PatchSet& set, MeshParts& mesh);

}  // namespace splinecore
#pragma GCC visibility pop
