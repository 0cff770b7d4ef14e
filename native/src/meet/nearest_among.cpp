#include "splinecore/meet/nearest_among.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "base/parallel.hpp"
#include "base/require.hpp"
#include "base/rounding.hpp"
#include "nearest_places.hpp"
#include "shape_box.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Distances that differ by no more, of the size of all and of themselves, are one.

/// Shapes, and a tree of their boxes in a space that they share.
template <class Shape>
class Targets {
 public:
  explicit Targets(std::span<const Shape* const> shapes) : shapes_(shapes), space_(points_of(shapes)), tree_(boxes()) {}

  std::span<const Shape* const> shapes() const noexcept { return shapes_; }
  const NearSpace& space() const noexcept { return space_; }
  const BoxTree& tree() const noexcept { return tree_; }

 private:
  static std::vector<glm::dvec4> points_of(std::span<const Shape* const> shapes) {
    if (shapes.empty()) throw InvalidShape("shapes is empty: one or more are needed");
    std::vector<glm::dvec4> all;
    for (const Shape* shape : shapes) all.insert(all.end(), shape->points().begin(), shape->points().end());
    return all;
  }

  std::vector<TreeBox> boxes() const {
    std::vector<TreeBox> all;
    for (const Shape* shape : shapes_) all.push_back(box_in(space_, boxed_pieces(*shape)));
    return all;
  }

  std::span<const Shape* const> shapes_;
  NearSpace space_;
  BoxTree tree_;
};

/// One point after the other, in memory of its own.
template <class Shape>
class SearchAmong {
  static constexpr int kAxes = std::is_same_v<Shape, NurbsCurve> ? 1 : 2;
  using Place = std::conditional_t<kAxes == 1, NearestOnCurve, NearestOnPatch>;

 public:
  explicit SearchAmong(const Targets<Shape>& targets) : targets_(targets), searches_(targets.shapes().size()) {}

  NearestAmong<Place> nearest(const glm::dvec3& point, std::size_t i) {
    least_ = within_ = reach_ = kInfinity;
    best_.reset();
    near_ = targets_.space().enter(point, kOutOfBoxes);
    push(targets_.tree().levels() - 1, 0);
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (next.squared > reach_) continue;
      breathe(1024);
      if (next.level > 0) push(next.level - 1, next.index);
      else look_at(next.index, point, i);
    }
    if (!best_) throw PointAtInfinity("no point of the shapes is finite");
    return *best_;
  }

 private:
  struct Waiting {
    double squared;
    std::size_t level;  ///< 0: a shape; above it a group of the tree
    std::size_t index;
  };

  /// The boxes of a group that may hold the nearest place, the nearest one last.
  void push(std::size_t level, std::size_t group) {
    const std::size_t first = group * BoxTree::kGroup;
    std::array<double, BoxTree::kGroup> squared;
    kernels_.box_distances(targets_.tree().group(level, group), &near_.at.x, squared.data());
    const std::size_t before = waiting_.size();
    const std::size_t count = std::min(BoxTree::kGroup, targets_.tree().count(level) - first);
    for (std::size_t i = 0; i < count; ++i) {
      if (squared[i] > reach_) continue;
      waiting_.push_back({squared[i], level, first + i});
    }
    const auto nearest = std::min_element(waiting_.begin() + static_cast<std::ptrdiff_t>(before), waiting_.end(),
                                          [](const Waiting& a, const Waiting& b) { return a.squared < b.squared; });
    if (nearest != waiting_.end()) std::swap(*nearest, waiting_.back());
  }

  void look_at(std::size_t number, const glm::dvec3& point, std::size_t i) {
    const Shape& shape = *targets_.shapes()[number];
    const BoxedPieces& pieces = boxed_pieces(shape);
    const NearSpace& space = pieces.space();
    const NearPoint near = space.enter(point);
    const double within = within_ / space.length(1.0);
    if (!searches_[number]) searches_[number].emplace(pieces);
    const NearestPlace place = searches_[number]->nearest(near.at, near.moved || !(within < kInfinity) ? kInfinity : within);
    if (place.found()) offer(number, on_shape(shape, space, place, distance_to(place, near, point, i, space)));
  }

  void offer(std::size_t number, const Place& place) {
    least_ = std::min(least_, place.distance);
    within_ = least_ + kRoundingOfShape * least_ + targets_.space().length(kRoundingOfShape);
    const bool stays = best_ && best_->place.distance <= within_ && (place.distance > within_ || best_->shape < number);
    if (!stays) best_ = {number, place};
    if (near_.moved) return;
    const double reach = (1.0 + kRoundingOfShape) * (within_ / targets_.space().length(1.0)) + kRoundingOfShape;
    reach_ = reach < kInfinity ? reach * reach : kInfinity;
  }

  const Targets<Shape>& targets_;
  const Kernels& kernels_ = kernels();
  std::vector<std::optional<NearestSearch<kAxes>>> searches_;
  std::vector<Waiting> waiting_;
  NearPoint near_{};
  std::optional<NearestAmong<Place>> best_;
  double least_ = kInfinity;   ///< of the distances that were found
  double within_ = kInfinity;  ///< places no farther than that are as near
  double reach_ = kInfinity;   ///< its square in the space of all
};

template <class Shape, class Found>
void search_all(std::span<const Shape* const> shapes, std::span<const glm::dvec3> points, std::span<Found> out, int threads) {
  constexpr std::size_t kSteps = 4096;
  const Targets<Shape> targets(shapes);
  require_finite(points, "points");
  in_ranges(points.size(), kSteps, threads, [&](std::size_t begin, std::size_t end) {
    SearchAmong<Shape> search(targets);
    for (std::size_t i = begin; i < end; ++i) out[i] = search.nearest(points[i], i);
  });
}

}  // namespace

void nearest_among(std::span<const NurbsCurve* const> curves, std::span<const glm::dvec3> points,
                   std::span<NearestAmong<NearestOnCurve>> out, int threads) {
  search_all(curves, points, out, threads);
}

void nearest_among(std::span<const NurbsPatch* const> patches, std::span<const glm::dvec3> points,
                   std::span<NearestAmong<NearestOnPatch>> out, int threads) {
  search_all(patches, points, out, threads);
}

}  // namespace splinecore
