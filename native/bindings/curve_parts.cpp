#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/build/extend.hpp"
#include "splinecore/build/part.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Extension;
using splinecore::NurbsCurve;

namespace {

Extension extension_of(const py::object& word) {
  return chosen<Extension>(word, "how", {{"natural", Extension::natural}, {"arc", Extension::arc}, {"straight", Extension::straight}});
}

void bind_cuts(const CurveClasses& cls) {
  cls.def("part", [](const AnyCurve& self, const py::object& start, const py::object& end) {
            const double from = real(start, "start");
            const double to = real(end, "end");
            return unlocked([&] { return splinecore::part(form(self), from, to); });
          }, py::arg("start"), py::arg("end"));
  cls.def("parts", [](const AnyCurve& self, const py::object& parameters) {
            std::vector<double> at = numbers(parameters, "parameters");
            return unlocked([&] { return splinecore::parts(form(self), std::move(at)); });
          }, py::arg("parameters"));
  cls.def("split_by", [](const AnyCurve& self, const py::object& others, const py::object& cancel) {
            const std::vector<NurbsCurve> with = any_curves(others, "others");
            return unlocked([&] { return splinecore::parts(form(self), splinecore::meeting_parameters(form(self), with)); },
                            cancel);
          }, py::arg("others"), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("trimmed", [](const AnyCurve& self, const py::object& others, const py::object& at, const py::object& cancel) {
            const std::vector<NurbsCurve> with = any_curves(others, "others");
            const double about = real(at, "at");
            return unlocked([&] { return splinecore::trimmed(form(self), with, about); }, cancel);
          }, py::arg("others"), py::arg("at"), py::kw_only(), py::arg("cancel") = py::none());
}

void bind_extensions(const CurveClasses& cls) {
  cls.def("extended", [](const AnyCurve& self, const py::object& length, const py::object& at, const py::object& how) {
            const double by = real(length, "length");
            const bool is_end = is_end_of(at, "at");
            const Extension as = extension_of(how);
            return unlocked([&] { return splinecore::extended(form(self), is_end, by, as); });
          }, py::arg("length"), py::arg("at") = "end", py::arg("how") = "natural");
  cls.def("extended_to", [](const AnyCurve& self, const py::object& others, const py::object& at, const py::object& how,
                            const py::object& cancel) {
            const std::vector<NurbsCurve> to = any_curves(others, "others");
            const bool is_end = is_end_of(at, "at");
            const Extension as = extension_of(how);
            return unlocked([&] { return splinecore::extended_to(form(self), is_end, to, as); }, cancel);
          }, py::arg("others"), py::arg("at") = "end", py::arg("how") = "natural", py::kw_only(),
          py::arg("cancel") = py::none());
}

}  // namespace

void bind_curve_parts(py::module_& module) {
  bind_cuts(CurveClasses(module));
  bind_extensions(CurveClasses(module));
}

}  // namespace bindings
