#include "splinecore/curve/join.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "base/rounding.hpp"
#include "numeric/linear_equations.hpp"
#include "rescale.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "without_knot.hpp"

namespace splinecore {

namespace {

constexpr int kMostConditions = 3;

/// What is so small beside the largest pivot of the conditions is rounding.
constexpr double kDependent = 0x1p-44;

int conditions_of(Smoothness smoothness) {
  return smoothness == Smoothness::c2 ? 3 : smoothness == Smoothness::c1 ? 2 : 1;
}

NurbsCurve with_point(const NurbsCurve& curve, std::size_t i, const glm::dvec3& place) {
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  points[i] = glm::dvec4(place, points[i].w);
  return curve.with_points(std::move(points));
}

/// Both clamped, of one degree that has room for the conditions.
void prepare(NurbsCurve& a, NurbsCurve& b, Smoothness smoothness) {
  for (NurbsCurve* curve : {&a, &b}) {
    if (curve->periodic()) throw InvalidShape("a periodic curve has no end to join");
    *curve = clamped(*curve);
  }
  if (a.points().back().w == 0.0 || b.points().front().w == 0.0) throw InvalidShape("an end to join lies at infinity");
  const int degree = std::max({a.degree(), b.degree(), conditions_of(smoothness)});
  a = elevated(a, degree - a.degree());
  b = elevated(b, degree - b.degree());
}

glm::dvec3 end_derivative(const NurbsCurve& curve, double u, Side side) {
  std::array<glm::dvec3, 2> found;
  derivatives(curve, {&u, 1}, 1, std::span(&found[0].x, 6), {.side = side});
  return found[1];
}

/// What rounding may make of a derivative at an end: its control points divided by the width of the span.
double rounding_of_speed(const NurbsCurve& curve, Side side) {
  const auto knots = curve.knot_vector().knots();
  const std::size_t order = curve.degree() + 1;
  const std::size_t last = curve.points().size() - 1;
  const double width = side == Side::left ? knots[last + 1] - knots[last] : knots[order] - knots[order - 1];
  return kRoundingOfShape * curve.degree() * largest_coordinate(curve.points()) / width;
}

/// b over a domain that begins where a ends and on which both derivatives at the joint have one length,
/// as long as it was where they have it but for rounding.
NurbsCurve scaled_to_meet(const NurbsCurve& a, const NurbsCurve& b, bool is_scaled) {
  const double start = a.domain().end;
  double length = b.domain().length();
  if (is_scaled) {
    const double speed_a = glm::length(end_derivative(a, start, Side::left));
    const double speed_b = glm::length(end_derivative(b, b.domain().start, Side::right));
    const double rounding = std::max(rounding_of_speed(a, Side::left), rounding_of_speed(b, Side::right));
    is_scaled = std::abs(speed_a - speed_b) > rounding;
    if (is_scaled && speed_a > 0.0 && speed_b > 0.0) length *= speed_b / speed_a;
    if (!(start + length > start) || !std::isfinite(start + length)) {
      throw InvalidShape("the derivatives at the joint differ too much in length: " + text_of(speed_a) + " and " +
                         text_of(speed_b));
    }
  }
  // Already in its place: moving it would cost a rounding.
  if (!is_scaled && b.domain().start == start) return b;
  return with_domain(b, {start, start + length});
}

/// Of the points next to an end: in which share each has a part in the derivatives 0 … there. Directions cannot be moved.
struct EndFunctions {
  std::size_t first = 0;
  std::vector<std::array<double, kMostConditions>> shares;
  std::vector<std::array<double, kMostConditions>> shares_of_directions;
};

EndFunctions end_functions(const NurbsCurve& curve, double u, Side side, int count) {
  const int most = kMostConditions - 1;
  Stencil stencil(curve.knot_vector(), most);
  stencil.move_to(u, side);
  EndFunctions functions;
  const std::size_t order = curve.degree() + 1;
  const std::size_t skipped = side == Side::left ? order - count : 0;
  functions.first = stencil.first() + skipped;
  std::array<double, kMostConditions> weight{};
  for (int k = 0; k <= most; ++k) {
    for (std::size_t j = 0; j < order; ++j) weight[k] += stencil.weights(k)[j] * curve.points()[stencil.first() + j].w;
  }
  const auto shares_at = [&](std::size_t j, double w) {
    std::array<glm::dvec4, kMostConditions> numerators;
    for (int k = 0; k <= most; ++k) numerators[k] = glm::dvec4(w * stencil.weights(k)[j], 0.0, 0.0, weight[k]);
    std::array<glm::dvec3, kMostConditions> quotients;
    quotient_derivatives(numerators, quotients);
    return std::array{quotients[0].x, quotients[1].x, quotients[2].x};
  };
  for (std::size_t j = skipped; j < skipped + count; ++j) {
    const double w = curve.points()[stencil.first() + j].w;
    functions.shares.push_back(shares_at(j, w));
    functions.shares_of_directions.push_back(w == 0.0 ? shares_at(j, 1.0) : std::array<double, kMostConditions>{});
  }
  return functions;
}

/// The derivatives at an end, from the first on of how the points lie to that at the end: where weights differ much, those of
/// the weights times the place of the end are far larger than what they leave of each other.
std::array<glm::dvec3, kMostConditions> derivatives_at(const NurbsCurve& curve, const EndFunctions& end, std::size_t at_end) {
  const glm::dvec3 joint(curve.points()[at_end]);
  std::array<glm::dvec3, kMostConditions> found{joint, glm::dvec3(0.0), glm::dvec3(0.0)};
  for (std::size_t j = 0; j < end.shares.size(); ++j) {
    const glm::dvec4& point = curve.points()[end.first + j];
    const bool is_direction = point.w == 0.0;
    const glm::dvec3 way = is_direction ? glm::dvec3(point) : glm::dvec3(point) - joint;
    for (int k = 1; k < kMostConditions; ++k) {
      found[k] += (is_direction ? end.shares_of_directions : end.shares)[j][k] * way;
    }
  }
  return found;
}

/// What a condition lacks once the points have moved, of what is wanted.
/// @throws InvalidShape where that is more than rounding
void require_met(const glm::dvec3& lacking, const glm::dvec3& wanted, double size) {
  constexpr double kPart = 0x1p-20;
  if (length_of(lacking) <= std::max(kPart * length_of(wanted), kRoundingOfPlace * size)) return;
  throw InvalidShape("points at infinity next to the joint leave too few that can move");
}

/// Moves the points next to the joint by the least that makes `count` derivatives, from the 0th, agree.
void meet(NurbsCurve& a, NurbsCurve& b, int count) {
  const double u = a.domain().end;
  const EndFunctions at_a = end_functions(a, u, Side::left, count);
  const EndFunctions at_b = end_functions(b, u, Side::right, count);
  const auto left = derivatives_at(a, at_a, a.points().size() - 1);
  const auto right = derivatives_at(b, at_b, 0);
  const std::size_t movable = at_a.shares.size();
  LinearEquations equations(movable + at_b.shares.size(), 3);
  // Derivatives grow with the inverse of the span: each condition is scaled to the size of its shares.
  std::array<std::vector<double>, kMostConditions> factors;
  std::array<glm::dvec3, kMostConditions> wanted{};
  for (int k = 0; k < count; ++k) {
    for (const auto& share : at_a.shares) factors[k].push_back(share[k]);
    for (const auto& share : at_b.shares) factors[k].push_back(-share[k]);
    double scale = 0.0;
    for (const double factor : factors[k]) scale = std::max(scale, std::abs(factor));
    for (double& factor : factors[k]) factor /= scale;
    wanted[k] = (right[k] - left[k]) / scale;
    equations.add(factors[k], std::array{wanted[k].x, wanted[k].y, wanted[k].z});
  }
  const std::vector<double> found = equations.least_squares(kDependent);
  const auto step = [&](std::size_t j) { return glm::dvec3(found[3 * j], found[3 * j + 1], found[3 * j + 2]); };
  const double size = std::max(largest_coordinate(a.points()), largest_coordinate(b.points()));
  for (int k = 0; k < count; ++k) {
    glm::dvec3 lacking = wanted[k];
    for (std::size_t j = 0; j < factors[k].size(); ++j) lacking -= factors[k][j] * step(j);
    require_met(lacking, wanted[k], size);
  }
  const auto moved = [&](const NurbsCurve& curve, std::size_t first, std::size_t steps, std::size_t from) {
    std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
    for (std::size_t j = 0; j < steps; ++j) {
      glm::dvec4& point = points[first + j];
      if (point.w != 0.0) point = glm::dvec4(glm::dvec3(point) + step(from + j), point.w);
    }
    return curve.with_points(std::move(points));
  };
  a = moved(a, at_a.first, movable, 0);
  b = moved(b, at_b.first, at_b.shares.size(), movable);
}

/// Turns the outer legs of both polygons into the direction between them.
void align(NurbsCurve& a, NurbsCurve& b) {
  const std::size_t last = a.points().size() - 1;
  const glm::dvec3 joint = 0.5 * (glm::dvec3(a.points()[last]) + glm::dvec3(b.points()[0]));
  if (a.points()[last - 1].w == 0.0 || b.points()[1].w == 0.0) {
    throw InvalidShape("a point next to the joint lies at infinity");
  }
  const glm::dvec3 leg_a = glm::dvec3(a.points()[last]) - glm::dvec3(a.points()[last - 1]);
  const glm::dvec3 leg_b = glm::dvec3(b.points()[1]) - glm::dvec3(b.points()[0]);
  const double length_a = glm::length(leg_a);
  const double length_b = glm::length(leg_b);
  const glm::dvec3 between = length_a > 0.0 && length_b > 0.0 ? leg_a / length_a + leg_b / length_b : glm::dvec3(0.0);
  const double length = glm::length(between);
  if (!(length_a > 0.0 && length_b > 0.0)) throw InvalidShape("a curve leaves the joint in no direction");
  if (length <= kRoundingOfSum) {
    throw InvalidShape("the curves leave the joint the same way: no direction lies between them");
  }
  const glm::dvec3 direction = between / length;
  a = with_point(with_point(a, last, joint), last - 1, joint - length_a * direction);
  b = with_point(with_point(b, 0, joint), 1, joint + length_b * direction);
}

/// a and b as one curve with `degree` copies of the knot between them.
NurbsCurve in_a_row(const NurbsCurve& a, const NurbsCurve& b) {
  const int degree = a.degree();
  const auto knots_a = a.knot_vector().knots();
  const auto knots_b = b.knot_vector().knots();
  std::vector<double> knots(knots_a.begin(), knots_a.end() - 1);
  knots.insert(knots.end(), knots_b.begin() + degree + 1, knots_b.end());
  std::vector<glm::dvec4> points(a.points().begin(), a.points().end());
  const double scale = a.points().back().w / b.points().front().w;
  for (std::size_t i = 1; i < b.points().size(); ++i) {
    const glm::dvec4& point = b.points()[i];
    points.push_back(point.w == 0.0 ? point * scale : glm::dvec4(glm::dvec3(point), point.w * scale));
  }
  return NurbsCurve::make(degree, std::move(knots), std::move(points));
}

/// Without the copies of the joint's knot that nothing but rounding asks for.
Approximation<NurbsCurve> without_needless_copies(const NurbsCurve& curve, double joint) {
  constexpr double kRounding = 0x1p-42;
  const double tolerance = kRounding * largest_coordinate(curve.points());
  return without_copies({curve, 0.0}, joint, curve, tolerance);
}

Approximation<NurbsCurve> joined_near_one(NurbsCurve a, NurbsCurve b, Smoothness smoothness) {
  prepare(a, b, smoothness);
  b = scaled_to_meet(a, b, smoothness >= Smoothness::c1);
  const NurbsCurve old_a = a;
  const NurbsCurve old_b = b;
  if (smoothness == Smoothness::g1) {
    align(a, b);
  } else {
    meet(a, b, conditions_of(smoothness));
    meet(a, b, conditions_of(smoothness));  // what rounding left
  }
  const double error = std::max(largest_distance(old_a, a), largest_distance(old_b, b));
  auto [value, rounding] = without_needless_copies(in_a_row(a, b), a.domain().end);
  return {std::move(value), error + rounding};
}

}  // namespace

Approximation<NurbsCurve> joined(const NurbsCurve& first, const NurbsCurve& second, Smoothness smoothness) {
  const Scales shared = shared_scales(first, second);
  // Where b's domain is scaled anyway, each can have its own.
  const bool is_scaled = smoothness >= Smoothness::c1;
  const int on_a = is_scaled ? scales_of(first).parameters : shared.parameters;
  const int on_b = is_scaled ? scales_of(second).parameters : shared.parameters;
  auto [value, error] = joined_near_one(divided(first, {.coordinates = shared.coordinates, .parameters = on_a}),
                                        divided(second, {.coordinates = shared.coordinates, .parameters = on_b}),
                                        smoothness);
  return {divided(value, {.coordinates = -shared.coordinates, .parameters = -on_a}),
          std::scalbn(error, shared.coordinates)};
}

}  // namespace splinecore
