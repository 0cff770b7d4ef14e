#include "grid.hpp"

#include <algorithm>
#include <cmath>

namespace splinecore {

GridForm form_of(const NurbsPatch& patch) {
  const KnotVector& v = patch.knot_vector(Axis::v);
  return {&patch.homogeneous_points().data()->x, static_cast<std::size_t>(v.unrolled_count()),
          patch.knot_vector(Axis::u).degree(), v.degree(), patch.rational()};
}

const double* corner_of(const GridForm& form, int first_u, int first_v) {
  return form.points + 4 * (static_cast<std::size_t>(first_u) * form.width + static_cast<std::size_t>(first_v));
}

double slope_scale(const KnotVector& knots) { return std::ldexp(1.0, std::ilogb(knots.domain().length())); }

namespace {

double size_of(std::span<const double> slopes) {
  double size = 0.0;
  for (const double slope : slopes) size += std::abs(slope);
  return size;
}

}  // namespace

GridRow grid_row(const Samples& u, std::size_t i) {
  return {static_cast<std::size_t>(u.first(i)), u.weights(i).data(), nullptr, 0.0, {}};
}

GridRows::GridRows(const Samples& u, double scale, std::pmr::memory_resource* memory)
    : u_(u), scale_(scale), width_(u.weights(0).size()), slopes_(memory), sizes_(memory) {
  slopes_.reserve(u.size() * width_);
  sizes_.reserve(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto slopes = u.weights(i, 1);
    for (const double slope : slopes) slopes_.push_back(scale * slope);
    sizes_.push_back(scale * size_of(slopes));
  }
}

GridColumns::GridColumns(const Samples& v, std::pmr::memory_resource* memory)
    : blocks_(memory), weights_(memory), ranges_(memory) {
  fill(v, 0, 1.0);
}

GridColumns::GridColumns(const Samples& v, double scale, std::pmr::memory_resource* memory)
    : blocks_(memory), weights_(memory), ranges_(memory) {
  fill(v, 1, scale);
}

void GridColumns::fill(const Samples& v, int order, double scale) {
  const std::size_t degree_and_one = v.weights(0).size();
  const std::size_t lanes = kernels().lanes;
  columns_ = v.size();
  const auto end_of_block = [&](std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < v.size() && end < begin + lanes && v.first(end) == v.first(begin)) ++end;
    return end;
  };
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < v.size(); begin = end_of_block(begin)) ++count;
  blocks_.reserve(count);
  for (std::size_t begin = 0, end = 0; begin < v.size(); begin = end) {
    end = end_of_block(begin);
    blocks_.push_back({{}, static_cast<std::size_t>(v.first(begin)), static_cast<int>(end - begin), nullptr, nullptr});
  }
  const std::size_t numbers = blocks_.size() * lanes * degree_and_one * (static_cast<std::size_t>(order) + 1);
  weights_.resize((numbers + kMostLanes - 1) / kMostLanes);
  double* next = weights_.empty() ? nullptr : weights_.data()->numbers;
  std::size_t sample = 0;
  for (GridBlock& block : blocks_) {
    for (int k = 0; k <= order; ++k, next += lanes * degree_and_one) {
      (k == 0 ? block.values : block.slopes) = next;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        // Lanes without a sample repeat the last one.
        const auto weights = v.weights(sample + std::min<std::size_t>(lane, block.count - 1), k);
        const double factor = k == 0 ? 1.0 : scale;
        for (std::size_t j = 0; j < degree_and_one; ++j) next[lanes * j + lane] = factor * weights[j];
        if (k == 1) block.sizes[lane] = scale * size_of(weights);
      }
    }
    sample += static_cast<std::size_t>(block.count);
  }
  number_points(degree_and_one);
}

/// Finds which points are needed, and where each block has its first among them. @param of_block  points that it needs
void GridColumns::number_points(std::size_t of_block) {
  std::pmr::vector<std::size_t> firsts(blocks_.get_allocator().resource());
  firsts.reserve(blocks_.size());
  for (const GridBlock& block : blocks_) firsts.push_back(block.first);
  std::ranges::sort(firsts);
  ranges_.reserve(firsts.size());
  for (const std::size_t first : firsts) {
    const bool goes_on = !ranges_.empty() && first <= ranges_.back().first + ranges_.back().count;
    if (!goes_on) ranges_.push_back({first, 0});
    ranges_.back().count = std::max(ranges_.back().count, first + of_block - ranges_.back().first);
  }
  std::pmr::vector<std::size_t> before(blocks_.get_allocator().resource());
  before.reserve(ranges_.size());
  for (const GridRange& range : ranges_) {
    before.push_back(width_);
    width_ += range.count;
  }
  for (GridBlock& block : blocks_) {
    const auto next = std::ranges::upper_bound(ranges_, block.first, {}, &GridRange::first);
    const std::size_t range = static_cast<std::size_t>(next - ranges_.begin()) - 1;
    block.first = before[range] + block.first - ranges_[range].first;
  }
}

}  // namespace splinecore
