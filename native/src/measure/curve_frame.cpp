#include "splinecore/measure/curve_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/rounding.hpp"
#include "frenet_frame.hpp"
#include "rounded_jet.hpp"
#include "unit_direction.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Terms of the power series of the first three derivatives about a parameter.
constexpr int kTerms = 8;
constexpr int kOrder = kTerms + 2;

template <class Value>
using RoundedSeries = std::array<Rounded<Value>, kTerms>;

double size_of(double x) { return std::abs(x); }
double size_of(const glm::dvec3& v) { return glm::length(v); }

template <class Value>
bool is_nothing(const Rounded<Value>& x) {
  return !(size_of(x.value) > x.rounding);
}

/// The derivatives of a curve about one parameter, in powers of s = (u - u_0) / length of the span.
struct Local {
  RoundedSeries<glm::dvec3> first;
  RoundedSeries<glm::dvec3> second;
  RoundedSeries<glm::dvec3> third;
};

/// From derivatives 0 to kOrder in powers of the span's length.
Local local_of(const std::array<Rounded<glm::dvec3>, kOrder + 1>& values) {
  Local local;
  const auto term = [](double factor, const Rounded<glm::dvec3>& x) {
    return Rounded<glm::dvec3>{factor * x.value, factor * x.rounding};
  };
  for (int k = 0; k < kTerms; ++k) {
    const double once = k + 1.0;
    const double twice = (k + 2.0) * once;
    const double thrice = (k + 3.0) * twice;
    local.first[k] = term(once, values[k + 1]);
    local.second[k] = term(twice, values[k + 2]);
    local.third[k] = term(thrice, values[k + 3]);
  }
  return local;
}

Local local_at(const NurbsCurve& curve, const SlowPlaces& slow, double u, Side side) {
  std::array<glm::dvec3, kOrder + 1> plain;
  derivatives(curve, {&u, 1}, kOrder, std::span(&plain[0].x, 3 * plain.size()), {.side = side});
  const KnotVector& knots = curve.knot_vector();
  const double span = knots.span_interval(knots.span_of(knots.admit(u, side), side)).length();
  const double rounding = kRoundingOfShape * (curve.degree() + 1) * extent(curve.points());
  std::array<Rounded<glm::dvec3>, kOrder + 1> values;
  for (int k = 0; k <= kOrder; ++k) values[k].value = plain[k];
  const bool is_slow = slow.is_slow(plain[1], span);
  if (is_slow) std::ranges::copy(slow.jet(u, side, kOrder), values.begin());
  double factor = 1.0;
  for (int k = 1; k <= kOrder; ++k) {
    factor *= span / k;
    values[k].value *= factor;
    values[k].rounding = is_slow ? values[k].rounding * factor : rounding;
  }
  return local_of(values);
}

/// The product of two series, with `multiply` for their terms.
template <class Value, class Multiply>
RoundedSeries<Value> product(const RoundedSeries<glm::dvec3>& a, const RoundedSeries<glm::dvec3>& b,
                             Multiply multiply) {
  RoundedSeries<Value> found;
  for (int i = 0; i < kTerms; ++i) {
    for (int j = 0; i + j < kTerms; ++j) {
      found[i + j].value += multiply(a[i].value, b[j].value);
      found[i + j].rounding += size_of(a[i].value) * b[j].rounding + size_of(b[j].value) * a[i].rounding;
    }
  }
  return found;
}

/// The first term that is more than rounding; kTerms if there is none.
template <class Value>
int order_of(const RoundedSeries<Value>& series) {
  return static_cast<int>(std::ranges::find_if_not(series, is_nothing<Value>) - series.begin());
}

/// The limit of value s^order as s falls to zero.
double limit(double value, int order) {
  if (order > 0) return 0.0;
  return order == 0 ? value : std::copysign(HUGE_VAL, value);
}

/// The leading terms of the first derivative and of its product with the second.
struct Leading {
  RoundedSeries<glm::dvec3> binormals;
  int a;
  int b;

  explicit Leading(const Local& local)
      : binormals(product<glm::dvec3>(local.first, local.second,
                                      [](const glm::dvec3& x, const glm::dvec3& y) { return glm::cross(x, y); })),
        a(order_of(local.first)), b(order_of(binormals)) {}
  bool stands_still() const { return a == kTerms; }
  bool is_straight() const { return b == kTerms; }
  const glm::dvec3& binormal() const { return binormals[b].value; }
};

/// The curvature; `size_of_bend` is the length of C' x C'', or a part of it.
template <class SizeOfBend>
double curvature_of(const Local& local, SizeOfBend size_of_bend) {
  const Leading leading(local);
  if (leading.stands_still()) return kNan;
  const double speed = glm::length(local.first[leading.a].value);
  // Where the curve moves at all the plain formula holds, down to the smallest curvature.
  if (leading.a == 0) return size_of_bend(leading.binormals[0].value) / (speed * speed * speed);
  if (leading.is_straight()) return 0.0;
  return limit(size_of_bend(leading.binormal()) / (speed * speed * speed), leading.b - 3 * leading.a);
}

double torsion_of(const Local& local) {
  const Leading leading(local);
  if (leading.is_straight()) return kNan;
  const auto volumes = product<double>(leading.binormals, local.third,
                                       [](const glm::dvec3& x, const glm::dvec3& y) { return glm::dot(x, y); });
  const double square = glm::dot(leading.binormal(), leading.binormal());
  if (leading.b == 0) return volumes[0].value / square;
  const int order = order_of(volumes);
  if (order == kTerms) return 0.0;
  return limit(volumes[order].value / square, order - 2 * leading.b);
}

MovingFrame frame_of(const Local& local, bool is_arriving) {
  MovingFrame frame{glm::dvec3(kNan), glm::dvec3(kNan), glm::dvec3(kNan)};
  const Leading leading(local);
  if (leading.stands_still()) return frame;
  const auto sign = [&](int order) { return is_arriving && order % 2 == 1 ? -1.0 : 1.0; };
  frame.tangent = sign(leading.a) * glm::normalize(local.first[leading.a].value);
  if (leading.is_straight()) return frame;
  const glm::dvec3 binormal = sign(leading.b) * glm::normalize(leading.binormal());
  frame.normal = glm::normalize(glm::cross(binormal, frame.tangent));
  frame.binormal = glm::cross(frame.tangent, frame.normal);
  return frame;
}

bool arrives_at(const KnotVector& knots, double u, Side side) {
  return knots.span_interval(knots.span_of(u, side)).end == u;
}

/// Calls visit(i, local, whether the curve arrives at u) for the curve near the origin.
template <class Visit>
Placement for_each_local(const NurbsCurve& curve, std::span<const double> parameters, Side side, Visit visit) {
  const NearCurve near = near_origin(curve);
  const SlowPlaces slow(curve, near);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double u = std::scalbn(curve.knot_vector().admit(parameters[i], side, i), -near.parameters);
    visit(i, local_at(near.curve, slow, u, side), arrives_at(near.curve.knot_vector(), u, side));
  }
  return near.placement;
}

/// One curvature, measured with the curve in its place, for each parameter.
template <class Measure>
void bends(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out, Side side,
           const char* name, Measure measure) {
  const Placement placement = for_each_local(
      curve, parameters, side, [&](std::size_t i, const Local& local, bool) { out[i] = measure(local); });
  for (double& value : out) {
    // At a cusp the limit itself is infinite.
    if (std::isfinite(value)) value = finite_size(value, -1, placement, name);
  }
}

}  // namespace

MovingFrame frenet_frame(const NurbsCurve& near, const SlowPlaces& slow, double u, Side side) {
  return frame_of(local_at(near, slow, u, side), arrives_at(near.knot_vector(), u, side));
}

void curvature(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out, Side side) {
  bends(curve, parameters, out, side, "curvature", [](const Local& local) {
    return curvature_of(local, [](const glm::dvec3& bend) { return glm::length(bend); });
  });
}

void signed_curvature(const NurbsCurve& curve, std::span<const double> parameters, const glm::dvec3& normal,
                      std::span<double> out, Side side) {
  const glm::dvec3 way = unit_direction(normal, "normal");
  bends(curve, parameters, out, side, "curvature", [&](const Local& local) {
    return curvature_of(local, [&](const glm::dvec3& bend) { return glm::dot(bend, way); });
  });
}

void torsion(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out, Side side) {
  bends(curve, parameters, out, side, "torsion", &torsion_of);
}

void frenet_frames(const NurbsCurve& curve, std::span<const double> parameters, std::span<MovingFrame> out, Side side) {
  for_each_local(curve, parameters, side,
                 [&](std::size_t i, const Local& local, bool is_arriving) { out[i] = frame_of(local, is_arriving); });
}

}  // namespace splinecore
