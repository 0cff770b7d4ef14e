#include "splinecore/patch/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "basis/axis_places.hpp"
#include "grid.hpp"
#include "normal.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/quotient.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Real>
bool is_number(const Real* values) {
  return std::isfinite(values[0]) && std::isfinite(values[1]) && std::isfinite(values[2]);
}

template <class Real>
void store(const glm::dvec3& value, Real* out) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = static_cast<Real>(value[axis]);
}

/// The point of weights along u and v by a division, where the kernels found no number. @throws PointAtInfinity
glm::dvec3 settled_point(const NurbsPatch& patch, const glm::dvec4& h, double u, double v, AtInfinity at_infinity) {
  const glm::dvec3 point = patch.rational() ? project(h) : glm::dvec3(h);
  if (is_finite(point)) return point;
  if (at_infinity == AtInfinity::raise) throw PointAtInfinity(u, v);
  return glm::dvec3(kNan);
}

const double* corner_of(const GridForm& form, int first_u, int first_v) {
  return form.points + 4 * (static_cast<std::size_t>(first_u) * form.width + static_cast<std::size_t>(first_v));
}

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

template <class Real>
void grid_points(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<Real> out,
                 AtInfinity at_infinity) {
  if (out.empty()) return;
  const GridForm form = form_of(patch);
  const GridColumns columns(v);
  std::vector<double> scratch(columns.scratch_size(1));
  Real* next = out.data();
  for (std::size_t i = 0; i < u.size(); ++i, next += 3 * v.size()) {
    breathe(scratch.size() * u.weights(0).size() + 4 * v.size() * (v.weights(0).size() + 4));
    const int found = points_of(form, grid_row(u, i), columns.blocks(), scratch.data(), next);
    if (found != 0) settle_row(patch, u, i, v, at_infinity, next);
  }
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
  NormalRows(const NurbsPatch& patch, const NormalFinder& finder, const Samples& v)
      : patch_(patch), finder_(finder), v_(v), columns_(v, finder.reach(), finder.scale(Axis::v)), scratch_(columns_.scratch_size(2)),
        others_(finder.is_moved() ? 3 * v.size() : 0) {}

  void write(const Samples& u, std::size_t i, AtInfinity at_infinity, Real* points, Real* normals) {
    breathe(2 * scratch_.size() * u.weights(0).size() + 12 * v_.size() * (v_.weights(0).size() + 4));
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
  GridColumns columns_;
  std::vector<double> scratch_;
  std::vector<double> slopes_;
  std::vector<Real> others_;
};

template <class Real>
void grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<Real> points,
                       std::span<Real> normals, AtInfinity at_infinity) {
  if (points.empty()) return;
  const NormalFinder finder(patch);
  NormalRows<Real> rows(patch, finder, v);
  for (std::size_t i = 0, next = 0; i < u.size(); ++i, next += 3 * v.size()) {
    rows.write(u, i, at_infinity, &points[next], &normals[next]);
  }
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

constexpr std::size_t kPart = AxisPlaces::kMost;

/// Calls visit(form, pairs, begin, count) for some pairs after the other.
template <class Visit>
void for_each_part(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v, int order,
                   PatchOptions options, Visit visit) {
  const GridForm form = form_of(patch);
  AxisPlaces places_u(patch.knot_vector(Axis::u), order, "u");
  AxisPlaces places_v(patch.knot_vector(Axis::v), order, "v");
  std::array<PairPlace, kPart> part;
  for (std::size_t begin = 0; begin < u.size(); begin += kPart) {
    const std::size_t count = std::min(kPart, u.size() - begin);
    places_u.locate(u.subspan(begin, count), begin, options.side_u);
    places_v.locate(v.subspan(begin, count), begin, options.side_v);
    for (std::size_t i = 0; i < count; ++i) {
      places_u.write(i, part[i].u);
      places_v.write(i, part[i].v);
      part[i].corner = corner_of(form, places_u.first(i), places_v.first(i));
    }
    breathe(count * 4 * static_cast<std::size_t>((form.degree_u + 1) * (form.degree_v + 1)));
    visit(form, part.data(), begin, count);
  }
}

/// The homogeneous derivatives at one pair.
struct PairSums {
  PairSums(const NurbsPatch& patch, int highest)
      : form(form_of(patch)), order(highest), u(patch.knot_vector(Axis::u), highest),
        v(patch.knot_vector(Axis::v), highest), sums(static_cast<std::size_t>((highest + 1) * (highest + 1))) {}

  const std::vector<glm::dvec4>& at(double at_u, double at_v, PatchOptions options) {
    u.move_to(at_u, options.side_u);
    v.move_to(at_v, options.side_v);
    breathe(4 * sums.size() * static_cast<std::size_t>(form.degree_v + 1));
    kernels().pair_sums(form, order, corner_of(form, u.first(), v.first()), u.all_weights().data(),
                        v.all_weights().data(), &sums.data()->x);
    return sums;
  }

  GridForm form;
  int order;
  Stencil u;
  Stencil v;
  std::vector<glm::dvec4> sums;
};

glm::dvec3 settled_pair(const NurbsPatch& patch, double u, double v, PatchOptions options) {
  const double at_u = patch.knot_vector(Axis::u).admit(u, options.side_u);
  const double at_v = patch.knot_vector(Axis::v).admit(v, options.side_v);
  PairSums sums(patch, 0);
  return settled_point(patch, sums.at(at_u, at_v, options)[0], at_u, at_v, options.at_infinity);
}

/// Puts in order what is no number among the point and the derivatives of one pair.
void settle_pair(const NurbsPatch& patch, double u, double v, PatchOptions options, std::span<double> values) {
  if (!is_number(values.data())) store(settled_pair(patch, u, v, options), values.data());
  for (std::size_t k = 1; 3 * k < values.size(); ++k) {
    if (is_number(&values[3 * k])) continue;
    if (options.at_infinity == AtInfinity::raise) {
      throw InvalidShape("a derivative at u = " + text_of(u) + ", v = " + text_of(v) + " is too large for a number");
    }
    store(glm::dvec3(kNan), &values[3 * k]);
  }
}

template <class Real>
void evaluate_pairs(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                    std::span<Real> out, PatchOptions options) {
  std::array<double, 3 * kPart> values;
  for_each_part(patch, u, v, 0, options,
                [&](const GridForm& form, const PairPlace* pairs, std::size_t begin, std::size_t count) {
                  const int found = kernels().pair_points(form, pairs, count, values.data());
                  for (std::size_t i = 0; found != 0 && i < count; ++i) {
                    settle_pair(patch, u[begin + i], v[begin + i], options, {&values[3 * i], 3});
                  }
                  for (std::size_t i = 0; i < 3 * count; ++i) out[3 * begin + i] = static_cast<Real>(values[i]);
                });
}

}  // namespace

void evaluate(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
              std::span<double> out, PatchOptions options) {
  evaluate_pairs(patch, u, v, out, options);
}

void evaluate(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
              std::span<float> out, PatchOptions options) {
  evaluate_pairs(patch, u, v, out, options);
}

void evaluate_with_normals(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                           std::span<double> points, std::span<double> normals, PatchOptions options) {
  const NormalFinder finder(patch);
  const NormalForm normal{rounding_of(finder.reach()), finder.scale(Axis::u), finder.scale(Axis::v)};
  for_each_part(finder.seen(), u, v, 1, options,
                [&](const GridForm& form, const PairPlace* pairs, std::size_t begin, std::size_t count) {
                  double* const to = &normals[3 * begin];
                  const int found = kernels().pair_normals(form, normal, pairs, count, &points[3 * begin], to);
                  for (std::size_t i = begin; found != 0 && i < begin + count; ++i) {
                    if (!is_number(&points[3 * i])) store(settled_pair(patch, u[i], v[i], options), &points[3 * i]);
                    if (is_number(&normals[3 * i])) continue;
                    const double at_u = patch.knot_vector(Axis::u).admit(u[i], options.side_u);
                    const double at_v = patch.knot_vector(Axis::v).admit(v[i], options.side_v);
                    store(is_number(&points[3 * i]) ? finder.limit(at_u, at_v, options) : glm::dvec3(kNan),
                          &normals[3 * i]);
                  }
                });
  if (finder.is_moved()) evaluate(patch, u, v, points, options);
}

void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<double> out, PatchOptions options) {
  const GridSamples at(patch, u, v, 0, options);
  grid_points(patch, at.u, at.v, out, options.at_infinity);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<double> points,
                                std::span<double> normals, PatchOptions options) {
  const GridSamples at(patch, u, v, 1, options);
  grid_with_normals(patch, at.u, at.v, points, normals, options.at_infinity);
}

void evaluate_grid(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   std::span<float> out, PatchOptions options) {
  const GridSamples at(patch, u, v, 0, options);
  grid_points(patch, at.u, at.v, out, options.at_infinity);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, std::span<const double> u,
                                std::span<const double> v, std::span<float> points,
                                std::span<float> normals, PatchOptions options) {
  const GridSamples at(patch, u, v, 1, options);
  grid_with_normals(patch, at.u, at.v, points, normals, options.at_infinity);
}

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<double> points,
                   AtInfinity at_infinity) {
  grid_points(patch, u, v, points, at_infinity);
}

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<float> points,
                   AtInfinity at_infinity) {
  grid_points(patch, u, v, points, at_infinity);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<double> points, std::span<double> normals,
                                AtInfinity at_infinity) {
  grid_with_normals(patch, u, v, points, normals, at_infinity);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<float> points, std::span<float> normals, AtInfinity at_infinity) {
  grid_with_normals(patch, u, v, points, normals, at_infinity);
}

void first_derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                       std::span<double> out, PatchOptions options) {
  for_each_part(patch, u, v, 1, options,
                [&](const GridForm& form, const PairPlace* pairs, std::size_t begin, std::size_t count) {
                  const int found = kernels().pair_slopes(form, pairs, count, &out[9 * begin]);
                  for (std::size_t i = begin; found != 0 && i < begin + count; ++i) {
                    settle_pair(patch, u[i], v[i], options, out.subspan(9 * i, 9));
                  }
                });
}

void derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                 int order, std::span<double> out, PatchOptions options) {
  require_order(order);
  if (order == 0) return evaluate(patch, u, v, out, options);
  const std::size_t width = static_cast<std::size_t>(order) + 1;
  const std::size_t size = width * width;
  std::vector<double> first(9 * u.size());
  first_derivatives(patch, u, v, first, {options.side_u, options.side_v, AtInfinity::nan});
  PairSums sums(patch, order);
  std::vector<glm::dvec3> values(size);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto row = out.subspan(3 * size * i, 3 * size);
    const double at_u = patch.knot_vector(Axis::u).admit(u[i], options.side_u);
    const double at_v = patch.knot_vector(Axis::v).admit(v[i], options.side_v);
    const std::vector<glm::dvec4>& homogeneous = sums.at(at_u, at_v, options);
    for (std::size_t kl = 0; kl < size; ++kl) values[kl] = glm::dvec3(homogeneous[kl]);
    if (patch.rational()) quotient_derivatives(homogeneous, order, values);
    for (std::size_t kl = 0; kl < size; ++kl) store(values[kl], &row[3 * kl]);
    // The lowest are the same, bit for bit, whatever the order.
    std::copy_n(&first[9 * i], 3, &row[0]);
    std::copy_n(&first[9 * i + 3], 3, &row[3 * width]);
    std::copy_n(&first[9 * i + 6], 3, &row[3]);
    settle_pair(patch, at_u, at_v, options, row);
  }
}

}  // namespace splinecore
