#include "splinecore/surface/offset_patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "base/require.hpp"
#include "base/rounding.hpp"
#include "build/fit_options.hpp"
#include "creases.hpp"
#include "fitted_patch.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "patch/compatible_patches.hpp"
#include "patch/gathered_poles.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/build/sweeps.hpp"
#include "splinecore/measure/patch_curvature.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

constexpr std::array<Axis, 2> kBoth{Axis::u, Axis::v};
constexpr double kTolerance = 0x1p-20;  ///< of the size of a patch
constexpr double kGathered = 0x1p-4;    ///< of the tolerance: how far points of a side may be from that which it is meant to be

std::string place_text(double u, double v) { return "u = " + text_of(u) + ", v = " + text_of(v); }

std::string short_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

/// @throws InvalidShape where the patch bends towards the offset with a radius that is not longer than the distance.
void require_room(const NurbsPatch& patch, double distance, double unit) {
  std::vector<double> u;
  std::vector<double> v;
  for (const double a : places_in_spans(patch.knot_vector(Axis::u))) {
    for (const double b : places_in_spans(patch.knot_vector(Axis::v))) {
      u.push_back(a);
      v.push_back(b);
    }
  }
  std::vector<SurfaceCurvature> bends(u.size());
  curvatures(patch, u, v, bends, {.at_infinity = AtInfinity::nan});
  for (std::size_t i = 0; i < bends.size(); ++i) {
    for (const double curvature : bends[i].principal) {
      if (!(curvature * distance >= 1.0)) continue;
      throw InvalidShape("the patch bends with a radius of " + short_text(unit / std::abs(curvature)) + " at " + place_text(u[i], v[i]) +
                         ": its offset would fold there");
    }
  }
}

/// @throws InvalidShape where an offset turns back over its patch
void require_no_fold(const NurbsPatch& patch, const NurbsPatch& made) {
  constexpr int kInSpan = 2;
  const std::vector<double> u = places_in_spans(made.knot_vector(Axis::u), kInSpan);
  const std::vector<double> v = places_in_spans(made.knot_vector(Axis::v), kInSpan);
  const auto normals_of = [&](const NurbsPatch& one) {
    std::vector<glm::dvec3> points(u.size() * v.size());
    std::vector<glm::dvec3> normals(points.size());
    evaluate_grid_with_normals(one, u, v, std::span(&points.front().x, 3 * points.size()),
                               std::span(&normals.front().x, 3 * normals.size()));
    return normals;
  };
  const std::vector<glm::dvec3> before = normals_of(patch);
  const std::vector<glm::dvec3> after = normals_of(made);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!(glm::dot(before[i], after[i]) < 0.0)) continue;
    throw InvalidShape("the patch bends more than the distance allows at " + place_text(u[i / v.size()], v[i % v.size()]) +
                       ": its offset would fold there");
  }
}

NurbsPatch offset_within(const NurbsPatch& near, double distance, double tolerance, double& error) {
  const auto surface = [&](std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> points) {
    std::vector<glm::dvec3> normals(points.size());
    evaluate_grid_with_normals(near, u, v, std::span(&points.front().x, 3 * points.size()),
                               std::span(&normals.front().x, 3 * normals.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_finite(normals[i])) {
        throw InvalidShape("the patch has no normal at " + place_text(u[i / v.size()], v[i % v.size()]) + ": it cannot be offset");
      }
      points[i] += distance * normals[i];
    }
  };
  const Approximation<NurbsPatch> made = fitted_patch(near, surface, tolerance);
  error = made.error;
  require_no_fold(near, made.value);
  return made.value;
}

/// Up to rounding of a shape of a size.
bool is_point(const NurbsCurve& side, double size) {
  constexpr double kRounding = 0x1p-44;
  const auto points = side.points();
  return std::ranges::all_of(points, [&](const glm::dvec4& p) {
    return length_of(glm::dvec3(p) - glm::dvec3(points.front())) <= kRounding * size;
  });
}

/// Whether both sides of a direction are one curve.
bool closes(const NurbsPatch& patch, Axis axis) {
  const NurbsCurve a = boundary(patch, axis == Axis::u ? Border::u_start : Border::v_start);
  const NurbsCurve b = boundary(patch, axis == Axis::u ? Border::u_end : Border::v_end);
  const double size = extent(patch.points());
  for (std::size_t i = 0; i < a.points().size(); ++i) {
    if (!(length_of(glm::dvec3(a.points()[i]) - glm::dvec3(b.points()[i])) <= kRoundingOfPlace * size)) return false;
  }
  return true;
}

}  // namespace

Approximation<NurbsPatch> offset(const NurbsPatch& patch, double distance, std::optional<double> tolerance) {
  if (tolerance) require_positive(*tolerance);
  if (!std::isfinite(distance)) throw InvalidShape("the distance is not finite");
  if (distance == 0.0) return {patch, 0.0};
  const NearSpace space(patch.points());
  const double unit = space.length(1.0);
  const double within = tolerance ? *tolerance / unit : kTolerance;
  const auto [near, moved] = with_gathered_poles(patch.with_points(space.enter(patch.points())), kGathered * within);
  for (const Axis axis : kBoth) require_smooth(near, axis);
  require_room(near, distance / unit, unit);
  double error = 0.0;
  const NurbsPatch made = said_outside(space, [&] {
    return offset_within(near, distance / unit, within - moved, error);
  });
  return {made.with_points(space.leave(made.points())), space.length(error + moved)};
}

Approximation<std::vector<NurbsPatch>> thickened(const NurbsPatch& given, double from, double to, std::optional<double> tolerance) {
  if (from == to) throw InvalidShape("both distances are " + text_of(from) + ": there is no thickness between");
  const double within = tolerance ? *tolerance : kTolerance * NearSpace(given.points()).length(1.0);
  const auto [patch, moved] = with_gathered_poles(given, kGathered * within);
  const auto [low, high] = std::minmax(from, to);
  double error = 0.0;
  const auto away = [&](double distance) {
    const Approximation<NurbsPatch> made = offset(patch, distance, within - moved - kGathered * within);
    const GatheredPoles gathered = with_gathered_poles(made.value, kGathered * within);
    error = std::max(error, moved + made.error + gathered.moved);
    return gathered.patch;
  };
  const std::array<NurbsPatch, 2> both{away(low), away(high)};
  const std::vector<NurbsPatch> large = compatible(both);
  std::vector<NurbsPatch> made{large[1], reversed(large[0], Axis::u)};
  const double size = extent(large[1].points());
  for (const Border side : {Border::v_start, Border::u_end, Border::v_end, Border::u_start}) {
    const Axis axis = axis_of(side);
    if (patch.knot_vector(axis).periodic() || (closes(large[0], axis) && closes(large[1], axis))) continue;
    const NurbsCurve below = boundary(large[0], side);
    const NurbsCurve above = boundary(large[1], side);
    if (is_point(below, size) && is_point(above, size)) continue;
    const bool is_backwards = side == Border::v_end || side == Border::u_start;
    const NurbsPatch wall = ruled(below, above);
    made.push_back(is_backwards ? reversed(wall, Axis::u) : wall);
  }
  return {std::move(made), error};
}

}  // namespace splinecore
