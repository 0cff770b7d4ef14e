#include <algorithm>
#include <numeric>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

#include "loose_rows.hpp"
#include "mesh_parts.hpp"

namespace splinecore {

namespace {

/// Numbers 0, 1, … in the order of their keys, which are below `most`; equal keys stay as they are.
template <class Key>
std::vector<std::int32_t> sorted_by(std::size_t count, std::size_t most, Key key) {
  std::vector<std::int32_t> ends(most + 1, 0);
  for (std::size_t i = 0; i < count; ++i) ++ends[key(i) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::int32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[ends[key(i)]++] = static_cast<std::int32_t>(i);
  return order;
}

template <std::ranges::random_access_range Values>
auto in_order(const Values& values, const std::vector<std::int32_t>& order) {
  std::vector<std::ranges::range_value_t<Values>> found;
  found.reserve(order.size());
  for (const std::int32_t i : order) found.push_back(values[i]);
  return found;
}

/// Sorts what a mesh evaluates so that the vertices on a span of a patch are found at once.
class VertexPlaces {
 public:
  VertexPlaces(const PatchSet& set, MeshParts& mesh)
      : set_(set), mesh_(mesh), by_sample_(sorted_by(mesh.vertex_samples.size(), mesh.sample_count,
                                                     [&](std::size_t i) { return mesh.vertex_samples[i]; })),
        vertex_samples_(mesh.vertex_samples), new_sample_(mesh.sample_count) {
    std::iota(new_sample_.begin(), new_sample_.end(), std::size_t{0});
  }

  void place() {
    for (MeshParts::Grid& grid : mesh_.grids) find_runs(grid);
    if (mesh_.scatters.empty()) return;
    std::size_t next = mesh_.scatters.front().first_sample;
    for (MeshParts::Scatter& scatter : mesh_.scatters) {
      put(scatter, sorted(scatter), next);
      next += scatter.u.size();
    }
    mesh_.sample_count = next;
    mesh_.vertex_samples = std::move(vertex_samples_);
    for (std::size_t& sample : mesh_.corner_samples) sample = new_sample_[sample];
  }

 private:
  /// Vertices with samples from `first` on, as places in by_sample_.
  std::pair<std::size_t, std::size_t> vertices_in(std::size_t first, std::size_t count) const {
    const auto before = [&](std::size_t sample) {
      const auto sample_of = [&](std::int32_t vertex) { return mesh_.vertex_samples[vertex]; };
      return std::ranges::lower_bound(by_sample_, sample, {}, sample_of) - by_sample_.begin();
    };
    return {before(first), before(first + count)};
  }

  void find_runs(MeshParts::Grid& grid) const {
    const std::size_t columns = grid.v.samples.size();
    const auto [begin, end] = vertices_in(grid.first_sample, grid.u.samples.size() * columns);
    for (std::size_t i = begin; i < end; ++i) {
      const std::int32_t vertex = by_sample_[i];
      const auto sample = static_cast<std::int32_t>(mesh_.vertex_samples[vertex] - grid.first_sample);
      if (!grid.runs.empty() && sample % static_cast<std::int32_t>(columns) != 0) {
        MeshParts::Run& last = grid.runs.back();
        if (sample == last.sample + last.count && vertex == last.vertex + last.count) {
          ++last.count;
          continue;
        }
      }
      grid.runs.push_back({sample, 1, vertex});
    }
    grid.runs.shrink_to_fit();
  }

  /// The samples of a scatter as they are to lie: one for each vertex, which scatter.vertices says then, and others.
  std::vector<std::int32_t> sorted(MeshParts::Scatter& scatter) const {
    const auto [begin, end] = vertices_in(scatter.first_sample, scatter.u.size());
    std::vector<std::int32_t> samples;
    std::vector<char> is_known(scatter.u.size(), 0);
    for (std::size_t i = begin; i < end; ++i) {
      samples.push_back(static_cast<std::int32_t>(mesh_.vertex_samples[by_sample_[i]] - scatter.first_sample));
      is_known[samples.back()] = 1;
    }
    const std::vector<std::int32_t> order = by_spans(scatter, samples);
    samples = in_order(samples, order);
    scatter.vertices = in_order(std::span(by_sample_).subspan(begin, end - begin), order);
    for (std::size_t i = 0; i < is_known.size(); ++i) {
      if (!is_known[i]) samples.push_back(static_cast<std::int32_t>(i));
    }
    return samples;
  }

  std::vector<std::int32_t> by_spans(const MeshParts::Scatter& scatter,
                                     const std::vector<std::int32_t>& samples) const {
    const NurbsPatch& patch = nurbs_of(set_.patch(scatter.patch));
    const auto sorted_along = [&](Axis axis, const std::vector<std::int32_t>& chosen) {
      const KnotVector& knots = patch.knot_vector(axis);
      std::vector<int> spans;
      for (const std::int32_t i : chosen) {
        spans.push_back(axis == Axis::u ? knots.span_of(scatter.u[i], scatter.sides.side_u)
                                        : knots.span_of(scatter.v[i], scatter.sides.side_v));
      }
      return sorted_by(chosen.size(), knots.spans().size(), [&](std::size_t i) { return spans[i]; });
    };
    const std::vector<std::int32_t> by_v = sorted_along(Axis::v, samples);
    return in_order(by_v, sorted_along(Axis::u, in_order(samples, by_v)));
  }

  /// Gives a scatter its samples in another order.
  void put(MeshParts::Scatter& scatter, const std::vector<std::int32_t>& samples, std::size_t first) {
    scatter.u = in_order(scatter.u, samples);
    scatter.v = in_order(scatter.v, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) new_sample_[scatter.first_sample + samples[i]] = first + i;
    for (std::size_t i = 0; i < scatter.vertices.size(); ++i) vertex_samples_[scatter.vertices[i]] = first + i;
    scatter.first_sample = first;
  }

  const PatchSet& set_;
  MeshParts& mesh_;
  std::vector<std::int32_t> by_sample_;       // vertices in the order of their samples
  std::vector<std::size_t> vertex_samples_;   // as they will be
  std::vector<std::size_t> new_sample_;       // of each sample as it was
};

}  // namespace

void place_vertices(const PatchSet& set, MeshParts& mesh) {
  VertexPlaces(set, mesh).place();
  mesh.loose = loose_rows(set, mesh.panels);
}

}  // namespace splinecore
