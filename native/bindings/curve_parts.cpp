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
          }, py::arg("start"), py::arg("end"),
          "The part of the curve between two parameters, over that part of its domain: a NurbsCurve. Of a closed curve the\n"
          "end may be up to a turn behind the start: over the seam. InvalidShape unless start < end, both in the domain but\n"
          "for that.");
  cls.def("parts", [](const AnyCurve& self, const py::object& parameters) {
            std::vector<double> at = numbers(parameters, "parameters");
            return unlocked([&] { return splinecore::parts(form(self), std::move(at)); });
          }, py::arg("parameters"),
          "The parts that the curve is cut into at parameters (n,), in their order: a list of NurbsCurve. Those at the ends\n"
          "of an open one, and those that are one up to rounding, cut nothing. Of a closed curve the last part goes over the\n"
          "seam, which is no cut. InvalidShape for a parameter outside the domain.");
  cls.def("split_by", [](const AnyCurve& self, const py::object& others, const py::object& cancel) {
            const std::vector<NurbsCurve> with = any_curves(others, "others");
            return unlocked([&] { return splinecore::parts(form(self), splinecore::meeting_parameters(form(self), with)); },
                            cancel);
          }, py::arg("others"), py::kw_only(), py::arg("cancel") = py::none(),
          "The parts() between the places where the curve meets others of any kinds, and the ends of stretches in common: a\n"
          "list of NurbsCurve. Lecture row S18.");
  cls.def("trimmed", [](const AnyCurve& self, const py::object& others, const py::object& at, const py::object& cancel) {
            const std::vector<NurbsCurve> with = any_curves(others, "others");
            const double about = real(at, "at");
            return unlocked([&] { return splinecore::trimmed(form(self), with, about); }, cancel);
          }, py::arg("others"), py::arg("at"), py::kw_only(), py::arg("cancel") = py::none(),
          "What is left of the curve without its part about the parameter `at`, between where it meets others of any kinds, or\n"
          "its own end: a list of one or two NurbsCurve. Lecture row S18. InvalidShape if they do not meet, or a closed curve\n"
          "meets them in one place alone.");
}

void bind_extensions(const CurveClasses& cls) {
  cls.def("extended", [](const AnyCurve& self, const py::object& length, const py::object& at, const py::object& how) {
            const double by = real(length, "length");
            const bool is_end = is_end_of(at, "at");
            const Extension as = extension_of(how);
            return unlocked([&] { return splinecore::extended(form(self), is_end, by, as); });
          }, py::arg("length"), py::arg("at") = "end", py::arg("how") = "natural",
          "The curve made longer at its 'start' or 'end' by a length: a NurbsCurve that keeps its parameters, the domain grows.\n\n"
          "how is 'natural': by the polynomials of its last span; 'arc': round its circle of curvature; 'straight': along its\n"
          "tangent. An arc where the curve is straight is straight. Lecture row S18. InvalidShape if the length is not above\n"
          "0, the curve is closed or stands still at its end, an arc would pass its whole circle, or the curve runs to\n"
          "infinity before that length.");
  cls.def("extended_to", [](const AnyCurve& self, const py::object& others, const py::object& at, const py::object& how,
                            const py::object& cancel) {
            const std::vector<NurbsCurve> to = any_curves(others, "others");
            const bool is_end = is_end_of(at, "at");
            const Extension as = extension_of(how);
            return unlocked([&] { return splinecore::extended_to(form(self), is_end, to, as); }, cancel);
          }, py::arg("others"), py::arg("at") = "end", py::arg("how") = "natural", py::kw_only(),
          py::arg("cancel") = py::none(),
          "The curve made longer at an end up to where it first meets others of any kinds, as extended(). InvalidShape if it\n"
          "meets none of them within four times the size of them all.");
}

}  // namespace

void bind_curve_parts(py::module_& module) {
  bind_cuts(CurveClasses(module));
  bind_extensions(CurveClasses(module));
}

}  // namespace bindings
