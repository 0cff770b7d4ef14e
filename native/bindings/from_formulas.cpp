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
             py::arg("tolerance") = 1e-6, py::arg("variable") = "t", py::arg("constants") = py::none(),
             "The NurbsCurve x(t), y(t) and perhaps z(t) over domain (start, end), with its error.\n\n"
             "Each formula is a str, read with the variable and the constants, or a Formula of one variable. The\n"
             "parameter of the curve is t. Polynomials give one exact Bezier span, error 0; anything else C2 quintic\n"
             "pieces, cut till they lie within the tolerance, a length. InvalidShape names a parameter without a\n"
             "value; ToleranceNotReached is raised at a jump or a pole. Lecture row S1.");
  build.def("patch_from_formulas", &patch_from_formulas, py::arg("formulas"), py::arg("domain_u"),
             py::arg("domain_v"), py::kw_only(), py::arg("tolerance") = 1e-6,
             py::arg("variables") = py::make_tuple("u", "v"), py::arg("constants") = py::none(),
             "The NurbsPatch x(u, v), y(u, v), z(u, v) over domains (start, end), with its error.\n\n"
             "Formulas as for curves, of two variables. Polynomials give one exact Bezier patch, error 0; anything\n"
             "else a C2 biquintic patch on a grid with as many lines as the tolerance asks for. Creases that follow\n"
             "no line of the grid raise ToleranceNotReached. Lecture row S1.");
}

}  // namespace bindings
