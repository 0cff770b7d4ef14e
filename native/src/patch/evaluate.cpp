#include "splinecore/patch/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/call_memory.hpp"
#include "base/parallel.hpp"
#include "base/quotient.hpp"
#include "basis/axis_places.hpp"
#include "curve/rescale.hpp"
#include "grid.hpp"
#include "normal.hpp"
#include "settled.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

glm::dvec3 settled_point(const NurbsPatch& patch, const glm::dvec4& h, double u, double v, AtInfinity at_infinity) {
  const glm::dvec3 point = patch.rational() ? project(h) : glm::dvec3(h);
  if (is_finite(point)) return point;
  if (at_infinity == AtInfinity::raise) throw PointAtInfinity(u, v);
  return glm::dvec3(kNan);
}

namespace {

constexpr std::size_t kPart = AxisPlaces::kMost;

/// Steps of the kernels for the sum of a pair.
std::size_t steps_of_pair(const GridForm& form) {
  return 4 * static_cast<std::size_t>((form.degree_u + 1) * (form.degree_v + 1));
}

/// Calls visit(form, pairs, begin, count) for some of the pairs from begin to end after the other.
template <class Visit>
void for_each_part(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v, std::size_t begin,
                   std::size_t end, int order, PatchOptions options, Visit visit) {
  const GridForm form = form_of(patch);
  AxisPlaces places_u(patch.knot_vector(Axis::u), order, "u");
  AxisPlaces places_v(patch.knot_vector(Axis::v), order, "v");
  const auto visit_some = [&](std::size_t first, std::size_t count) {
    const ScatteredPairs pairs{places_u.locate(u.subspan(first, count), first, options.side_u),
                               places_v.locate(v.subspan(first, count), first, options.side_v)};
    breathe(count * steps_of_pair(form));
    visit(form, pairs, first, count);
  };
  for (std::size_t first = begin; first < end; first += kPart) {
    const std::size_t count = std::min(kPart, end - first);
    in_order_of_errors(first, count, visit_some);
  }
}

/// The same for all pairs, on several threads.
template <class Visit>
void for_each_part(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v, int order,
                   PatchOptions options, Visit visit) {
  const std::size_t steps = static_cast<std::size_t>(order + 1) * steps_of_pair(form_of(patch));
  in_ranges(u.size(), steps / kStepsAtOnce + 1, options.threads, [&](std::size_t begin, std::size_t end) {
    for_each_part(patch, u, v, begin, end, order, options, visit);
  });
}

/// The homogeneous derivatives at one pair, by the domains divided by powers of two about their lengths.
struct PairSums {
  PairSums(const NurbsPatch& patch, int highest)
      : form(form_of(patch)), order(highest), near_u(near_one(patch.knot_vector(Axis::u))),
        near_v(near_one(patch.knot_vector(Axis::v))), u(near_u.knots, highest, memory.resource()),
        v(near_v.knots, highest, memory.resource()),
        sums(static_cast<std::size_t>((highest + 1) * (highest + 1)), memory.resource()),
        values(sums.size(), memory.resource()) {}

  std::span<const glm::dvec4> at(double at_u, double at_v, PatchOptions options) {
    u.move_to(std::ldexp(at_u, -near_u.exponent), options.side_u);
    v.move_to(std::ldexp(at_v, -near_v.exponent), options.side_v);
    breathe(4 * sums.size() * static_cast<std::size_t>(form.degree_v + 1));
    kernels().pair_sums(form, order, corner_of(form, u.first(), v.first()), u.all_weights().data(),
                        v.all_weights().data(), &sums.data()->x);
    return sums;
  }

  /// Makes of values derivatives k along u and l along v by the domains as they are.
  void undivide() {
    if (near_u.exponent == 0 && near_v.exponent == 0) return;
    for (int k = 0; k <= order; ++k) {
      for (int l = 0; l <= order; ++l) {
        glm::dvec3& value = values[static_cast<std::size_t>(k * (order + 1) + l)];
        const int exponent = -(k * near_u.exponent + l * near_v.exponent);
        for (int axis = 0; axis < 3; ++axis) value[axis] = std::ldexp(value[axis], exponent);
      }
    }
  }

  GridForm form;
  int order;
  ScaledKnots near_u;
  ScaledKnots near_v;
  CallMemory memory;
  Stencil u;
  Stencil v;
  std::pmr::vector<glm::dvec4> sums;
  std::pmr::vector<glm::dvec3> values;
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
  for_each_part(patch, u, v, 0, options,
                [&](const GridForm& form, const ScatteredPairs& pairs, std::size_t begin, std::size_t count) {
                  std::array<double, 3 * kPart> values;
                  const int found = kernels().pair_points(form, pairs, count, values.data());
                  for (std::size_t i = 0; found != 0 && i < count; ++i) {
                    settle_pair(patch, u[begin + i], v[begin + i], options, {&values[3 * i], 3});
                  }
                  for (std::size_t i = 0; i < 3 * count; ++i) out[3 * begin + i] = static_cast<Real>(values[i]);
                });
}

/// All derivatives of the pairs from begin to end.
void all_derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v, std::size_t begin,
                     std::size_t end, int order, std::span<double> out, PatchOptions options) {
  const std::size_t width = static_cast<std::size_t>(order) + 1;
  const std::size_t size = width * width;
  PairSums sums(patch, order);
  const auto find = [&](std::size_t i, const double* first) {
    const auto row = out.subspan(3 * size * i, 3 * size);
    const double at_u = patch.knot_vector(Axis::u).admit(u[i], options.side_u);
    const double at_v = patch.knot_vector(Axis::v).admit(v[i], options.side_v);
    const std::span<const glm::dvec4> homogeneous = sums.at(at_u, at_v, options);
    const std::span<glm::dvec3> values = sums.values;
    for (std::size_t kl = 0; kl < size; ++kl) values[kl] = glm::dvec3(homogeneous[kl]);
    if (patch.rational()) quotient_derivatives(homogeneous, order, values);
    sums.undivide();
    for (std::size_t kl = 0; kl < size; ++kl) store(values[kl], &row[3 * kl]);
    // The lowest are the same, bit for bit, whatever the order.
    std::copy_n(first, 3, &row[0]);
    std::copy_n(first + 3, 3, &row[3 * width]);
    std::copy_n(first + 6, 3, &row[3]);
    settle_pair(patch, at_u, at_v, options, row);
  };
  for_each_part(patch, u, v, begin, end, 1, options,
                [&](const GridForm& form, const ScatteredPairs& pairs, std::size_t part, std::size_t count) {
                  std::array<double, 9 * kPart> first;
                  kernels().pair_slopes(form, pairs, count, first.data());
                  for (std::size_t i = 0; i < count; ++i) find(part + i, &first[9 * i]);
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
  const NormalForm normal{finder.rounding(), slope_scale(patch.knot_vector(Axis::u)),
                          slope_scale(patch.knot_vector(Axis::v))};
  for_each_part(finder.seen(), u, v, 1, options,
                [&](const GridForm& form, const ScatteredPairs& pairs, std::size_t begin, std::size_t count) {
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

void first_derivatives(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                       std::span<double> out, PatchOptions options) {
  for_each_part(patch, u, v, 1, options,
                [&](const GridForm& form, const ScatteredPairs& pairs, std::size_t begin, std::size_t count) {
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
  const auto size = static_cast<std::size_t>((order + 1) * (order + 1));
  const std::size_t steps = size * steps_of_pair(form_of(patch));
  in_ranges(u.size(), steps, options.threads, [&](std::size_t begin, std::size_t end) {
    all_derivatives(patch, u, v, begin, end, order, out, options);
  });
}

}  // namespace splinecore
