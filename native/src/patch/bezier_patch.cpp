#include "splinecore/patch/bezier_patch.hpp"

#include <algorithm>
#include <string>

#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

KnotVector bezier_axis(int count, const char* name) {
  if (count >= 2 && count <= kMaxDegree + 1) return KnotVector::bezier(count - 1);
  throw InvalidShape("points has " + std::to_string(count) + " in " + name +
                     ", a Bezier patch needs from 2 to " + std::to_string(kMaxDegree + 1));
}

}  // namespace

BezierPatch BezierPatch::make(int count_u, int count_v, std::vector<glm::dvec4> points) {
  KnotVector knots_u = bezier_axis(count_u, "u");
  return BezierPatch(NurbsPatch::make(std::move(knots_u), bezier_axis(count_v, "v"), std::move(points)));
}

std::pair<BezierPatch, BezierPatch> split(const BezierPatch& patch, Axis axis, double u) {
  const auto [before, after] = split(patch.nurbs(), axis, u);
  return {as_bezier(before), as_bezier(after)};
}

BezierPatch reversed(const BezierPatch& patch, Axis axis) { return as_bezier(reversed(patch.nurbs(), axis)); }

BezierPatch swapped(const BezierPatch& patch) { return as_bezier(swapped(patch.nurbs())); }

}  // namespace splinecore
