#include "splinecore/region/region.hpp"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "boundary.hpp"
#include "build/curve_ends.hpp"
#include "curve/affine.hpp"
#include "measure/unit_direction.hpp"
#include "region_plane.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/transform.hpp"
#include "splinecore/measure/plane_curve.hpp"
#include "splinecore/meet/nearest.hpp"

namespace splinecore {

namespace {

/// Ends in one point, in every bit, if they are one up to the tolerance.
NurbsCurve closed_up(const NurbsCurve& curve, std::size_t i, double tolerance) {
  const std::string name = "curves" + index_text(i);
  const std::size_t count = pieces(curve).size();
  if (count != 1) throw InvalidShape(name + " is not closed: it is in " + std::to_string(count) + " pieces");
  if (curve.periodic()) return curve;
  const NurbsCurve plain = clamped(curve);
  const auto [first, last] = std::pair{plain.points().front(), plain.points().back()};
  if (first.w == 0.0 || last.w == 0.0) throw InvalidShape(name + " is not closed: it ends at infinity");
  const double apart = distance_of(glm::dvec3(first), glm::dvec3(last));
  if (apart == 0.0) return curve;
  if (apart > tolerance) throw InvalidShape(name + " is not closed: its ends are " + text_of(apart) + " apart");
  return with_one_end(plain);
}

bool is_filled(int turns, FillRule rule) { return rule == FillRule::nonzero ? turns != 0 : turns % 2 != 0; }

bool is_in(RegionOperation operation, bool in_a, bool in_b) {
  switch (operation) {
    case RegionOperation::united: return in_a || in_b;
    case RegionOperation::common: return in_a && in_b;
    case RegionOperation::without: return in_a && !in_b;
    default: return in_a != in_b;
  }
}

}  // namespace

Region::Region(std::vector<NurbsCurve> outlines, const glm::dvec3& normal) : outlines_(std::move(outlines)), normal_(normal) {}

Region Region::of(std::span<const NurbsCurve> curves, std::optional<glm::dvec3> normal, FillRule rule, std::optional<double> tolerance) {
  if (normal) normal = unit_direction(*normal, "normal");
  if (curves.empty()) return Region({}, normal.value_or(glm::dvec3(0.0, 0.0, 1.0)));
  const double near = region_tolerance(curves, tolerance);
  const glm::dvec3 across = normal ? *normal : common_normal(curves, near);
  require_one_plane(curves, across, near);
  std::vector<NurbsCurve> closed;
  for (std::size_t i = 0; i < curves.size(); ++i) closed.push_back(closed_up(curves[i], i, near));
  WoundCurves found = wound_by(closed, [&](int turns) { return is_filled(turns, rule); }, across, near);
  if (!found.nothing.empty()) throw InvalidShape("curves" + index_text(found.nothing[0]) + " encloses nothing");
  return Region(std::move(found.loops), across);
}

Region Region::of_outlines(std::vector<NurbsCurve> outlines, const glm::dvec3& normal) {
  const glm::dvec3 across = unit_direction(normal, "normal");
  if (!outlines.empty()) require_one_plane(outlines, across, 4.0 * region_tolerance(outlines, {}));
  for (const NurbsCurve& outline : outlines) signed_area(outline, across);
  return Region(std::move(outlines), across);
}

Region combined(const Region& a, const Region& b, RegionOperation operation, std::optional<double> tolerance) {
  if (a.is_empty() && b.is_empty()) return a;
  const glm::dvec3& normal = a.is_empty() ? b.normal() : a.normal();
  const bool is_turned = glm::dot(normal, b.normal()) < 0.0;
  OwnedLoops loops{a.outlines(), std::vector<std::size_t>(a.outlines().size(), 0), 2};
  for (const NurbsCurve& outline : b.outlines()) {
    loops.curves.push_back(is_turned ? reversed(outline) : outline);
    loops.owners.push_back(1);
  }
  const double near = region_tolerance(loops.curves, tolerance);
  require_one_plane(loops.curves, normal, near);
  const auto is_inside = [&](std::span<const int> windings) { return is_in(operation, windings[0] > 0, windings[1] > 0); };
  return Region(boundary_of(loops, is_inside, normal, near), normal);
}

Region transformed(const Region& region, const glm::dmat4& matrix) {
  if (!is_affine(matrix)) throw InvalidShape("the map is not affine: take that of each of the outlines");
  const glm::dmat3 linear(matrix);
  const glm::dvec3 across = std::abs(region.normal().x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(region.normal(), across));
  const glm::dvec3 moved_x = linear * x;
  const glm::dvec3 moved_y = linear * glm::cross(region.normal(), x);
  const double scale = length_of(moved_x) * length_of(moved_y);
  const glm::dvec3 normal = glm::cross(moved_x, moved_y);
  if (!(length_of(normal) > kRoundingOfShape * scale)) throw InvalidShape("the map flattens the region");
  std::vector<NurbsCurve> outlines;
  for (const NurbsCurve& outline : region.outlines()) outlines.push_back(transformed(outline, matrix));
  return Region::of_outlines(std::move(outlines), normal);
}

std::vector<bool> contains(const Region& region, std::span<const glm::dvec3> points) {
  constexpr double kOnBorder = 1e-12;
  std::vector<int> turns(points.size(), 0);
  std::vector<bool> is_on(points.size(), false);
  std::vector<NearestOnCurve> found(points.size());
  for (const NurbsCurve& outline : region.outlines()) {
    const double near = 2.0 * kOnBorder * extent(outline.points());
    nearest(outline, points, found, 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (found[i].distance <= near) is_on[i] = true;
      if (!is_on[i]) turns[i] += winding_number(outline, points[i], region.normal());
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) is_on[i] = is_on[i] || turns[i] > 0;
  return is_on;
}

}  // namespace splinecore
