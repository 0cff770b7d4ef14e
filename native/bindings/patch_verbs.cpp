#include "patch_verbs.hpp"

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/removal.hpp"
#include "splinecore/patch/transform.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::BezierPatch;
using splinecore::HermitePatch;
using splinecore::NurbsPatch;

namespace {

/// The argument named `name`, a parameter of an axis.
double parameter_of(const py::object& value, const char* name, const NurbsPatch& patch, Axis axis) {
  const double u = real(value, name);
  require_inside(patch.knot_vector(axis), Doubles(py::float_(u)), splinecore::Side::right, name);
  return u;
}

/// The patch that has curves on it: a Hermite patch by its NURBS form.
const NurbsPatch& carrier(const NurbsPatch& patch) { return patch; }
const NurbsPatch& carrier(const HermitePatch& patch) { return patch.nurbs(); }
const BezierPatch& carrier(const BezierPatch& patch) { return patch; }

template <class Patch>
void bind_curves_of(Class<Patch>& cls) {
  cls.def("isocurve", [](const Patch& self, const py::object& axis, const py::object& at) {
            const Axis direction = axis_of(axis);
            const auto& patch = carrier(self);
            const double place = parameter_of(at, "at", patch_form(patch), direction);
            return unlocked([&] { return splinecore::isocurve(patch, direction, place); });
          }, py::arg("axis"), py::arg("at"));
  cls.def("boundary", [](const Patch& self, const py::object& side) {
            const auto border = border_of(side, "side");
            return unlocked([&] { return splinecore::boundary(carrier(self), border); });
          }, py::arg("side"));
}

template <class Patch>
void bind_degrees(Class<Patch>& cls) {
  cls.def("elevate", [](const Patch& self, const py::object& axis, const py::object& times) {
            const Axis direction = axis_of(axis);
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::elevated(self, direction, count); });
          }, py::arg("axis"), py::arg("times") = 1);
  cls.def("reduce", [](const Patch& self, const py::object& axis, const py::object& times,
                       const py::object& tolerance) {
            const Axis direction = axis_of(axis);
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::reduced(self, direction, count, most); }));
          }, py::arg("axis"), py::arg("times") = 1, py::arg("tolerance") = py::none());
}

void bind_removal(Class<NurbsPatch>& cls) {
  cls.def("remove_knot", [](const NurbsPatch& self, const py::object& axis, const py::object& u,
                            const py::object& times, const py::object& tolerance) {
            const Axis direction = axis_of(axis);
            const double at = parameter_of(u, "u", self, direction);
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::remove_knot(self, direction, at, count, most); }));
          }, py::arg("axis"), py::arg("u"), py::arg("times") = 1, py::arg("tolerance") = py::none());
  cls.def("remove_knots", [](const NurbsPatch& self, const py::object& axis, const py::object& tolerance,
                             const py::object& cancel) {
            const Axis direction = axis_of(axis);
            const double most = real(tolerance, "tolerance");
            return wrap(unlocked([&] { return splinecore::remove_knots(self, direction, most); }, cancel));
          }, py::arg("axis"), py::arg("tolerance"), py::kw_only(), py::arg("cancel") = py::none());
}

void bind_ends(Class<NurbsPatch>& cls) {
  cls.def("with_domain", [](const NurbsPatch& self, const py::object& axis, const py::object& domain) {
            return splinecore::with_domain(self, axis_of(axis), interval_of(domain, "domain"));
          }, py::arg("axis"), py::arg("domain"));
  cls.def("clamped", [](const NurbsPatch& self, const py::object& axis) {
            const Axis direction = axis_of(axis);
            return unlocked([&] { return splinecore::clamped(self, direction); });
          }, py::arg("axis"));
  cls.def("unclamped", [](const NurbsPatch& self, const py::object& axis) {
            const Axis direction = axis_of(axis);
            return unlocked([&] { return splinecore::unclamped(self, direction); });
          }, py::arg("axis"));
  cls.def("to_periodic", [](const NurbsPatch& self, const py::object& axis, const py::object& tolerance) {
            const Axis direction = axis_of(axis);
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::made_periodic(self, direction, most); }));
          }, py::arg("axis"), py::arg("tolerance") = py::none());
}

}  // namespace

void bind_patch_verbs(Class<NurbsPatch>& cls) {
  bind_curves_of(cls);
  bind_degrees(cls);
  bind_removal(cls);
  bind_ends(cls);
  cls.def("moebius", [](const NurbsPatch& self, const py::object& axis, const py::object& rho) {
            const Axis direction = axis_of(axis);
            const double ratio = real(rho, "rho");
            return unlocked([&] { return splinecore::moebius(self, direction, ratio); });
          }, py::arg("axis"), py::arg("rho"));
  cls.def("largest_distance", [](const NurbsPatch& self, const NurbsPatch& other) {
            return unlocked([&] { return splinecore::largest_distance(self, other); });
          }, py::arg("other"));
}

void bind_patch_verbs(Class<BezierPatch>& cls) {
  bind_curves_of(cls);
  bind_degrees(cls);
}

void bind_patch_verbs(Class<HermitePatch>& cls) { bind_curves_of(cls); }

}  // namespace bindings
