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
          }, py::arg("u"), py::arg("times") = 1, py::arg("tolerance") = py::none(),
          "Approximation by the curve with times copies fewer of the inner knot u.\n\n"
          "The nearest in its control points; those that the knot has no part in stay bit for bit. The error is\n"
          "the largest distance at equal parameters, at most 1 % too large. InvalidShape if u is no inner knot,\n"
          "ToleranceNotReached with a tolerance that the error exceeds. The NURBS Book, 5.4; row S15.");
  cls.def("remove_knots", [](const NurbsCurve& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return wrap(unlocked([&] { return splinecore::remove_knots(self, most); }, cancel));
          }, py::arg("tolerance"), py::kw_only(), py::arg("cancel") = py::none(),
          "Approximation by the curve without the inner knots that can go within the tolerance, a length.\n\n"
          "Least error first: knots that nothing needs go before any that shapes the curve. cancel is a callable that\n"
          "ends a long call by returning True. The NURBS Book, A5.9; row S15.");
  cls.def("elevate", [](const NurbsCurve& self, const py::object& times) {
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::elevated(self, count); });
          }, py::arg("times") = 1,
          "The same curve of a degree higher by times; every distinct knot has as many copies more.\n"
          "By blossoms, with convex weights. Row S15.");
  cls.def("reduce", [](const NurbsCurve& self, const py::object& times, const py::object& tolerance) {
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::reduced(self, count, most); }));
          }, py::arg("times") = 1, py::arg("tolerance") = py::none(),
          "Approximation by the nearest curve of a degree lower by times; a plain one keeps its ends, clamped.\n\n"
          "Nearest in its control points, in the sum of squares. Exact where the degree was raised before. The\n"
          "error is as of remove_knot(). ToleranceNotReached with a tolerance that it exceeds. Row S15.");
}

void bind_end_verbs(Class<NurbsCurve>& cls) {
  cls.def("with_domain", [](const NurbsCurve& self, const py::object& domain) {
            return splinecore::with_domain(self, interval_of(domain, "domain"));
          }, py::arg("domain"),
          "The same curve over another domain (start, end): the knots are mapped, the points stay.\n"
          "InvalidShape unless start < end. Row S15.");
  cls.def("clamped", [](const NurbsCurve& self) { return unlocked([&] { return splinecore::clamped(self); }); },
          "The same curve with both ends in its outer control points; a periodic one is cut at its seam.\nRow S15.");
  cls.def("unclamped", [](const NurbsCurve& self) { return unlocked([&] { return splinecore::unclamped(self); }); },
          "The same curve on knots that continue outside the domain; a periodic one is unrolled.\n"
          "InvalidShape where weights at an end are so different that rounding would move the curve.\n"
          "The NURBS Book, A12.1; row S15.");
  cls.def("to_periodic", [](const NurbsCurve& self, const py::object& tolerance) {
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::made_periodic(self, most); }));
          }, py::arg("tolerance") = py::none(),
          "Approximation by a periodic curve, as smooth at its seam as it is within the tolerance, a length.\n\n"
          "The default is a few roundings. ToleranceNotReached if the ends lie farther apart, InvalidShape if their\n"
          "weights differ or one lies at infinity. Row S15.");
}

void bind_measures(Class<NurbsCurve>& cls) {
  cls.def("largest_distance", [](const NurbsCurve& self, const NurbsCurve& other) {
            return unlocked([&] { return splinecore::largest_distance(self, other); });
          }, py::arg("other"),
          "The largest distance of points at equal parameters: an upper bound, at most 1 % above the truth.\n"
          "Where both run to infinity they are left out; where one does alone the distance is inf.\n"
          "InvalidShape if the domains differ.");
  cls.def("continuity", [](const NurbsCurve& self, const py::object& u, const py::object& tolerance) {
            const double at = real(u, "u");
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::continuity_at(self, at, most); });
          }, py::arg("u"), py::arg("tolerance") = splinecore::kContinuityTolerance,
          "The Continuity at a parameter inside the domain; a periodic curve takes any, modulo its period.\n"
          "tolerance is relative: below it a difference is called none. Row S16.");
  cls.def("joints", [](const NurbsCurve& self, const py::object& tolerance) {
            py::list found;
            const double most = real(tolerance, "tolerance");
            for (const auto& joint : unlocked([&] { return splinecore::joints(self, most); })) {
              found.append(py::make_tuple(joint.u, joint.continuity));
            }
            return found;
          }, py::arg("tolerance") = splinecore::kContinuityTolerance,
          "[(u, Continuity), …] of every inner knot, and of the seam of a closed curve.\n"
          "Joints at infinity are left out. Row S16.");
}

}  // namespace

void bind_verbs(Class<NurbsCurve>& cls) {
  bind_knot_verbs(cls);
  bind_end_verbs(cls);
  bind_measures(cls);
}

void bind_continuity(py::module_& module) {
  Class<Continuity> cls(
      module, "Continuity", py::module_local(),
      "The continuity of a curve where two of its pieces, or two curves, meet (lecture row S16).\n\n"
      "gap is a length, angle lies in [0, pi], curvature_difference is the length of the difference of the two\n"
      "curvature vectors. c counts the derivatives that agree, -1 for a gap; it is the degree where there is no\n"
      "joint at all. g is -1, 0, 1, 2, or c where that is more.");
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
