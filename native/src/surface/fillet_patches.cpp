#include "splinecore/surface/fillet_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <vector>

#include "base/length.hpp"
#include "build/fit_options.hpp"
#include "fitted_patch.hpp"
#include "fitted_rows.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "rolling_ball.hpp"
#include "side_first.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/join.hpp"

namespace splinecore {

namespace {

/// v_start along the edge, u over [0, 1], v from 0.
NurbsPatch ready(const NurbsPatch& patch, Border side, bool is_reversed) {
  NurbsPatch made = with_side_first(patch, side);
  if (is_reversed) made = reversed(made, Axis::u);
  made = clamped(made, Axis::v);
  if (!made.knot_vector(Axis::u).periodic()) made = clamped(made, Axis::u);
  return with_domain(with_domain(made, Axis::u, {0.0, 1.0}), Axis::v, {0.0, 1.0});
}

void require_common_edge(const NurbsPatch& a, const NurbsPatch& b, double tolerance, double unit) {
  constexpr int kPlaces = 65;
  std::vector<double> u;
  for (int k = 0; k < kPlaces; ++k) u.push_back(static_cast<double>(k) / (kPlaces - 1));
  const double start[] = {0.0};
  std::vector<glm::dvec3> on_a(kPlaces);
  std::vector<glm::dvec3> on_b(kPlaces);
  evaluate_grid(a, u, start, std::span(&on_a.front().x, 3 * on_a.size()));
  evaluate_grid(b, u, start, std::span(&on_b.front().x, 3 * on_b.size()));
  double gap = 0.0;
  for (int k = 0; k < kPlaces; ++k) gap = std::max(gap, distance_of(on_a[k], on_b[k]));
  if (!(gap <= tolerance)) {
    throw InvalidShape("the sides are not one edge, run through at one pace: they lie " + text_of(gap * unit) + " apart");
  }
}

/// The arc between both contacts, about the centre.
std::array<glm::dvec4, 3> arc_of(const Contact& contact) {
  const glm::dvec3 a = contact.first - contact.centre;
  const glm::dvec3 b = contact.second - contact.centre;
  const glm::dvec3 middle = a + b;
  const double half = 0.5 * length_of(middle) / contact.radius;  // cosine of half the angle
  const glm::dvec3 tip = contact.centre + middle / (2.0 * half * half);
  return {glm::dvec4(contact.first, 1.0), glm::dvec4(half * tip, half), glm::dvec4(contact.second, 1.0)};
}

/// By the distance of its points from the centre.
double off_radius(const NurbsPatch& fillet, const RollingBall& ball) {
  constexpr int kAlong = 65;
  constexpr std::array<double, 5> kAcross{0.0, 0.25, 0.5, 0.75, 1.0};
  std::vector<double> u;
  for (int k = 0; k < kAlong; ++k) u.push_back((k + 0.37) / kAlong);
  std::vector<glm::dvec3> points(u.size() * kAcross.size());
  evaluate_grid(fillet, u, kAcross, std::span(&points.front().x, 3 * points.size()));
  double largest = 0.0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const Contact contact = ball.at(u[k], true);
    for (std::size_t j = 0; j < kAcross.size(); ++j) {
      largest = std::max(largest, std::abs(distance_of(points[k * kAcross.size() + j], contact.centre) - contact.radius));
    }
  }
  return largest;
}

Approximation<NurbsPatch> rolled(const RollingBall& ball, const RowDomain& domain, double tolerance) {
  constexpr int kHalvings = 6;
  const auto rows_at = [&](std::span<const double> at, const Interval&) {
    std::vector<glm::dvec4> rows;
    for (const double u : at) {
      const auto arc = arc_of(ball.at(u, true));
      rows.insert(rows.end(), arc.begin(), arc.end());
    }
    return rows;
  };
  double within = tolerance;
  for (int k = 0;; ++k, within *= 0.5) {
    const FittedRows rows = fitted_rows(rows_at, domain, within);
    const NurbsPatch made = swapped(patch_of(KnotVector::bezier(2), rows));
    const double error = std::max(rows.error, off_radius(made, ball));
    if (error <= tolerance) return {made, error};
    if (k == kHalvings) throw ToleranceNotReached("the fillet cannot be had", tolerance, error);
  }
}

/// What is left of a patch beyond the contact.
Approximation<NurbsPatch> shortened(const NurbsPatch& patch, const RollingBall& ball, bool is_first, double tolerance) {
  constexpr double kLevel = 0x1p-44;
  const auto contact_at = [&](double u) {
    const Contact contact = ball.at(u, is_first);
    return is_first ? contact.on_first.y : contact.on_second.y;
  };
  const double first = contact_at(0.5);
  bool is_level = true;
  for (const double u : {0.0, 0.13, 0.31, 0.72, 0.89, 1.0}) is_level = is_level && std::abs(contact_at(u) - first) <= kLevel;
  if (is_level) return {with_domain(split(patch, Axis::v, first).second, Axis::v, {0.0, 1.0}), 0.0};
  return fitted_patch(patch, [&](std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> points) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double start = contact_at(u[i]);
      std::vector<double> at;
      for (const double t : v) at.push_back(start + t * (1.0 - start));
      evaluate_grid(patch, u.subspan(i, 1), at, std::span(&points[i * v.size()].x, 3 * v.size()));
    }
  }, tolerance);
}

std::vector<RailNumber> over_unit(std::span<const RailNumber> radii, const Interval& domain, double unit) {
  std::vector<RailNumber> found;
  for (const RailNumber& radius : radii) {
    if (!(radius.value > 0.0 && std::isfinite(radius.value))) {
      throw InvalidShape("a radius of " + text_of(radius.value) + ": above 0 is expected");
    }
    if (!(radius.at >= domain.start && radius.at <= domain.end)) {
      throw InvalidShape("the radius at " + text_of(radius.at) + " is off the edge, which runs from " + text_of(domain.start) + " to " +
                         text_of(domain.end));
    }
    found.push_back({(radius.at - domain.start) / domain.length(), radius.value / unit});
  }
  return found;
}

}  // namespace

RoundedEdge fillet(const NurbsPatch& first, Border first_side, const NurbsPatch& second, Border second_side,
                   std::span<const RailNumber> radii, std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  for (const auto& [patch, side] : {std::pair(&first, first_side), std::pair(&second, second_side)}) {
    if (patch->knot_vector(axis_of(side)).periodic()) throw InvalidShape("the side is the seam of a periodic direction: it is no edge");
  }
  const NearSpace space(together(first.points(), second.points()));
  const double unit = space.length(1.0);
  const double within = tolerance ? *tolerance / unit : 0x1p-20;
  const bool is_reversed = run_against(first, first_side, second, second_side);
  const NurbsPatch a = ready(first.with_points(space.enter(first.points())), first_side, false);
  const NurbsPatch b = ready(second.with_points(space.enter(second.points())), second_side, is_reversed);
  require_common_edge(a, b, within, unit);
  const bool is_closed = a.knot_vector(Axis::u).periodic() && b.knot_vector(Axis::u).periodic();
  const Interval along = first.knot_vector(axis_of(first_side) == Axis::u ? Axis::v : Axis::u).domain();
  const std::vector<RailNumber> over_edge = over_unit(radii, along, unit);
  const NumbersAlong by_edge(over_edge, {0.0, 1.0}, is_closed, "radius");
  const RollingBall ball(a, b, by_edge);
  RowDomain domain{{0.0, 1.0}, joints_at(a.knot_vector(Axis::u)), is_closed ? Closing::closed : Closing::open};
  std::ranges::copy(joints_at(b.knot_vector(Axis::u)), std::back_inserter(domain.joints));
  const auto within_tolerance = [&](const auto& make) { return said_outside(space, make); };
  const Approximation<NurbsPatch> rounded = within_tolerance([&] { return rolled(ball, domain, within); });
  const Approximation<NurbsPatch> left_a = within_tolerance([&] { return shortened(a, ball, true, within); });
  const Approximation<NurbsPatch> left_b = within_tolerance([&] { return shortened(b, ball, false, within); });
  const auto out = [&](const NurbsPatch& patch) { return patch.with_points(space.leave(patch.points())); };
  const NurbsPatch back_b = is_reversed ? reversed(left_b.value, Axis::u) : left_b.value;
  return {with_side_back(out(left_a.value), first_side), out(rounded.value), with_side_back(out(back_b), second_side),
          unit * std::max({rounded.error, left_a.error, left_b.error})};
}

}  // namespace splinecore
