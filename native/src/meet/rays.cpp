#include "splinecore/meet/rays.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "base/parallel.hpp"
#include "base/sort_by.hpp"
#include "ray_search.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kStepsOfRay = 4096;

/// The box of a patch in the space of its set.
TreeBox box_in(const NearSpace& space, const BoxedPieces& pieces) {
  constexpr double kEverywhere = 0x1p400;
  constexpr double kOut = 0x1p500;
  const BoxTree& tree = pieces.tree();
  const BoxTree::Group& root = tree.group(tree.levels() - 1, 0);
  std::vector<TreeBox> boxes;
  for (std::size_t i = 0; i < tree.count(tree.levels() - 1); ++i) {
    const glm::dvec3 middle(root.middle[0][i], root.middle[1][i], root.middle[2][i]);
    const glm::dvec3 half(root.half[0][i], root.half[1][i], root.half[2][i]);
    if (std::max({half.x, half.y, half.z}) > kEverywhere) return {glm::dvec3(-kOut), glm::dvec3(kOut)};
    const auto corner = [&](double side) { return space.enter(pieces.space().leave(middle + side * half), kOut).at; };
    boxes.push_back({corner(-1.0), corner(1.0)});
  }
  const glm::dvec3 slack(16.0 * (space.rounding() + 0x1p-50));
  const TreeBox all = around(boxes);
  return {all.low - slack, all.high + slack};
}

/// The patches of a set, and a tree of their boxes.
class RayTargets {
 public:
  explicit RayTargets(const PatchSet& set) : space_(set.points()) {
    std::vector<TreeBox> boxes;
    for (std::size_t i = 0; i < set.patches().size(); ++i) {
      patches_.push_back(&nurbs_of(set.patch(i)));
      boxes.push_back(box_in(space_, boxed_pieces(*patches_.back())));
    }
    tree_.emplace(boxes);
  }
  explicit RayTargets(const NurbsPatch& patch) : space_(patch.points()), patches_{&patch} {}

  const NearSpace& space() const noexcept { return space_; }
  const std::vector<const NurbsPatch*>& patches() const noexcept { return patches_; }
  /// None of a single patch.
  const std::optional<BoxTree>& tree() const noexcept { return tree_; }

 private:
  NearSpace space_;
  std::vector<const NurbsPatch*> patches_;
  std::optional<BoxTree> tree_;
};

/// One ray after the other among the patches, in memory of its own.
class TargetSearch {
 public:
  explicit TargetSearch(const RayTargets& targets) : targets_(targets) {
    for (const NurbsPatch* patch : targets.patches()) searches_.emplace_back(*patch, searches_.size());
  }

  void all(const Ray& ray, std::size_t index, const Interval& limits, std::vector<RayHit>& hits) {
    gather(ray, index);
    for (const BoxOnRay& box : met_) {
      const std::vector<RayHit>& found = searches_[box.index].all(ray, index, limits);
      hits.insert(hits.end(), found.begin(), found.end());
    }
    std::ranges::stable_sort(hits, {}, [](const RayHit& hit) { return std::tuple(hit.along, hit.patch, hit.u, hit.v); });
  }

  std::optional<RayHit> first(const Ray& ray, std::size_t index, Interval limits) {
    std::optional<RayHit> best;
    gather(ray, index);
    for (const BoxOnRay& box : met_) {
      const std::vector<RayHit>& found = searches_[box.index].first(ray, index, limits);
      if (found.empty()) continue;
      const auto key = [](const RayHit& hit) { return std::pair(hit.along, hit.patch); };
      if (!best || key(found.front()) < key(*best)) best = found.front();
      limits.end = best->along;
    }
    return best;
  }

 private:
  /// The patches whose boxes the ray's line meets, the nearest first.
  void gather(const Ray& ray, std::size_t index) {
    if (!targets_.tree()) {
      met_.assign(1, {0.0, 0.0, 0});
      return;
    }
    add_leaves_on(NearRay(ray, targets_.space(), index), *targets_.tree(), waiting_, met_);
    sort_by(met_, [](const BoxOnRay& box) { return SortKey{box.near, static_cast<double>(box.index)}; });
  }

  const RayTargets& targets_;
  std::vector<RaySearch> searches_;
  std::vector<std::vector<BoxOnRay>> waiting_;
  std::vector<BoxOnRay> met_;
};

void require_order(const Interval& limits) {
  if (limits.start <= limits.end) return;
  throw InvalidShape("limits = (" + text_of(limits.start) + ", " + text_of(limits.end) + ") are not in order");
}

template <class Write>
void search_all(const RayTargets& targets, std::span<const Ray> rays, const RayOptions& options, Write write) {
  require_order(options.limits);
  in_ranges(rays.size(), kStepsOfRay, options.threads, [&](std::size_t begin, std::size_t end) {
    TargetSearch search(targets);
    for (std::size_t i = begin; i < end; ++i) write(search, i);
  });
}

void write_first(const RayTargets& targets, std::span<const Ray> rays, std::span<std::optional<RayHit>> out,
                 const RayOptions& options) {
  search_all(targets, rays, options,
             [&](TargetSearch& search, std::size_t i) { out[i] = search.first(rays[i], i, options.limits); });
}

std::vector<std::vector<RayHit>> found_by(const RayTargets& targets, std::span<const Ray> rays, const RayOptions& options) {
  std::vector<std::vector<RayHit>> out(rays.size());
  search_all(targets, rays, options,
             [&](TargetSearch& search, std::size_t i) { search.all(rays[i], i, options.limits, out[i]); });
  return out;
}

}  // namespace

void first_hits(const NurbsPatch& patch, std::span<const Ray> rays, std::span<std::optional<RayHit>> out,
                const RayOptions& options) {
  write_first(RayTargets(patch), rays, out, options);
}

void first_hits(const PatchSet& set, std::span<const Ray> rays, std::span<std::optional<RayHit>> out,
                const RayOptions& options) {
  write_first(RayTargets(set), rays, out, options);
}

std::vector<std::vector<RayHit>> all_hits(const NurbsPatch& patch, std::span<const Ray> rays, const RayOptions& options) {
  return found_by(RayTargets(patch), rays, options);
}

std::vector<std::vector<RayHit>> all_hits(const PatchSet& set, std::span<const Ray> rays, const RayOptions& options) {
  return found_by(RayTargets(set), rays, options);
}

}  // namespace splinecore
