#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/measure/plane_curve.hpp"

namespace bindings {

using splinecore::NurbsCurve;

namespace {

double signed_area(const NurbsCurve& curve, const py::object& normal, const py::object& tolerance) {
  const glm::dvec3 across = vector_of(normal, "normal");
  const double most = real(tolerance, "tolerance");
  return unlocked([&] { return splinecore::signed_area(curve, across, most).value; });
}

int winding_number(const NurbsCurve& curve, const py::object& point, const py::object& normal) {
  const glm::dvec3 around = vector_of(point, "point");
  const glm::dvec3 across = vector_of(normal, "normal");
  return unlocked([&] { return splinecore::winding_number(curve, around, across); });
}

void bind_curve(const CurveClasses& cls) {
  cls.def("signed_area", [](const AnyCurve& self, const py::object& normal, const py::object& tolerance) {
            return signed_area(form(self), normal, tolerance);
          },
          py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0), py::kw_only(),
          py::arg("tolerance") = splinecore::kPlaneAreaTolerance,
          "The area within a closed curve, a float: positive where it lies to the left, seen against the\n"
          "normal (3,); parts enclosed twice count twice.\n\n"
          "Of a curve that is not in a plane at right angles to the normal it is that of what is seen. By Green's\n"
          "theorem: exact of polynomials but for rounding, of rational curves off by at most the tolerance times what\n"
          "the line from the curve's middle sweeps. InvalidShape if the ends are apart by more than 1e-9 of the size\n"
          "or the curve is in several pieces; PointAtInfinity, ToleranceNotReached. Row S15.");
  cls.def("winding_number", [](const AnyCurve& self, const py::object& point, const py::object& normal) {
            return winding_number(form(self), point, normal);
          },
          py::arg("point"), py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0),
          "The winding number of a closed curve around a point (3,), to the left, seen against the normal (3,): an int.\n\n"
          "0 outside. The crossings of a ray, all roots of a polynomial on every span. InvalidShape if the point lies\n"
          "on the curve up to 1e-12 of its size; and as signed_area(). Row S15.");
}

}  // namespace

void bind_plane_curves(py::module_& module) {
  bind_curve(CurveClasses(module));
}

}  // namespace bindings
