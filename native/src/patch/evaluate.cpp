#include "splinecore/patch/evaluate.hpp"

#include <limits>
#include <vector>

#include "normal.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

glm::dvec3 finite_or_nan(const glm::dvec3& point, double u, double v, AtInfinity at_infinity) {
  if (is_finite(point)) return point;
  if (at_infinity == AtInfinity::raise) throw PointAtInfinity(u, v);
  return glm::dvec3(kNan);
}

template <class Real>
void store(const glm::dvec3& value, Real* out) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = static_cast<Real>(value[axis]);
}

/// The control points of the curve in v that the patch is where u has these weights.
void collapse_u(const NurbsPatch& patch, std::span<const double> weights, int first,
                std::span<glm::dvec4> row) {
  const std::size_t width = row.size();
  const glm::dvec4* points = patch.homogeneous_points().data() + first * width;
  breathe(4 * weights.size() * width);
  for (std::size_t j = 0; j < width; ++j) row[j] = weights[0] * points[j];
  for (std::size_t i = 1; i < weights.size(); ++i) {
    for (std::size_t j = 0; j < width; ++j) row[j] += weights[i] * points[i * width + j];
  }
}

/// The sum over the (p + 1)(q + 1) control points that one pair of parameters depends on.
glm::dvec4 tensor_sum(const NurbsPatch& patch, std::span<const double> weights_u, int first_u,
                      std::span<const double> weights_v, int first_v) {
  const int width = patch.knot_vector(Axis::v).unrolled_count();
  const glm::dvec4* points = patch.homogeneous_points().data() + first_u * width + first_v;
  breathe(4 * weights_u.size() * weights_v.size());
  glm::dvec4 sum = weights_u[0] * weighted_sum(weights_v, points);
  for (std::size_t i = 1; i < weights_u.size(); ++i) {
    sum += weights_u[i] * weighted_sum(weights_v, points + i * width);
  }
  return sum;
}

/// Calls visit(i, u, v, stencil_u, stencil_v) for every pair.
template <class Visit>
void for_each_pair(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                   int order, PatchOptions options, Visit visit) {
  const KnotVector& knots_u = patch.knot_vector(Axis::u);
  const KnotVector& knots_v = patch.knot_vector(Axis::v);
  Stencil stencil_u(knots_u, order);
  Stencil stencil_v(knots_v, order);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double at_u = knots_u.admit(u[i], options.side_u, i, "u");
    const double at_v = knots_v.admit(v[i], options.side_v, i, "v");
    stencil_u.move_to(at_u, options.side_u);
    stencil_v.move_to(at_v, options.side_v);
    visit(i, at_u, at_v, stencil_u, stencil_v);
  }
}

template <class Real>
void evaluate_pairs(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                    std::span<Real> out, PatchOptions options) {
  for_each_pair(patch, u, v, 0, options,
                [&](std::size_t i, double at_u, double at_v, const Stencil& su, const Stencil& sv) {
                  const glm::dvec4 h =
                      tensor_sum(patch, su.weights(0), su.first(), sv.weights(0), sv.first());
                  const glm::dvec3 point = patch.rational() ? project(h) : glm::dvec3(h);
                  store(finite_or_nan(point, at_u, at_v, options.at_infinity), &out[3 * i]);
                });
}

/// The point and the normal there, from homogeneous values and derivatives.
struct PointAndNormal {
  glm::dvec3 point;
  glm::dvec3 normal;
};

PointAndNormal with_normal(const NurbsPatch& patch, const NormalFinder& normal, double u, double v, const glm::dvec4& h,
                           const glm::dvec4& hu, const glm::dvec4& hv, PatchOptions options) {
  const glm::dvec3 point = finite_or_nan(patch.rational() ? project(h) : glm::dvec3(h), u, v, options.at_infinity);
  if (!is_finite(point)) return {point, point};
  const glm::dvec3 su = (glm::dvec3(hu) - hu.w * point) / h.w;
  const glm::dvec3 sv = (glm::dvec3(hv) - hv.w * point) / h.w;
  return {point, normal.at(u, v, su, sv, options)};
}

template <class Real>
void grid_points(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<Real> out,
                 AtInfinity at_infinity) {
  std::vector<glm::dvec4> row(patch.knot_vector(Axis::v).unrolled_count());
  Real* next = out.data();
  for (std::size_t i = 0; i < u.size(); ++i) {
    collapse_u(patch, u.weights(i), u.first(i), row);
    breathe(4 * v.size() * (v.weights(0).size() + 4));
    for (std::size_t j = 0; j < v.size(); ++j, next += 3) {
      const glm::dvec4 h = weighted_sum(v.weights(j), row.data() + v.first(j));
      const glm::dvec3 point = patch.rational() ? project(h) : glm::dvec3(h);
      store(finite_or_nan(point, u.parameter(i), v.parameter(j), at_infinity), next);
    }
  }
}

template <class Real>
void grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<Real> points,
                       std::span<Real> normals, AtInfinity at_infinity) {
  const NormalFinder normal(patch);
  std::vector<glm::dvec4> row(patch.knot_vector(Axis::v).unrolled_count());
  std::vector<glm::dvec4> slope(row.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    collapse_u(patch, u.weights(i, 0), u.first(i), row);
    collapse_u(patch, u.weights(i, 1), u.first(i), slope);
    breathe(12 * v.size() * (v.weights(0).size() + 4));
    for (std::size_t j = 0; j < v.size(); ++j, next += 3) {
      const int first = v.first(j);
      const glm::dvec4 h = weighted_sum(v.weights(j, 0), row.data() + first);
      const glm::dvec4 hu = weighted_sum(v.weights(j, 0), slope.data() + first);
      const glm::dvec4 hv = weighted_sum(v.weights(j, 1), row.data() + first);
      const auto found = with_normal(patch, normal, u.parameter(i), v.parameter(j), h, hu, hv,
                                     {u.side(i), v.side(j), at_infinity});
      store(found.point, &points[next]);
      store(found.normal, &normals[next]);
    }
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
  const NormalFinder normal(patch);
  for_each_pair(patch, u, v, 1, options,
                [&](std::size_t i, double at_u, double at_v, const Stencil& su, const Stencil& sv) {
                  const auto sum = [&](int k, int l) {
                    return tensor_sum(patch, su.weights(k), su.first(), sv.weights(l), sv.first());
                  };
                  const auto found = with_normal(patch, normal, at_u, at_v, sum(0, 0), sum(1, 0), sum(0, 1), options);
                  store(found.point, &points[3 * i]);
                  store(found.normal, &normals[3 * i]);
                });
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

void evaluate_grid(const NurbsPatch& patch, const Samples& u, const Samples& v, std::span<float> points,
                   AtInfinity at_infinity) {
  grid_points(patch, u, v, points, at_infinity);
}

void evaluate_grid_with_normals(const NurbsPatch& patch, const Samples& u, const Samples& v,
                                std::span<double> points, std::span<double> normals,
                                AtInfinity at_infinity) {
  grid_with_normals(patch, u, v, points, normals, at_infinity);
}

void derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                 int order, std::span<double> out, PatchOptions options) {
  require_order(order);
  const int width = order + 1;
  const std::size_t size = static_cast<std::size_t>(width) * width;
  std::vector<glm::dvec4> homogeneous(size);
  std::vector<glm::dvec3> values(size);
  for_each_pair(patch, u, v, order, options,
                [&](std::size_t i, double at_u, double at_v, const Stencil& su, const Stencil& sv) {
                  for (std::size_t kl = 0; kl < size; ++kl) {
                    homogeneous[kl] = tensor_sum(patch, su.weights(static_cast<int>(kl) / width), su.first(),
                                                 sv.weights(static_cast<int>(kl) % width), sv.first());
                    values[kl] = glm::dvec3(homogeneous[kl]);
                  }
                  if (patch.rational()) quotient_derivatives(homogeneous, order, values);
                  for (std::size_t kl = 0; kl < size; ++kl) {
                    store(finite_or_nan(values[kl], at_u, at_v, options.at_infinity),
                          &out[3 * (i * size + kl)]);
                  }
                });
}

}  // namespace splinecore
