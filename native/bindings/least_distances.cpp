#include "least_distances.hpp"

#include <algorithm>

#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "splinecore/meet/least_distance.hpp"

namespace bindings {

using splinecore::NurbsCurve;
using splinecore::NurbsPatch;

namespace {

/// What Python sees of where two shapes are nearest.
struct LeastDistance {
  double distance;
  py::tuple parameters;
  py::array_t<double> points;
};

py::object parameters_of(const NurbsCurve&, const std::array<double, 2>& at) { return py::float_(at[0]); }
py::object parameters_of(const NurbsPatch&, const std::array<double, 2>& at) { return py::make_tuple(at[0], at[1]); }

template <class A, class B>
LeastDistance between(const A& a, const B& b, const py::object& tolerance, const py::object& cancel) {
  const auto most = tolerance_of(tolerance);
  const auto found = unlocked([&] { return splinecore::least_distance(a, b, most); }, cancel);
  LeastDistance out{found.distance, py::make_tuple(parameters_of(a, found.a), parameters_of(b, found.b)),
                    py::array_t<double>(Shape{2, 3})};
  std::copy_n(&found.point_a.x, 3, out.points.mutable_data());
  std::copy_n(&found.point_b.x, 3, out.points.mutable_data() + 3);
  return out;
}

/// The same seen from the other shape.
LeastDistance turned(const LeastDistance& found) {
  LeastDistance out{found.distance, py::make_tuple(found.parameters[1], found.parameters[0]), py::array_t<double>(Shape{2, 3})};
  std::copy_n(found.points.data() + 3, 3, out.points.mutable_data());
  std::copy_n(found.points.data(), 3, out.points.mutable_data() + 3);
  return out;
}

bool is_patch(const py::object& value) {
  return py::isinstance<NurbsPatch>(value) || py::isinstance<splinecore::BezierPatch>(value) ||
         py::isinstance<splinecore::HermitePatch>(value);
}

constexpr const char* kText =
    "Where this shape and another, a curve or a patch of any kind, are nearest to each other, as a LeastDistance: nowhere\n"
    "are they nearer by more than the tolerance, a length, by default 2^-33 of how far control points of both reach from\n"
    "the middle of them all.\n\n"
    "Places are feet of each other, ends and borders included; pairs of Bernstein pieces on two trees of boxes are then\n"
    "halved until hulls show that nothing is nearer (Johnson and Cohen 1998). Of places at one distance it is any. Lecture\n"
    "row S18. cancel is a callable that ends a long call by returning True. InvalidShape if the tolerance is below 0, or\n"
    "after 2^22 pairs of parts, as where shapes that are bent are at one distance all along: say a larger tolerance.";

void bind_result(py::module_& module) {
  Class<LeastDistance> cls(module, "LeastDistance", py::module_local(),
                           "Where two shapes are nearest to each other.\n\n"
                           "distance is a length; parameters is a pair: of a curve its parameter, of a patch (u, v); points is\n"
                           "(2, 3), one of each shape.");
  seal(cls);
  pickle_members(cls, &LeastDistance::distance, &LeastDistance::parameters, &LeastDistance::points);
  cls.def_readonly("distance", &LeastDistance::distance);
  cls.def_readonly("parameters", &LeastDistance::parameters);
  cls.def_readonly("points", &LeastDistance::points);
  cls.def("__repr__", [](const LeastDistance& self) {
    return "LeastDistance(distance=" + splinecore::text_of(self.distance) + ")";
  });
}

}  // namespace

void bind_least_distances(py::module_& module) {
  bind_result(module);
  CurveClasses(module).def(
      "least_distance", [](const AnyCurve& self, const py::object& other, const py::object& tolerance, const py::object& cancel) {
        if (is_patch(other)) return between(form(self), any_patch(other, "other"), tolerance, cancel);
        return between(form(self), any_curve(other, "other"), tolerance, cancel);
      }, py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(), kText);
  PatchClasses(module).def(
      "least_distance", [](const AnyPatch& self, const py::object& other, const py::object& tolerance, const py::object& cancel) {
        if (is_patch(other)) return between(patch_form(self), any_patch(other, "other"), tolerance, cancel);
        return turned(between(any_curve(other, "other"), patch_form(self), tolerance, cancel));
      }, py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(), kText);
}

}  // namespace bindings
