#include "normal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/call_memory.hpp"
#include "base/placement.hpp"
#include "base/quotient.hpp"
#include "settled.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Terms of a power series along a way into the domain.
constexpr int kTerms = 4;
template <class Value>
using PowerSeries = std::array<Value, kTerms>;

/// A homogeneous vector, and what rounding may have made of its part in space and of its weight.
struct RoundedPoint {
  glm::dvec4 value{0.0};
  double noise = 0.0;
  double weight_noise = 0.0;
};

/// Homogeneous derivatives around one pair of parameters, of the patch moved so that its point there is the origin: no
/// digits are lost far from the origin, and no division spreads rounding.
struct LocalDerivatives {
  static constexpr int kWidth = kTerms + 1;
  std::array<RoundedPoint, kWidth * kWidth> values;
};

/// The control points that a pair of parameters depends on, as they were given, row after row.
std::vector<glm::dvec4> control_points(const NurbsPatch& patch, const Samples& u, const Samples& v) {
  const std::size_t count_u = patch.count(Axis::u);
  const std::size_t count_v = patch.count(Axis::v);
  std::vector<glm::dvec4> found;
  for (std::size_t i = 0; i < u.weights(0).size(); ++i) {
    for (std::size_t j = 0; j < v.weights(0).size(); ++j) {
      found.push_back(patch.points()[(u.first(0) + i) % count_u * count_v + (v.first(0) + j) % count_v]);
    }
  }
  return found;
}

glm::dvec4 local_sum(std::span<const double> u, std::span<const double> v, const std::vector<glm::dvec4>& points) {
  glm::dvec4 total(0.0);
  for (std::size_t i = 0; i < u.size(); ++i) total += u[i] * weighted_sum(v, points.data() + i * v.size());
  return total;
}

/// The same sum with what rounding may do to it. @param unit  the rounding of a point
RoundedPoint rounded_sum(std::span<const double> u, std::span<const double> v, const std::vector<glm::dvec4>& points,
                         double unit) {
  constexpr double kRounding = 0x1p-47;
  RoundedPoint sum{local_sum(u, v, points)};
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) {
      const glm::dvec4& p = points[i * v.size() + j];
      const double share = std::abs(u[i] * v[j]);
      sum.noise += share * (kRounding * glm::length(glm::dvec3(p)) + unit * std::abs(p.w));
      sum.weight_noise += share * kRounding * std::abs(p.w);
    }
  }
  return sum;
}

/// As far as a number of terms needs them, which is the order of the samples.
LocalDerivatives local_derivatives(const NurbsPatch& patch, const Samples& u, const Samples& v, double unit) {
  std::vector<glm::dvec4> points = control_points(patch, u, v);
  double heaviest = 0.0;
  for (const glm::dvec4& p : points) heaviest = std::max(heaviest, std::abs(p.w));
  const int exponent = heaviest > 0.0 ? -std::ilogb(heaviest) : 0;
  for (glm::dvec4& p : points) {
    for (int axis = p.w == 0.0 ? 0 : 3; axis < 4; ++axis) p[axis] = std::ldexp(p[axis], exponent);
  }
  const glm::dvec3 origin = project(local_sum(u.weights(0), v.weights(0), homogeneous(points)));
  for (glm::dvec4& p : points) {
    if (p.w != 0.0) p = glm::dvec4(p.w * (glm::dvec3(p) - origin), p.w);
  }
  LocalDerivatives local;
  for (int k = 0; k <= u.order(); ++k) {
    for (int l = 0; k + l <= u.order(); ++l) {
      local.values[k * local.kWidth + l] = rounded_sum(u.weights(0, k), v.weights(0, l), points, unit);
    }
  }
  return local;
}

/// The derivative in_u, in_v along the way (a, b) from the point.
PowerSeries<RoundedPoint> along(const LocalDerivatives& local, double a, double b, int in_u, int in_v, int terms) {
  PowerSeries<RoundedPoint> series;
  double factorial = 1.0;
  for (int n = 0; n < terms; ++n, factorial *= n) {
    for (int k = 0; k <= n; ++k) {
      const double factor = binomial(n, k) / factorial * std::pow(a, k) * std::pow(b, n - k);
      const RoundedPoint& there = local.values[(k + in_u) * local.kWidth + (n - k + in_v)];
      series[n].value += factor * there.value;
      series[n].noise += std::abs(factor) * there.noise;
      series[n].weight_noise += std::abs(factor) * there.weight_noise;
    }
  }
  return series;
}

/// A normal, and what rounding may have made of it.
struct RoundedNormal {
  glm::dvec3 value{0.0};
  double noise = 0.0;
};

/// Adds w (x x y) to a series of normals.
void add_product(PowerSeries<RoundedNormal>& sum, const PowerSeries<RoundedPoint>& w,
                 const PowerSeries<RoundedPoint>& x, const PowerSeries<RoundedPoint>& y, int terms) {
  for (int i = 0; i < terms; ++i) {
    for (int j = 0; i + j < terms; ++j) {
      const glm::dvec3 at_x(x[i].value);
      const glm::dvec3 at_y(y[j].value);
      const glm::dvec3 normal = glm::cross(at_x, at_y);
      const double size = glm::length(at_x) * glm::length(at_y);
      const double noise = x[i].noise * glm::length(at_y) + (glm::length(at_x) + x[i].noise) * y[j].noise;
      for (int k = 0; i + j + k < terms; ++k) {
        sum[i + j + k].value += w[k].value.w * normal;
        sum[i + j + k].noise += std::abs(w[k].value.w) * noise + w[k].weight_noise * (size + noise);
      }
    }
  }
}

/// Slopes times points reach no farther than the slopes times the reach, and where all weights have one sign so do
/// derivatives: then 2^48 times the noise of the kernels' normals is no more than 2^-47 of what the fourth power says.
NormalRounding normal_rounding(const NurbsPatch& patch) {
  double farthest = 0.0;
  double lightest = std::numeric_limits<double>::infinity();
  double heaviest = -lightest;
  for (const glm::dvec4& p : patch.homogeneous_points()) {
    farthest = std::max(farthest, glm::length(glm::dvec3(p)));
    lightest = std::min(lightest, p.w);
    heaviest = std::max(heaviest, p.w);
  }
  const double reach =
      farthest + std::max(std::abs(lightest), std::abs(heaviest)) * largest_coordinate(patch.points());
  constexpr double kOfPoint = 0x1p-48;
  constexpr double kPlain = 0x1p-46;
  const bool is_bounded = lightest > 0.0 || heaviest < 0.0;
  const double squared = reach * reach;
  return {kOfPoint * reach, is_bounded ? kPlain * squared * squared : std::numeric_limits<double>::infinity()};
}

/// From the parameter across the span on the side asked for, or back into the domain.
double step_inward(const KnotVector& knots, double u, Side side) {
  const Interval span = knots.span_interval(knots.span_of(u, side));
  return u < span.end && (side == Side::right || u == span.start) ? span.length() : -span.length();
}

}  // namespace

NormalFacts::NormalFacts(const NurbsPatch& patch) {
  constexpr double kFar = 16.0;
  constexpr int kLarge = 128;
  const double size = extent(patch.points());
  const double largest = largest_coordinate(patch.points());
  Placement placement = placement_of(patch.points());
  const bool is_far = largest > kFar * size;
  if (is_far && size > 0.0) placement.exponent = std::ilogb(size);
  if (is_far || std::abs(placement.exponent) > kLarge) near = placed(patch, placement);
  constexpr double kRounding = 0x1p-49;
  unit = kRounding * (near ? std::ldexp(largest, -placement.exponent) : largest);
  const NurbsPatch& seen = near ? *near : patch;
  rounding = normal_rounding(seen);
  poles = poles_of(seen);
}

NormalFinder::NormalFinder(const NurbsPatch& patch)
    : patch_(patch), facts_(patch.normal_facts().get([&] { return std::make_unique<const NormalFacts>(patch); })) {}

std::optional<glm::dvec3> NormalFinder::at_pole(double u, double v, PatchOptions options) const {
  for (const Pole& pole : facts_.poles) {
    const bool is_along_v = pole.axis() == Axis::u;
    if ((is_along_v ? u : v) != pole.parameter()) continue;
    const Axis along = is_along_v ? Axis::v : Axis::u;
    const KnotVector& knots = patch_.knot_vector(along);
    CallMemory memory;
    const Samples at = Samples::make(knots, {is_along_v ? &v : &u, 1}, 1, is_along_v ? options.side_v : options.side_u,
                                     "u", memory.resource());
    const GridColumns columns(at, slope_scale(knots), memory.resource());
    const auto normal = pole.normals(columns, facts_.rounding, memory.resource());
    if (is_number(normal.data())) return glm::dvec3(normal[0], normal[1], normal[2]);
  }
  return std::nullopt;
}

/// S_u x S_v times W^3, from the homogeneous S = A / W, is W A_u x A_v + W_u A_v x A + W_v A x A_u:
/// as a power series along a straight way into the domain its first coefficient that is not
/// rounding is the direction of the limit.
std::optional<glm::dvec3> NormalFinder::first_term(double u, double v, PatchOptions options, int terms) const {
  const KnotVector& knots_u = patch_.knot_vector(Axis::u);
  const KnotVector& knots_v = patch_.knot_vector(Axis::v);
  const LocalDerivatives local =
      local_derivatives(seen(), Samples::make(knots_u, {&u, 1}, terms, options.side_u),
                        Samples::make(knots_v, {&v, 1}, terms, options.side_v), facts_.unit);
  const double a = step_inward(knots_u, u, options.side_u);
  const double b = step_inward(knots_v, v, options.side_v);
  const auto point = along(local, a, b, 0, 0, terms);
  const auto slope_u = along(local, a, b, 1, 0, terms);
  const auto slope_v = along(local, a, b, 0, 1, terms);
  PowerSeries<RoundedNormal> normals;
  add_product(normals, point, slope_u, slope_v, terms);
  add_product(normals, slope_u, slope_v, point, terms);
  add_product(normals, slope_v, point, slope_u, terms);
  for (const RoundedNormal& normal : std::span(normals).first(static_cast<std::size_t>(terms))) {
    // About the size of the derivatives by the parts of a span.
    const glm::dvec3 value = normal.value * std::abs(a) * std::abs(b);
    const double size = std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
    if (!std::isfinite(size)) break;
    const int exponent = size > 0.0 ? std::ilogb(size) : 0;
    const glm::dvec3 near(std::scalbn(value.x, -exponent), std::scalbn(value.y, -exponent),
                          std::scalbn(value.z, -exponent));
    const double length = glm::length(near);
    // Below the least normal number digits are lost.
    constexpr double kLost = 0x1p-1030;
    const double noise = std::scalbn(std::max(normal.noise * std::abs(a) * std::abs(b), kLost), -exponent);
    if (length > noise) return (point[0].value.w < 0.0 ? -near : near) / length;
  }
  return std::nullopt;
}

glm::dvec3 NormalFinder::limit(double u, double v, PatchOptions options) const {
  constexpr int kFew = 2;
  std::optional<glm::dvec3> found = at_pole(u, v, options);
  if (!found) found = first_term(u, v, options, kFew);
  if (!found) found = first_term(u, v, options, kTerms);
  return found.value_or(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace splinecore
