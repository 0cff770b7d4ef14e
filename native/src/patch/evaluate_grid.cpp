#include <vector>

#include "base/parallel.hpp"
#include "grid.hpp"
#include "normal.hpp"
#include "settled.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/patch/evaluate.hpp"

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
void grid_points(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<Real> out,
                 AtInfinity at_infinity, int threads) {
  if (out.empty()) return;
  const GridForm form = form_of(patch);
  const GridColumns columns(v);
  const std::size_t steps = steps_of_row(columns, u, v, 1);
  in_ranges(u.size(), steps / kStepsAtOnce + 1, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> scratch(columns.scratch_size(1));
    for (std::size_t i = begin; i < end; ++i) {
      breathe(steps);
      Real* const row = &out[3 * v.size() * i];
      const int found = points_of(form, grid_row(u, i), columns.blocks(), scratch.data(), row);
      if (found != 0) settle_row(patch, u, i, v, at_infinity, row);
    }
  });
}

/// Puts in order what is no number among the normals of a row whose points are there.
template <class Real>
void settle_normals(const NormalFinder& finder, const Samples& u, std::size_t i, const Samples& v,
                    AtInfinity at_infinity, const Real* points, Real* normals) {
  for (std::size_t j = 0; j < v.size(); ++j) {
    if (is_number(normals + 3 * j)) continue;
    const PatchOptions options{u.side(i), v.side(j), at_infinity};
    const bool is_there = is_number(points + 3 * j);
    store(is_there ? finder.limit(u.parameter(i), v.parameter(j), options) : glm::dvec3(kNan), normals + 3 * j);
  }
}

/// Points and normals of one row after the other of a grid.
template <class Real>
class NormalRows {
 public:
  NormalRows(const NurbsPatch& patch, const NormalFinder& finder, const Samples& v, const GridColumns& columns)
      : patch_(patch), finder_(finder), v_(v), columns_(columns), scratch_(columns.scratch_size(2)),
        others_(finder.is_moved() ? 3 * v.size() : 0) {}

  void write(const Samples& u, std::size_t i, AtInfinity at_infinity, Real* points, Real* normals) {
    const GridRow row = grid_row(u, i, finder_.reach(), finder_.scale(Axis::u), slopes_);
    Real* const seen = finder_.is_moved() ? others_.data() : points;
    int found = normals_of(form_of(finder_.seen()), row, columns_.blocks(), scratch_.data(), seen, normals);
    if (finder_.is_moved()) {
      found |= points_of(form_of(patch_), row, columns_.blocks(), scratch_.data(), points);
    }
    if ((found & kNotFinite) != 0) settle_row(patch_, u, i, v_, at_infinity, points);
    if (found != 0) settle_normals(finder_, u, i, v_, at_infinity, points, normals);
  }

 private:
  const NurbsPatch& patch_;
  const NormalFinder& finder_;
  const Samples& v_;
  const GridColumns& columns_;
  std::vector<double> scratch_;
  std::vector<double> slopes_;
  std::vector<Real> others_;
};

template <class Real>
void grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<Real> points,
                       std::span<Real> normals, AtInfinity at_infinity, int threads) {
  if (points.empty()) return;
  const NormalFinder finder(patch);
  const GridColumns columns(v, finder.reach(), finder.scale(Axis::v));
  const std::size_t steps = steps_of_row(columns, u, v, 3);
  in_ranges(u.size(), steps / kStepsAtOnce + 1, threads, [&](std::size_t begin, std::size_t end) {
    NormalRows<Real> rows(patch, finder, v, columns);
    for (std::size_t i = begin; i < end; ++i) {
      breathe(steps);
      const std::size_t first = 3 * v.size() * i;
      rows.write(u, i, at_infinity, &points[first], &normals[first]);
    }
  });
}

/// Both directions of a grid, with derivatives up to the given order.
struct GridSamples {
  Samples u;
  Samples v;
  GridSamples(const NurbsPatch& patch, std::span<const double> at_u, std::span<const double> at_v, int order,
              PatchOptions options)
      : u(Samples::make(patch.knot_vector(Axis::u), at_u, order, options.side_u, "u")),
        v(Samples::make(patch.knot_vector(Axis::v), at_v, order, options.side_v, "v")) {}
};

}  // namespace

void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<double> out, PatchOptions options) {
  const GridSamples at(patch, u, v, 0, options);
  grid_points(patch, at.u, at.v, out, options.at_infinity, options.threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<double> points,
                                std::span<double> normals, PatchOptions options) {
  const GridSamples at(patch, u, v, 1, options);
  grid_with_normals(patch, at.u, at.v, points, normals, options.at_infinity, options.threads);
}

void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<float> out, PatchOptions options) {
  const GridSamples at(patch, u, v, 0, options);
  grid_points(patch, at.u, at.v, out, options.at_infinity, options.threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<float> points,
                                std::span<float> normals, PatchOptions options) {
  const GridSamples at(patch, u, v, 1, options);
  grid_with_normals(patch, at.u, at.v, points, normals, options.at_infinity, options.threads);
}

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<double> points,
                   AtInfinity at_infinity, int threads) {
  grid_points(patch, u, v, points, at_infinity, threads);
}

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<float> points,
                   AtInfinity at_infinity, int threads) {
  grid_points(patch, u, v, points, at_infinity, threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<double> points, std::span<double> normals,
                                AtInfinity at_infinity, int threads) {
  grid_with_normals(patch, u, v, points, normals, at_infinity, threads);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<float> points, std::span<float> normals, AtInfinity at_infinity, int threads) {
  grid_with_normals(patch, u, v, points, normals, at_infinity, threads);
}

}  // namespace splinecore
