#include <glm/gtc/type_ptr.hpp>

#include "finding.hpp"
#include "patch_steps.hpp"
#include "shapes.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/exchange/json.hpp"
#include "splinecore/measure/area.hpp"
#include "splinecore/measure/patch_curvature.hpp"
#include "splinecore/measure/seam.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore::fuzz {

namespace {

struct Places {
  Places(Bytes& bytes, const NurbsPatch& patch) : u(bytes.integer(0, 4)), v(u.size()) {
    for (double& one : u) one = parameter(bytes, patch.knot_vector(Axis::u));
    for (double& one : v) one = parameter(bytes, patch.knot_vector(Axis::v));
    options.side_u = bytes.flag() ? Side::left : Side::right;
    options.side_v = bytes.flag() ? Side::left : Side::right;
    options.at_infinity = bytes.flag() ? AtInfinity::nan : AtInfinity::raise;
  }
  std::vector<double> u;
  std::vector<double> v;
  PatchOptions options;
};

void demand_points(std::span<const double> points, const Places& places) {
  if (places.options.at_infinity == AtInfinity::raise) demand_finite(points, "a point");
}

/// Unit vectors, or NaN where there is none.
void demand_normals(std::span<const double> normals) {
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const double size = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
    demand(std::isnan(size) || std::abs(size - 1.0) < 1e-9, "a normal has length " + std::to_string(size));
  }
}

constexpr PatchStep kMeasures[] = {
    [](Bytes& bytes, NurbsPatch& patch) {
      const Places places(bytes, patch);
      std::vector<float> coarse(3 * places.u.size());
      evaluate(patch, places.u, places.v, coarse, places.options);
      std::vector<double> out(3 * places.u.size());
      evaluate(patch, places.u, places.v, out, places.options);
      demand_points(out, places);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Places places(bytes, patch);
      std::vector<double> out(3 * places.u.size());
      std::vector<double> normals(out.size());
      evaluate_with_normals(patch, places.u, places.v, out, normals, places.options);
      demand_points(out, places);
      demand_normals(normals);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Places places(bytes, patch);
      std::vector<double> out(3 * places.u.size() * places.v.size());
      std::vector<double> normals(out.size());
      evaluate_grid(patch, places.u, places.v, out, places.options);
      demand_points(out, places);
      evaluate_grid_with_normals(patch, places.u, places.v, out, normals, places.options);
      demand_points(out, places);
      demand_normals(normals);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Places places(bytes, patch);
      const int order = bytes.integer(0, 20);
      std::vector<double> out(3 * places.u.size() * static_cast<std::size_t>((order + 1) * (order + 1)));
      derivatives(patch, places.u, places.v, order, out, places.options);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Places places(bytes, patch);
      std::vector<FundamentalForms> forms(places.u.size());
      fundamental_forms(patch, places.u, places.v, forms, places.options);
      for (const FundamentalForms& form : forms) {
        if (places.options.at_infinity == AtInfinity::nan) break;
        demand_finite<double>(std::array{form.e, form.f, form.g}, "the first fundamental form");
      }
      std::vector<SurfaceCurvature> bent(places.u.size());
      curvatures(patch, places.u, places.v, bent, places.options);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      const double at = parameter(bytes, patch.knot_vector(along));
      attempt([&] { isocurve(patch, along, at, bytes.flag() ? Side::left : Side::right); });
      boundary(patch, border(bytes));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const NurbsPatch other = patch.with_points(points(bytes, patch.points().size()));
      demand(largest_distance(patch, other) >= 0.0, "a distance is negative or not a number");
      demand(largest_distance(patch, patch) >= 0.0, "a patch's distance from itself is not a number");
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Approximation<double> found = area(patch, bytes.tolerance());
      demand(std::isfinite(found.value) && found.value >= 0.0 && found.error >= 0.0, "an area is none");
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const AnyPatch one = patch;
      const Approximation<double> found = volume(PatchSet::of(std::span(&one, 1), true), bytes.tolerance());
      demand(std::isfinite(found.value) && found.error >= 0.0, "a volume is none");
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Border side = border(bytes);
      const Border other_side = border(bytes);
      const NurbsPatch other = bytes.flag() ? nurbs_patch(bytes) : patch;
      const SeamContinuity seam = seam_continuity(patch, side, other, other_side, bytes.tolerance());
      demand(seam.gap >= 0.0 && seam.angle >= 0.0 && seam.curvature_difference >= 0.0, "a seam's number is none");
    },
    [](Bytes&, NurbsPatch& patch) {
      const Document document = Value(patch);
      demand(from_json(to_json(document)) == document, "a patch's text is read as another");
    },
    [](Bytes&, NurbsPatch& patch) {
      attempt([&] {
        for (const glm::dvec4& p : finite_homogeneous(patch.points())) {
          demand_finite<double>(std::span(glm::value_ptr(p), 4), "a homogeneous point");
        }
      });
    },
};

}  // namespace

std::span<const PatchStep> patch_measures() { return kMeasures; }

}  // namespace splinecore::fuzz
