#include "creases.hpp"

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

std::vector<double> places_in_spans(const KnotVector& knots, int count) {
  std::vector<double> places;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (int k = 0; k < count; ++k) places.push_back(span.start + span.length() * (k + 0.5) / count);
  }
  return places;
}

namespace {

std::vector<glm::dvec3> normals_along(const NurbsPatch& patch, Axis axis, double at, Side side) {
  const double knot[] = {at};
  const std::vector<double> others = places_in_spans(patch.knot_vector(axis == Axis::u ? Axis::v : Axis::u));
  std::vector<double> points(3 * others.size());
  std::vector<glm::dvec3> normals(others.size());
  const std::span<double> out(&normals.front().x, points.size());
  PatchOptions options{.at_infinity = AtInfinity::nan};
  (axis == Axis::u ? options.side_u : options.side_v) = side;
  if (axis == Axis::u) {
    evaluate_grid_with_normals(patch, knot, others, points, out, options);
  } else {
    evaluate_grid_with_normals(patch, others, knot, points, out, options);
  }
  return normals;
}

/// Inner knots, and the seam of a periodic direction, at which there may be a crease.
std::vector<double> doubtful_knots(const KnotVector& knots) {
  const Interval domain = knots.domain();
  std::vector<double> found;
  for (const double knot : knots.knots()) {
    const bool is_joint = knots.periodic() ? knot < domain.end : knot > domain.start && knot < domain.end;
    if (is_joint && multiplicity(knots, knot) >= knots.degree() && (found.empty() || found.back() != knot)) found.push_back(knot);
  }
  return found;
}

}  // namespace

void require_smooth(const NurbsPatch& patch, Axis axis) {
  constexpr double kCrease = 1e-7;
  const KnotVector& knots = patch.knot_vector(axis);
  for (const double knot : doubtful_knots(knots)) {
    const double before = knots.periodic() && knot == knots.domain().start ? knots.domain().end : knot;
    const auto left = normals_along(patch, axis, before, Side::left);
    const auto right = normals_along(patch, axis, knot, Side::right);
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (!(length_of(left[i] - right[i]) > kCrease)) continue;
      throw InvalidShape(std::string("the patch has a crease at ") + (axis == Axis::u ? "u = " : "v = ") + text_of(knot) +
                         ": split it there first");
    }
  }
}

}  // namespace splinecore
