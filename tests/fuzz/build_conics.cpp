#include <glm/gtc/type_ptr.hpp>

#include "build_steps.hpp"
#include "looks.hpp"
#include "shapes.hpp"
#include "splinecore/conic/conic_arc.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/conic/implicit_form.hpp"
#include "splinecore/conic/make_conic.hpp"

namespace splinecore::fuzz {

namespace {

void demand_finite_vector(const glm::dvec3& v, const std::string& what) {
  demand_finite<double>(std::span(glm::value_ptr(v), 3), what);
}

void look_at_conic(Bytes& bytes, const ImplicitConic& conic) {
  demand_finite<double>(conic.coefficients(), "a coefficient");
  if (const auto middle = center(conic)) demand_finite_vector(*middle, "a center");
  for (const glm::dvec3& focus : foci(conic)) demand_finite_vector(focus, "a focus");
  for (const glm::dvec3& along : axis_directions(conic)) demand_finite_vector(along, "a direction of an axis");
  if (const auto found = eccentricity(conic)) demand(*found >= 0.0, "an eccentricity is negative or not a number");
  attempt([&] {
    for (const NurbsCurve& curve : curves_of(conic)) look_at_points(curve);
  });
  attempt([&] {
    const double start = bytes.number();
    look_at_points(arc_between(conic, start, bytes.number()));
  });
}

EllipseForm form(Bytes& bytes) { return static_cast<EllipseForm>(bytes.integer(0, 3)); }

void check_plane(const Plane& plane) {
  demand_finite_vector(plane.x_axis, "an axis of a plane");
  demand_finite_vector(plane.y_axis, "an axis of a plane");
}

constexpr BuildStep kBuilders[] = {
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 3);
      const BezierCurve arc = conic_arc(p[0], p[1], p[2], bytes.number());
      conic_class(arc);
      look_at_points(arc.nurbs());
      look_at_conic(bytes, implicit_conic(arc));
    },
    [](Bytes& bytes) {
      const BezierCurve arc = BezierCurve::make(points(bytes, 3));
      conic_class(arc);
      look_at_conic(bytes, implicit_conic(arc));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 3);
      const EllipseForm shape = form(bytes);
      attempt([&] { look_at_points(ellipse(p[0], p[1], p[2], shape)); });
      attempt([&] { look_at_points(circle(p[0], bytes.number(), p[1], shape)); });
      attempt([&] {
        const double start = bytes.number();
        const double sweep = bytes.number();
        look_at_points(ellipse_arc(p[0], p[1], p[2], start, sweep, bytes.integer(0, 9) - 1));
      });
      for (const NurbsCurve& branch : hyperbola(p[0], p[1], p[2])) look_at_points(branch);
    },
    [](Bytes& bytes) {
      std::array<double, 6> coefficients;
      for (double& one : coefficients) one = bytes.number();
      look_at_conic(bytes, ImplicitConic::make(coefficients));
    },
    [](Bytes& bytes) {
      auto p = vectors(bytes, bytes.integer(4, 6));
      if (bytes.integer(0, 3) != 0) {
        for (glm::dvec3& one : p) one.z = 0.0;
      }
      std::optional<double> tolerance;
      if (bytes.flag()) tolerance = bytes.tolerance();
      look_at_conic(bytes, conic_through(p, tolerance));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 3);
      look_at_conic(bytes, conic_by_foci(p[0], p[1], bytes.number(), p[2]));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 3);
      look_at_conic(bytes, parabola(p[0], p[1], p[2]));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 3);
      attempt([&] { check_plane(plane_along(p[0], p[1], p[2])); });
      attempt([&] { check_plane(plane_across(p[0], p[1])); });
      attempt([&] { check_plane(plane_of(p, bytes.tolerance())); });
      if (const auto found = plane_of_control_points(points(bytes, 3))) check_plane(*found);
    },
};

}  // namespace

std::span<const BuildStep> conic_builders() { return kBuilders; }

}  // namespace splinecore::fuzz
