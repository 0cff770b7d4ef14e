#include "verbs.hpp"

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/removal.hpp"
#include "splinecore/measure/continuity.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Continuity;
using splinecore::InvalidShape;
using splinecore::NurbsCurve;

namespace {

void bind_knot_verbs(Class<NurbsCurve>& cls) {
  cls.def("remove_knot", [](const NurbsCurve& self, const py::object& u, const py::object& times,
                            const py::object& tolerance) {
            const double at = real(u, "u");
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::remove_knot(self, at, count, most); }));
          }, py::arg("u"), py::arg("times") = 1, py::arg("tolerance") = py::none());
  cls.def("remove_knots", [](const NurbsCurve& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return wrap(unlocked([&] { return splinecore::remove_knots(self, most); }, cancel));
          }, py::arg("tolerance"), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("elevate", [](const NurbsCurve& self, const py::object& times) {
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::elevated(self, count); });
          }, py::arg("times") = 1);
  cls.def("reduce", [](const NurbsCurve& self, const py::object& times, const py::object& tolerance) {
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::reduced(self, count, most); }));
          }, py::arg("times") = 1, py::arg("tolerance") = py::none());
}

void bind_end_verbs(Class<NurbsCurve>& cls) {
  cls.def("with_domain", [](const NurbsCurve& self, const py::object& domain) {
            return splinecore::with_domain(self, interval_of(domain, "domain"));
          }, py::arg("domain"));
  cls.def("clamped", [](const NurbsCurve& self) { return unlocked([&] { return splinecore::clamped(self); }); });
  cls.def("unclamped", [](const NurbsCurve& self) { return unlocked([&] { return splinecore::unclamped(self); }); });
  cls.def("to_periodic", [](const NurbsCurve& self, const py::object& tolerance) {
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::made_periodic(self, most); }));
          }, py::arg("tolerance") = py::none());
}

void bind_measures(Class<NurbsCurve>& cls) {
  cls.def("largest_distance", [](const NurbsCurve& self, const NurbsCurve& other) {
            return unlocked([&] { return splinecore::largest_distance(self, other); });
          }, py::arg("other"));
  cls.def("continuity", [](const NurbsCurve& self, const py::object& u, const py::object& tolerance) {
            const double at = real(u, "u");
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::continuity_at(self, at, most); });
          }, py::arg("u"), py::arg("tolerance") = splinecore::kContinuityTolerance);
  cls.def("joints", [](const NurbsCurve& self, const py::object& tolerance) {
            py::list found;
            const double most = real(tolerance, "tolerance");
            for (const auto& joint : unlocked([&] { return splinecore::joints(self, most); })) {
              found.append(py::make_tuple(joint.u, joint.continuity));
            }
            return found;
          }, py::arg("tolerance") = splinecore::kContinuityTolerance);
}

}  // namespace

void bind_verbs(Class<NurbsCurve>& cls) {
  bind_knot_verbs(cls);
  bind_end_verbs(cls);
  bind_measures(cls);
}

void bind_continuity(py::module_& module) {
  Class<Continuity> cls(
      module, "Continuity", py::module_local());
  seal(cls);
  pickle_members(cls, &Continuity::gap, &Continuity::angle, &Continuity::curvature_difference, &Continuity::c,
                  &Continuity::g);
  cls.def_readonly("gap", &Continuity::gap);
  cls.def_readonly("angle", &Continuity::angle);
  cls.def_readonly("curvature_difference", &Continuity::curvature_difference);
  cls.def_readonly("c", &Continuity::c);
  cls.def_readonly("g", &Continuity::g);
  cls.def("__repr__", [](const Continuity& self) {
    const auto text = [](double value) { return splinecore::text_of(value); };
    return "Continuity(gap=" + text(self.gap) + ", angle=" + text(self.angle) + ", curvature_difference=" +
           text(self.curvature_difference) + ", c=" + std::to_string(self.c) + ", g=" + std::to_string(self.g) + ")";
  });
}

}  // namespace bindings
