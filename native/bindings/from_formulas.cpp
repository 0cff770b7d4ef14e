#include <array>

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "formulas.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/build/curve_from_formulas.hpp"
#include "splinecore/build/patch_from_formulas.hpp"

namespace bindings {

namespace {

/// A number, which may be infinite or NaN: the library refuses it in its own words.
double length_of(const py::object& value, const char* name) {
  const Doubles array = real_array(value, name);
  return array.size() == 1 ? *array.data() : real(value, name);
}

AnyApproximation curve_from_formulas(const py::object& formulas, const py::object& domain, const py::object& tolerance,
                                     const py::object& variable, const py::object& constants) {
  const auto coordinates = formulas_of(formulas, {text_argument(variable, "variable")}, constants);
  const splinecore::Interval range = interval_of(domain, "domain");
  const double within = length_of(tolerance, "tolerance");
  return wrap(unlocked([&] { return splinecore::curve_from_formulas(coordinates, range, within); }));
}

AnyApproximation patch_from_formulas(const py::object& formulas, const py::object& domain_u, const py::object& domain_v,
                                     const py::object& tolerance, const py::object& variables,
                                     const py::object& constants) {
  const auto coordinates = formulas_of(formulas, names_of(variables, "variables"), constants);
  const std::array domains{interval_of(domain_u, "domain_u"), interval_of(domain_v, "domain_v")};
  const double within = length_of(tolerance, "tolerance");
  return wrap(unlocked([&] { return splinecore::patch_from_formulas(coordinates, domains, within); }));
}

}  // namespace

void bind_from_formulas(py::module_& module) {
  py::module_ build = module.attr("build");
  build.def("curve_from_formulas", &curve_from_formulas, py::arg("formulas"), py::arg("domain"), py::kw_only(),
             py::arg("tolerance") = 1e-6, py::arg("variable") = "t", py::arg("constants") = py::none());
  build.def("patch_from_formulas", &patch_from_formulas, py::arg("formulas"), py::arg("domain_u"),
             py::arg("domain_v"), py::kw_only(), py::arg("tolerance") = 1e-6,
             py::arg("variables") = py::make_tuple("u", "v"), py::arg("constants") = py::none());
}

}  // namespace bindings
