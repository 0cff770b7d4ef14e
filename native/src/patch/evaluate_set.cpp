#include "splinecore/patch/evaluate_set.hpp"

#include <optional>

#include "base/call_memory.hpp"
#include "base/parallel.hpp"
#include "evaluate_grid.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// The plan of a grid, made anew where the knots of a patch are others.
class PlanCache {
 public:
  PlanCache(std::span<const double> u, std::span<const double> v, int order, PatchOptions options)
      : u_(u), v_(v), order_(order), options_(options) {}

  const GridPlan& of(const NurbsPatch& patch) {
    const KnotVector& knots_u = patch.knot_vector(Axis::u);
    const KnotVector& knots_v = patch.knot_vector(Axis::v);
    if (known_ && known_->knots_u == knots_u && known_->knots_v == knots_v) return known_->plan;
    known_.reset();
    return known_.emplace(*this, patch).plan;
  }

 private:
  struct Known {
    CallMemory memory;
    KnotVector knots_u;
    KnotVector knots_v;
    Samples u;
    Samples v;
    GridPlan plan;

    Known(const PlanCache& of, const NurbsPatch& patch)
        : knots_u(patch.knot_vector(Axis::u)), knots_v(patch.knot_vector(Axis::v)),
          u(Samples::make(knots_u, of.u_, of.order_, of.options_.side_u, "u", memory.resource())),
          v(Samples::make(knots_v, of.v_, of.order_, of.options_.side_v, "v", memory.resource())),
          plan(of.order_ == 0 ? GridPlan(u, v, memory.resource()) : GridPlan(u, v, patch, memory.resource())) {}
  };

  std::span<const double> u_;
  std::span<const double> v_;
  int order_;
  PatchOptions options_;
  std::optional<Known> known_;
};

/// Calls work(patch, plan, first number, count of numbers) for the patches from begin to end.
template <class Work>
void for_some_patches(const PatchSet& set, std::size_t begin, std::size_t end, std::span<const double> u,
                      std::span<const double> v, int order, PatchOptions options, Work work) {
  PlanCache plans(u, v, order, options);
  const std::size_t count = 3 * u.size() * v.size();
  for (std::size_t i = begin; i < end; ++i) {
    const NurbsPatch& patch = nurbs_of(set.patch(i));
    try {
      work(patch, plans.of(patch), i * count, count);
    } catch (const InvalidShape& error) {
      throw InvalidShape("patches" + index_text(i) + ": " + error.what());
    } catch (const PointAtInfinity& error) {
      throw PointAtInfinity("patches" + index_text(i) + ": " + error.what());
    }
  }
}

/// Calls work(…, threads) for every patch: several patches at once where there are many, else each on several threads.
template <class Work>
void for_each_patch(const PatchSet& set, std::span<const double> u, std::span<const double> v, int order,
                    PatchOptions options, Work work) {
  constexpr std::size_t kMany = 8;
  constexpr std::size_t kStepsOfPoint = 16;
  const std::size_t patches = set.patches().size();
  const auto some = [&](std::size_t begin, std::size_t end, int threads) {
    for_some_patches(set, begin, end, u, v, order, options,
                     [&](const NurbsPatch& patch, const GridPlan& plan, std::size_t first, std::size_t count) {
                       work(patch, plan, first, count, threads);
                     });
  };
  if (patches < kMany) return some(0, patches, options.threads);
  const std::size_t steps = kStepsOfPoint * static_cast<std::size_t>(order + 1) * u.size() * v.size();
  in_ranges(patches, steps, options.threads, [&](std::size_t begin, std::size_t end) { some(begin, end, 1); });
}

template <class Real>
void points_of(const PatchSet& set, std::span<const double> u, std::span<const double> v, std::span<Real> out,
               PatchOptions options) {
  for_each_patch(set, u, v, 0, options, [&](const NurbsPatch& patch, const GridPlan& plan,
                                            std::size_t first, std::size_t count, int threads) {
    evaluate_grid(patch, plan, out.subspan(first, count), options.at_infinity, threads);
  });
}

template <class Real>
void normals_of(const PatchSet& set, std::span<const double> u, std::span<const double> v, std::span<Real> points,
                std::span<Real> normals, PatchOptions options) {
  for_each_patch(set, u, v, 1, options, [&](const NurbsPatch& patch, const GridPlan& plan,
                                            std::size_t first, std::size_t count, int threads) {
    evaluate_grid_with_normals(patch, plan, points.subspan(first, count), normals.subspan(first, count),
                               options.at_infinity, threads);
  });
}

}  // namespace

void evaluate_grid(const PatchSet& set, std::span<const double> u, std::span<const double> v, std::span<double> out,
                   PatchOptions options) {
  points_of(set, u, v, out, options);
}

void evaluate_grid(const PatchSet& set, std::span<const double> u, std::span<const double> v, std::span<float> out,
                   PatchOptions options) {
  points_of(set, u, v, out, options);
}

void evaluate_grid_with_normals(const PatchSet& set, std::span<const double> u, std::span<const double> v,
                                std::span<double> points, std::span<double> normals, PatchOptions options) {
  normals_of(set, u, v, points, normals, options);
}

void evaluate_grid_with_normals(const PatchSet& set, std::span<const double> u, std::span<const double> v,
                                std::span<float> points, std::span<float> normals, PatchOptions options) {
  normals_of(set, u, v, points, normals, options);
}

}  // namespace splinecore
