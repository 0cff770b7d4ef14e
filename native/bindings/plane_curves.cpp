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

void bind_plane_measures(const CurveClasses& cls) {
  cls.def("signed_area", [](const AnyCurve& self, const py::object& normal, const py::object& tolerance) {
            return signed_area(form(self), normal, tolerance);
          },
          py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0), py::kw_only(),
          py::arg("tolerance") = splinecore::kPlaneAreaTolerance);
  cls.def("winding_number", [](const AnyCurve& self, const py::object& point, const py::object& normal) {
            return winding_number(form(self), point, normal);
          },
          py::arg("point"), py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0));
}

}  // namespace

void bind_plane_curves(py::module_& module) {
  bind_plane_measures(CurveClasses(module));
}

}  // namespace bindings
