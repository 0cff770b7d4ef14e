#include "splinecore/patch/evaluate_set.hpp"

#include <optional>

#include "base/parallel.hpp"
#include "evaluate_grid.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// The samples of one direction, made anew where the knots are others.
class AxisCache {
 public:
  AxisCache(std::span<const double> parameters, int order, Side side, const char* name)
      : parameters_(parameters), order_(order), side_(side), name_(name) {}

  bool has(const KnotVector& knots) const { return knots_ && *knots_ == knots; }

  void move_to(const KnotVector& knots) {
    if (has(knots)) return;
    samples_ = Samples::make(knots, parameters_, order_, side_, name_);
    knots_ = knots;
  }

  const Samples& samples() const { return *samples_; }

 private:
  std::span<const double> parameters_;
  int order_;
  Side side_;
  const char* name_;
  std::optional<KnotVector> knots_;
  std::optional<Samples> samples_;
};

/// The plan of a grid, made anew where the knots of a patch are others.
class PlanCache {
 public:
  PlanCache(std::span<const double> u, std::span<const double> v, int order, PatchOptions options)
      : order_(order), u_(u, order, options.side_u, "u"), v_(v, order, options.side_v, "v") {}

  const GridPlan& of(const NurbsPatch& patch) {
    const KnotVector& knots_u = patch.knot_vector(Axis::u);
    const KnotVector& knots_v = patch.knot_vector(Axis::v);
    if (plan_ && u_.has(knots_u) && v_.has(knots_v)) return *plan_;
    plan_.reset();
    u_.move_to(knots_u);
    v_.move_to(knots_v);
    if (order_ == 0) return plan_.emplace(u_.samples(), v_.samples());
    return plan_.emplace(u_.samples(), v_.samples(), patch);
  }

 private:
  int order_;
  AxisCache u_;
  AxisCache v_;
  std::optional<GridPlan> plan_;
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
