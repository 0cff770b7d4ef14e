#include <algorithm>
#include <utility>
#include <vector>

#include "mesh_parts.hpp"
#include "moved_spans.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {

namespace {

/// Samples that are evaluated at once, about: their points stay in a core's cache.
constexpr std::size_t kBlock = std::size_t{1} << 14;

/// The first number from range.begin on of which it is not so that it lies before; all that do come first.
template <class LiesBefore>
int first_behind(Range range, LiesBefore lies_before) {
  while (range.begin < range.end) {
    const int middle = range.begin + (range.end - range.begin) / 2;
    if (lies_before(middle)) {
      range.begin = middle + 1;
    } else {
      range.end = middle;
    }
  }
  return range.begin;
}

/// Which of sorted samples lie on spans. span_of(i) is that of sample i.
template <class SpanOf>
Range samples_on(const Range& samples, const Range& spans, SpanOf span_of) {
  const int begin = first_behind(samples, [&](int i) { return span_of(i) < spans.begin; });
  return {begin, first_behind({begin, samples.end}, [&](int i) { return span_of(i) < spans.end; })};
}

Range samples_on(const Samples& samples, const KnotVector& knots, const Range& spans) {
  return samples_on({0, static_cast<int>(samples.size())}, spans,
                    [&](int i) { return knots.span_of(samples.parameter(i), samples.side(i)); });
}

Samples part_of(const Samples& samples, const KnotVector& knots, const Range& range) {
  std::vector<double> parameters;
  std::vector<Side> sides;
  for (int i = range.begin; i < range.end; ++i) {
    parameters.push_back(samples.parameter(i));
    sides.push_back(samples.side(i));
  }
  return Samples::make(knots, parameters, 0, sides);
}

/// Evaluates vertices on some spans of patches; keeps its memory from one rectangle to the next.
class PositionWriter {
 public:
  explicit PositionWriter(std::span<float> positions) : positions_(positions) {}

  void write(const NurbsPatch& patch, const MeshParts::Grid& grid, const SpanRectangle& spans) {
    const KnotVector& knots = patch.knot_vector(Axis::u);
    const Range rows = samples_on(grid.u.samples, knots, spans.u);
    const Range columns = samples_on(grid.v.samples, patch.knot_vector(Axis::v), spans.v);
    if (rows.begin == rows.end || columns.begin == columns.end) return;
    const Samples v = part_of(grid.v.samples, patch.knot_vector(Axis::v), columns);
    const int most = static_cast<int>(std::max(std::size_t{1}, kBlock / v.size()));
    for (Range some{rows.begin, rows.begin}; some.begin < rows.end; some.begin = some.end) {
      some.end = std::min(rows.end, some.begin + most);
      const Samples u = part_of(grid.u.samples, knots, some);
      evaluate_grid(patch, u, v, points(u.size() * v.size()));
      put_rows(grid, some, columns);
    }
  }

  void write(const NurbsPatch& patch, const MeshParts::Scatter& scatter, const SpanRectangle& spans) {
    const KnotVector& knots_u = patch.knot_vector(Axis::u);
    const KnotVector& knots_v = patch.knot_vector(Axis::v);
    const auto span_u = [&](int i) { return knots_u.span_of(scatter.u[i], scatter.sides.side_u); };
    const auto span_v = [&](int i) { return knots_v.span_of(scatter.v[i], scatter.sides.side_v); };
    const Range rows = samples_on({0, static_cast<int>(scatter.vertices.size())}, spans.u, span_u);
    if (spans.v == Range{0, static_cast<int>(knots_v.spans().size())}) {
      put_samples(patch, scatter, rows);
      return;
    }
    for (Range row{rows.begin, rows.begin}; row.begin < rows.end; row.begin = row.end) {
      const int span = span_u(row.begin);
      row.end = samples_on({row.begin, rows.end}, {span, span + 1}, span_u).end;
      put_samples(patch, scatter, samples_on(row, spans.v, span_v));
    }
  }

 private:
  std::span<float> points(std::size_t count) {
    if (points_.size() < 3 * count) points_.resize(3 * count);
    return std::span(points_).first(3 * count);
  }

  void put_rows(const MeshParts::Grid& grid, const Range& rows, const Range& columns) {
    const auto width = static_cast<std::int32_t>(grid.v.samples.size());
    const float* point = points_.data();
    for (int row = rows.begin; row < rows.end; ++row, point += 3 * (columns.end - columns.begin)) {
      const std::int32_t first = row * width + columns.begin;
      const std::int32_t end = row * width + columns.end;
      const auto end_of = [](const MeshParts::Run& run) { return run.sample + run.count; };
      auto run = std::ranges::upper_bound(grid.runs, first, {}, end_of);
      for (; run != grid.runs.end() && run->sample < end; ++run) {
        const std::int32_t from = std::max(run->sample, first);
        const std::int32_t to = std::min(run->sample + run->count, end);
        const auto vertex = static_cast<std::size_t>(run->vertex + from - run->sample);
        std::copy(point + 3 * (from - first), point + 3 * (to - first), positions_.data() + 3 * vertex);
      }
    }
  }

  void put_samples(const NurbsPatch& patch, const MeshParts::Scatter& scatter, const Range& samples) {
    for (std::size_t begin = samples.begin; begin < static_cast<std::size_t>(samples.end); begin += kBlock) {
      const std::size_t count = std::min(kBlock, samples.end - begin);
      const std::span<float> found = points(count);
      evaluate(patch, std::span(scatter.u).subspan(begin, count), std::span(scatter.v).subspan(begin, count), found,
               scatter.sides);
      for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(&found[3 * i], 3, &positions_[3 * static_cast<std::size_t>(scatter.vertices[begin + i])]);
      }
    }
  }

  std::span<float> positions_;
  std::vector<float> points_;
};

}  // namespace

void Tessellation::evaluate_positions(const PatchSet& set, std::span<float> positions) const {
  PositionWriter writer(positions);
  for (std::size_t i = 0; i < parts_->grids.size(); ++i) {
    const NurbsPatch& patch = nurbs_of(set.patch(i));
    writer.write(patch, parts_->grids[i], all_spans(patch));
  }
  for (const MeshParts::Scatter& scatter : parts_->scatters) {
    const NurbsPatch& patch = nurbs_of(set.patch(scatter.patch));
    writer.write(patch, scatter, all_spans(patch));
  }
}

void Tessellation::update_positions(const PatchSet& set, const PatchSet& before, std::span<float> positions) const {
  PositionWriter writer(positions);
  std::vector<std::vector<SpanRectangle>> moved;
  for (std::size_t i = 0; i < parts_->patches->size(); ++i) {
    moved.push_back(moved_spans(nurbs_of(set.patch(i)), nurbs_of(before.patch(i))));
  }
  for (std::size_t i = 0; i < parts_->grids.size(); ++i) {
    for (const SpanRectangle& spans : moved[i]) writer.write(nurbs_of(set.patch(i)), parts_->grids[i], spans);
  }
  for (const MeshParts::Scatter& scatter : parts_->scatters) {
    for (const SpanRectangle& spans : moved[scatter.patch]) {
      writer.write(nurbs_of(set.patch(scatter.patch)), scatter, spans);
    }
  }
}

}  // namespace splinecore
