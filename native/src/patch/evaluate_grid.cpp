#include "evaluate_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/call_memory.hpp"
#include "base/parallel.hpp"
#include "normal.hpp"
#include "settled.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

int points_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, double* out) {
  return kernels().grid_points(form, row, blocks, scratch, out);
}
int points_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, float* out) {
  return kernels().grid_points_single(form, row, blocks, scratch, out);
}
int normals_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, double* out,
               double* normals) {
  return kernels().grid_normals(form, row, blocks, scratch, out, normals);
}
int normals_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, float* out,
               float* normals) {
  return kernels().grid_normals_single(form, row, blocks, scratch, out, normals);
}

/// Puts in order what is no number among the points of a row.
template <class Real>
void settle_row(const NurbsPatch& patch, const Samples& u, std::size_t i, const Samples& v, AtInfinity at_infinity,
                Real* points) {
  const GridForm form = form_of(patch);
  for (std::size_t j = 0; j < v.size(); ++j) {
    if (is_number(points + 3 * j)) continue;
    glm::dvec4 h;
    kernels().pair_sums(form, 0, corner_of(form, u.first(i), v.first(j)), u.weights(i).data(), v.weights(j).data(), &h.x);
    store(settled_point(patch, h, u.parameter(i), v.parameter(j), at_infinity), points + 3 * j);
  }
}

/// Steps of the kernels for a row of a grid with so many sums.
std::size_t steps_of_row(const GridColumns& columns, const Samples& u, const Samples& v, std::size_t sums) {
  return sums * (columns.scratch_size(1) * u.weights(0).size() + 4 * v.size() * (v.weights(0).size() + 4));
}

template <class Real>
void grid_points(const NurbsPatch& patch, const GridPlan& plan, std::span<Real> out, AtInfinity at_infinity,
                 int threads) {
  if (out.empty()) return;
  const GridForm form = form_of(patch);
  const GridColumns& columns = plan.columns;
  const GridBlocks blocks = columns.blocks(out.size_bytes());
  const std::size_t steps = steps_of_row(columns, plan.u, plan.v, 1);
  in_ranges(plan.u.size(), steps / kStepsAtOnce + 1, threads, [&](std::size_t begin, std::size_t end) {
    CallMemory memory;
    std::pmr::vector<double> scratch(columns.scratch_size(1), memory.resource());
    for (std::size_t i = begin; i < end; ++i) {
      breathe(steps);
      Real* const row = &out[3 * plan.v.size() * i];
      const int found = points_of(form, grid_row(plan.u, i), blocks, scratch.data(), row);
      if (found != 0) settle_row(patch, plan.u, i, plan.v, at_infinity, row);
    }
  });
}

/// Puts in order what is no number among the normals of a row whose points are there.
template <class Real>
void settle_normals(const NormalFinder& finder, const PoleNormals& at_poles, const GridPlan& plan, std::size_t i,
                    AtInfinity at_infinity, const Real* points, Real* normals) {
  const auto settle = [&](std::size_t j) {
    glm::dvec3 normal = glm::dvec3(kNan);
    if (is_number(points + 3 * j)) {
      normal = at_poles.at(i, j);
      const PatchOptions options{plan.u.side(i), plan.v.side(j), at_infinity};
      if (!is_number(&normal.x)) normal = finder.limit(plan.u.parameter(i), plan.v.parameter(j), options);
    }
    store(normal, normals + 3 * j);
  };
  constexpr std::size_t kSome = 8;  // which are looked at together: few rows have more than one that is weak
  for (std::size_t begin = 0; begin < plan.v.size(); begin += kSome) {
    const std::size_t end = std::min(begin + kSome, plan.v.size());
    Real sum = 0;
    for (std::size_t j = begin; j < end; ++j) sum += normals[3 * j];
    for (std::size_t j = begin; !std::isfinite(sum) && j < end; ++j) {
      if (!std::isfinite(normals[3 * j])) settle(j);
    }
  }
}

template <class Real>
void grid_with_normals(const NurbsPatch& patch, const GridPlan& plan, std::span<Real> points, std::span<Real> normals,
                       AtInfinity at_infinity, int threads) {
  if (points.empty()) return;
  const NormalFinder finder(patch);
  CallMemory of_poles;
  const PoleNormals at_poles(finder.poles(), finder.rounding(), plan, of_poles.resource());
  const GridForm form = form_of(patch);
  const GridForm seen_form = form_of(finder.seen());
  const GridBlocks blocks = plan.columns.blocks(points.size_bytes() + normals.size_bytes());
  const std::size_t numbers = 3 * plan.v.size();
  const std::size_t steps = steps_of_row(plan.columns, plan.u, plan.v, 3);
  in_ranges(plan.u.size(), steps / kStepsAtOnce + 1, threads, [&](std::size_t begin, std::size_t end) {
    CallMemory memory;
    std::pmr::vector<double> scratch(plan.columns.scratch_size(2), memory.resource());
    std::pmr::vector<Real> seen_points(finder.is_moved() ? numbers : 0, memory.resource());
    for (std::size_t i = begin; i < end; ++i) {
      breathe(steps);
      const GridRow row = plan.rows->row(i, finder.rounding());
      Real* const to = &points[numbers * i];
      Real* const to_normals = &normals[numbers * i];
      Real* const seen = finder.is_moved() ? seen_points.data() : to;
      int found = normals_of(seen_form, row, blocks, scratch.data(), seen, to_normals);
      if (finder.is_moved()) found |= points_of(form, row, blocks, scratch.data(), to);
      if ((found & kNotFinite) != 0) settle_row(patch, plan.u, i, plan.v, at_infinity, to);
      if (found != 0) settle_normals(finder, at_poles, plan, i, at_infinity, to, to_normals);
    }
  });
}

/// Both directions of a grid.
struct GridSamples {
  CallMemory memory;
  Samples u;
  Samples v;
  GridSamples(const NurbsPatch& patch, std::span<const double> at_u, std::span<const double> at_v, int order,
              PatchOptions options)
      : u(Samples::make(patch.knot_vector(Axis::u), at_u, order, options.side_u, "u", memory.resource())),
        v(Samples::make(patch.knot_vector(Axis::v), at_v, order, options.side_v, "v", memory.resource())) {}
};

}  // namespace

void evaluate_grid(const NurbsPatch& patch, const GridPlan& plan, std::span<double> points, AtInfinity at_infinity,
                   int threads) {
  grid_points(patch, plan, points, at_infinity, threads);
}

void evaluate_grid(const NurbsPatch& patch, const GridPlan& plan, std::span<float> points, AtInfinity at_infinity,
                   int threads) {
  grid_points(patch, plan, points, at_infinity, threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const GridPlan& plan, std::span<double> points,
                                std::span<double> normals, AtInfinity at_infinity, int threads) {
  grid_with_normals(patch, plan, points, normals, at_infinity, threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const GridPlan& plan, std::span<float> points,
                                std::span<float> normals, AtInfinity at_infinity, int threads) {
  grid_with_normals(patch, plan, points, normals, at_infinity, threads);
}

void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<double> out, PatchOptions options) {
  const GridSamples at(patch, u, v, 0, options);
  evaluate_grid(patch, at.u, at.v, out, options.at_infinity, options.threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<double> points,
                                std::span<double> normals, PatchOptions options) {
  const GridSamples at(patch, u, v, 1, options);
  evaluate_grid_with_normals(patch, at.u, at.v, points, normals, options.at_infinity, options.threads);
}

void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<float> out, PatchOptions options) {
  const GridSamples at(patch, u, v, 0, options);
  evaluate_grid(patch, at.u, at.v, out, options.at_infinity, options.threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<float> points,
                                std::span<float> normals, PatchOptions options) {
  const GridSamples at(patch, u, v, 1, options);
  evaluate_grid_with_normals(patch, at.u, at.v, points, normals, options.at_infinity, options.threads);
}

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<double> points,
                   AtInfinity at_infinity, int threads) {
  CallMemory memory;
  grid_points(patch, GridPlan(u, v, memory.resource()), points, at_infinity, threads);
}

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<float> points,
                   AtInfinity at_infinity, int threads) {
  CallMemory memory;
  grid_points(patch, GridPlan(u, v, memory.resource()), points, at_infinity, threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<double> points, std::span<double> normals,
                                AtInfinity at_infinity, int threads) {
  CallMemory memory;
  grid_with_normals(patch, GridPlan(u, v, patch, memory.resource()), points, normals, at_infinity, threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<float> points, std::span<float> normals, AtInfinity at_infinity, int threads) {
  CallMemory memory;
  grid_with_normals(patch, GridPlan(u, v, patch, memory.resource()), points, normals, at_infinity, threads);
}

}  // namespace splinecore
