#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "rooms.hpp"
#include "splinecore/curve/power_curve.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::PowerCurve;

namespace {

/// Coefficients of a polynomial: its denominator is 1.
std::vector<glm::dvec4> polynomial_rows(const py::object& coefficients) {
  std::vector<glm::dvec4> rows;
  for (const glm::dvec3& row : vectors(real_array(coefficients, "coefficients"), "coefficients", 1)) {
    rows.emplace_back(row, rows.empty() ? 1.0 : 0.0);
  }
  return rows;
}

void bind_making(Class<PowerCurve>& cls) {
  cls.def(py::init([](const py::object& coefficients, const py::object& origin, const py::object& domain) {
            return PowerCurve::make(polynomial_rows(coefficients), real(origin, "origin"), interval_of(domain, "domain"));
          }),
          py::arg("coefficients"), py::arg("origin") = 0.0, py::arg("domain") = py::make_tuple(0.0, 1.0));
  cls.def_static("from_homogeneous", [](const py::object& coefficients, const py::object& origin,
                                        const py::object& domain) {
                   return PowerCurve::make(rows_of_four(real_array(coefficients, "coefficients"), "coefficients", 1),
                                           real(origin, "origin"), interval_of(domain, "domain"));
                 },
                 py::arg("coefficients"), py::arg("origin") = 0.0, py::arg("domain") = py::make_tuple(0.0, 1.0));
}

void bind_parts(Class<PowerCurve>& cls) {
  const auto count = [](const PowerCurve& self) { return Shape{static_cast<py::ssize_t>(self.coefficients().size())}; };
  cls.def_property_readonly("coefficients", [count](const py::object& self) {
    const auto& curve = py::cast<const PowerCurve&>(self);
    return view_of_points(curve.coefficients(), count(curve), self);
  });
  cls.def_property_readonly("weights", [count](const py::object& self) {
    const auto& curve = py::cast<const PowerCurve&>(self);
    return view_of_weights(curve.coefficients(), count(curve), self);
  });
  cls.def_property_readonly("homogeneous_coefficients", [](const py::object& self) {
    const auto rows = py::cast<const PowerCurve&>(self).coefficients();
    return view_of_numbers(std::span(&rows.data()->x, 4 * rows.size()), {static_cast<py::ssize_t>(rows.size()), 4}, self);
  });
  cls.def_property_readonly("origin", &PowerCurve::origin);
}

void bind_verbs(Class<PowerCurve>& cls) {
  cls.def("with_origin", [](const PowerCurve& self, const py::object& origin) {
            return splinecore::with_origin(self, real(origin, "origin"));
          }, py::arg("origin"));
  cls.def("to_power", [](const PowerCurve& self, const py::object& origin) {
            return splinecore::with_origin(self, real(origin, "origin"));
          }, py::arg("origin") = 0.0);
  cls.def("with_domain", [](const PowerCurve& self, const py::object& domain) {
            return splinecore::with_domain(self, interval_of(domain, "domain"));
          }, py::arg("domain"));
  cls.def("derivative", [](const PowerCurve& self) { return splinecore::derivative(self); });
  cls.def("split", [](const PowerCurve& self, const py::object& u) { return splinecore::split(self, real(u, "u")); },
          py::arg("u"));
  cls.def("reversed", [](const PowerCurve& self) { return splinecore::reversed(self); });
  cls.def("to_nurbs", [](const PowerCurve& self) { return self.nurbs(); });
  cls.def("__repr__", [](const PowerCurve& self) {
    return "PowerCurve(degree=" + std::to_string(self.degree()) + ", origin=" + splinecore::text_of(self.origin()) +
           (self.polynomial() ? ")" : ", rational)");
  });
}

}  // namespace

void bind_power(py::module_& module) {
  Class<PowerCurve> cls(
      module, "PowerCurve", py::module_local());
  bind_making(cls);
  bind_value(cls);
  bind_parts(cls);
  bind_verbs(cls);
}

}  // namespace bindings
