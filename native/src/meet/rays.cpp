#include "splinecore/meet/rays.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/sort_by.hpp"
#include "ray_search.hpp"
#include "shape_box.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kStepsOfRay = 4096;

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
