#include <algorithm>

#include "fit_steps.hpp"
#include "finding.hpp"
#include "looks.hpp"
#include "shapes.hpp"
#include "splinecore/fit/fair.hpp"
#include "splinecore/fit/rebuild.hpp"
#include "splinecore/measure/flux.hpp"
#include "splinecore/measure/moments.hpp"
#include "splinecore/meet/stationary.hpp"
#include "splinecore/patch/distance.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

KeptEnds kept(Bytes& bytes) { return bytes.flag() ? KeptEnds::tangents : KeptEnds::points; }

template <class Shape>
void look_within(const Approximation<Shape>& made, double tolerance) {
  look_at_points(made.value);
  demand(made.error >= 0.0 && made.error <= tolerance, "a tolerance is not kept: " + text_of(made.error));
}

template <class Place>
void look_at_feet(const std::vector<Place>& found) {
  for (const Place& one : found) demand(one.distance >= 0.0, "a stationary distance is none");
}

VectorField field(Bytes& bytes) {
  const glm::dvec3 constant = vector(bytes);
  const glm::dvec3 slope = vector(bytes);
  const bool is_square = bytes.flag();
  return [=](std::span<const glm::dvec3> points, std::span<glm::dvec3> vectors) {
    std::ranges::transform(points, vectors.begin(), [&](const glm::dvec3& p) {
      return constant + slope * (is_square ? p * p : p);
    });
  };
}

constexpr FitStep kShapeFits[] = {
    [](Bytes& bytes) {
      const NurbsCurve curve = nurbs_curve(bytes);
      const int to = degree(bytes, 40);
      const auto made = rebuild(curve, to, static_cast<std::size_t>(bytes.integer(0, 60)), kept(bytes));
      look_at_points(made.value);
      demand_error(made.error, "a rebuilt curve");
    },
    [](Bytes& bytes) {
      const NurbsCurve curve = nurbs_curve(bytes);
      const double tolerance = bytes.tolerance();
      const int to = degree(bytes, 40);
      look_within(rebuild_within(curve, to, tolerance, 100, kept(bytes)), tolerance);
    },
    [](Bytes& bytes) {
      const NurbsCurve curve = nurbs_curve(bytes);
      const double tolerance = bytes.tolerance();
      look_within(fair(curve, tolerance, kept(bytes)), tolerance);
    },
    [](Bytes& bytes) {
      const NurbsPatch patch = nurbs_patch(bytes);
      const RebuiltDirection u{degree(bytes, 20), static_cast<std::size_t>(bytes.integer(0, 20))};
      const RebuiltDirection v{degree(bytes, 20), static_cast<std::size_t>(bytes.integer(0, 20))};
      const auto made = rebuild(patch, u, v);
      look_at_points(made.value);
      demand_error(made.error, "a rebuilt patch");
    },
    [](Bytes& bytes) {
      const NurbsPatch patch = nurbs_patch(bytes);
      const double tolerance = bytes.tolerance();
      const KeptEnds u = kept(bytes);
      const auto made = fair(patch, tolerance, u, kept(bytes));
      look_within(made, tolerance);
      demand(made.value.knot_vector(Axis::u) == patch.knot_vector(Axis::u), "a fair patch has other knots");
    },
    [](Bytes& bytes) {
      const NurbsCurve curve = nurbs_curve(bytes);
      const glm::dvec3 point = vector(bytes);
      look_at_feet(stationary_points(curve, point));
      look_at_feet(nearest_all(curve, point));
    },
    [](Bytes& bytes) {
      const NurbsPatch patch = nurbs_patch(bytes);
      const glm::dvec3 point = vector(bytes);
      look_at_feet(stationary_points(patch, point));
      look_at_feet(nearest_all(patch, point));
    },
    [](Bytes& bytes) {
      const NurbsPatch patch = nurbs_patch(bytes);
      const Approximation<double> found = flux(patch, field(bytes), bytes.tolerance());
      demand(std::isfinite(found.value) && found.error >= 0.0, "a flux is none");
    },
    [](Bytes& bytes) {
      const NurbsPatch patch = nurbs_patch(bytes);
      const Approximation<glm::dvec3> found = surface_centroid(patch, bytes.tolerance());
      demand_finite<double>(std::span(&found.value.x, 3), "a centroid");
      demand_error(found.error, "a centroid");
    },
};

}  // namespace

std::span<const FitStep> shape_fits() { return kShapeFits; }

void fit(Input data) {
  Bytes bytes(data);
  const std::size_t which = bytes.byte();
  const auto some = which % 2 == 0 ? point_fits() : shape_fits();
  attempt([&] { some[which / 2 % some.size()](bytes); });
}

}  // namespace splinecore::fuzz
