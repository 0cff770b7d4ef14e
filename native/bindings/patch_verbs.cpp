#include "patch_verbs.hpp"

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
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

const NurbsPatch& form(const NurbsPatch& patch) { return patch; }
const NurbsPatch& form(const BezierPatch& patch) { return patch.nurbs(); }

template <class Patch>
void bind_curves_of(Class<Patch>& cls) {
  cls.def("isocurve", [](const Patch& self, const py::object& axis, const py::object& at) {
            const Axis direction = axis_of(axis);
            const auto& patch = carrier(self);
            const double place = parameter_of(at, "at", form(patch), direction);
            return unlocked([&] { return splinecore::isocurve(patch, direction, place); });
          }, py::arg("axis"), py::arg("at"),
          "The curve on the patch along which the parameter of axis 'u' or 'v' is at: a NurbsCurve, of a\n"
          "BezierPatch a BezierCurve. Exact, on the knots of the other axis, periodic where that is; at a knot the\n"
          "patch's value from there on. A periodic axis takes any, modulo its period. InvalidShape if at is outside\n"
          "the domain of a plain one or the curve lies at infinity altogether. The NURBS Book, 3.4; rows S18, S20.");
  cls.def("boundary", [](const Patch& self, const py::object& side) {
            const auto border = border_of(side, "side");
            return unlocked([&] { return splinecore::boundary(carrier(self), border); });
          }, py::arg("side"),
          "The curve of a side, 'u_start', 'u_end', 'v_start' or 'v_end', as of isocurve(); of a periodic axis its\n"
          "seam. InvalidShape if the side lies at infinity altogether. Rows S20, S21.");
}

template <class Patch>
void bind_degrees(Class<Patch>& cls, const char* elevate, const char* reduce) {
  cls.def("elevate", [](const Patch& self, const py::object& axis, const py::object& times) {
            const Axis direction = axis_of(axis);
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::elevated(self, direction, count); });
          }, py::arg("axis"), py::arg("times") = 1, elevate);
  cls.def("reduce", [](const Patch& self, const py::object& axis, const py::object& times,
                       const py::object& tolerance) {
            const Axis direction = axis_of(axis);
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::reduced(self, direction, count, most); }));
          }, py::arg("axis"), py::arg("times") = 1, py::arg("tolerance") = py::none(), reduce);
}

void bind_removal(Class<NurbsPatch>& cls) {
  cls.def("remove_knot", [](const NurbsPatch& self, const py::object& axis, const py::object& u,
                            const py::object& times, const py::object& tolerance) {
            const Axis direction = axis_of(axis);
            const double at = parameter_of(u, "u", self, direction);
            const int count = integer(times, "times");
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::remove_knot(self, direction, at, count, most); }));
          }, py::arg("axis"), py::arg("u"), py::arg("times") = 1, py::arg("tolerance") = py::none(),
          "Approximation by the patch with times copies fewer of the inner knot u of an axis, 'u' or 'v'.\n\n"
          "Every line of the net becomes the nearest in its control points; those that the knot has no part in\n"
          "stay bit for bit. The error is as of largest_distance(). InvalidShape if u is no inner knot,\n"
          "ToleranceNotReached with a tolerance that the error exceeds. The NURBS Book, 5.4; row S20.");
  cls.def("remove_knots", [](const NurbsPatch& self, const py::object& axis, const py::object& tolerance,
                             const py::object& cancel) {
            const Axis direction = axis_of(axis);
            const double most = real(tolerance, "tolerance");
            return wrap(unlocked([&] { return splinecore::remove_knots(self, direction, most); }, cancel));
          }, py::arg("axis"), py::arg("tolerance"), py::kw_only(), py::arg("cancel") = py::none(),
          "Approximation by the patch without the inner knots of an axis that can go within the tolerance, a length.\n\n"
          "Least error first, as of a curve. cancel is a callable that ends a long call by returning True. Row S20.");
}

void bind_ends(Class<NurbsPatch>& cls) {
  cls.def("with_domain", [](const NurbsPatch& self, const py::object& axis, const py::object& domain) {
            return splinecore::with_domain(self, axis_of(axis), interval_of(domain, "domain"));
          }, py::arg("axis"), py::arg("domain"),
          "The same patch over another domain (start, end) of an axis: the knots are mapped, the points stay.\n"
          "InvalidShape unless start < end. Row S20.");
  cls.def("clamped", [](const NurbsPatch& self, const py::object& axis) {
            const Axis direction = axis_of(axis);
            return unlocked([&] { return splinecore::clamped(self, direction); });
          }, py::arg("axis"),
          "The same patch with both ends of an axis in its outer control points; a periodic axis is cut at its seam.\n"
          "Row S20.");
  cls.def("unclamped", [](const NurbsPatch& self, const py::object& axis) {
            const Axis direction = axis_of(axis);
            return unlocked([&] { return splinecore::unclamped(self, direction); });
          }, py::arg("axis"),
          "The same patch on knots of an axis that go on outside the domain; a periodic axis is unrolled.\n"
          "InvalidShape where weights at an end are so different that rounding would move the patch.\n"
          "The NURBS Book, A12.1; row S20.");
  cls.def("to_periodic", [](const NurbsPatch& self, const py::object& axis, const py::object& tolerance) {
            const Axis direction = axis_of(axis);
            const auto most = tolerance_of(tolerance);
            return wrap(unlocked([&] { return splinecore::made_periodic(self, direction, most); }));
          }, py::arg("axis"), py::arg("tolerance") = py::none(),
          "Approximation by a patch that is periodic along an axis, as smooth at its seam as it is within the\n"
          "tolerance, a length.\n\n"
          "The default is a few roundings. ToleranceNotReached if the ends lie farther apart, InvalidShape if the\n"
          "weights along them differ. Row S20.");
}

}  // namespace

void bind_patch_verbs(Class<NurbsPatch>& cls) {
  bind_curves_of(cls);
  bind_degrees(cls,
               "The same patch of a degree higher by times along an axis, 'u' or 'v'; every distinct knot has as many\n"
               "copies more. By blossoms, with convex weights. Row S20.",
               "Approximation by a patch of a degree lower by times along an axis, 'u' or 'v'; a plain axis keeps its\n"
               "ends, clamped.\n\n"
               "Every line of the net becomes the nearest in its control points, in the sum of squares. Exact where\n"
               "the degree was raised before. The error is as of largest_distance(). ToleranceNotReached with a\n"
               "tolerance that it exceeds. Row S20.");
  bind_removal(cls);
  bind_ends(cls);
  cls.def("moebius", [](const NurbsPatch& self, const py::object& axis, const py::object& rho) {
            const Axis direction = axis_of(axis);
            const double ratio = real(rho, "rho");
            return unlocked([&] { return splinecore::moebius(self, direction, ratio); });
          }, py::arg("axis"), py::arg("rho"),
          "The same surface under the parameter t = rho u / ((1 - u) + rho u) of an axis over its domain, which\n"
          "stays: knots and weights change. A periodic axis comes out plain. InvalidShape unless rho > 0.\n"
          "Lee and Lucian 1991; The NURBS Book, 6.4; row S12.");
  cls.def("largest_distance", [](const NurbsPatch& self, const NurbsPatch& other) {
            return unlocked([&] { return splinecore::largest_distance(self, other); });
          }, py::arg("other"),
          "The largest distance of points at equal parameters: an upper bound, at most 2 % above the truth.\n"
          "Where both run to infinity they are left out; where one does alone the distance is inf.\n"
          "InvalidShape if the domains differ.");
}

void bind_patch_verbs(Class<BezierPatch>& cls) {
  bind_curves_of(cls);
  bind_degrees(cls,
               "The same patch of a degree higher by times along an axis, 'u' or 'v'. The NURBS Book, eq. 5.36;\n"
               "row S19.",
               "Approximation by a patch of a degree lower by times along an axis, 'u' or 'v', with the same ends.\n\n"
               "Each step takes the nearest lines in the maximum norm (Lachance 1988). The error is an upper bound of\n"
               "the distance, at most 2 % above it. ToleranceNotReached with a tolerance that it exceeds. Row S19.");
}

void bind_patch_verbs(Class<HermitePatch>& cls) { bind_curves_of(cls); }

}  // namespace bindings
