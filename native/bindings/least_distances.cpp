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

void bind_result(py::module_& module) {
  Class<LeastDistance> cls(module, "LeastDistance", py::module_local());
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
      }, py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
  PatchClasses(module).def(
      "least_distance", [](const AnyPatch& self, const py::object& other, const py::object& tolerance, const py::object& cancel) {
        if (is_patch(other)) return between(patch_form(self), any_patch(other, "other"), tolerance, cancel);
        return turned(between(any_curve(other, "other"), patch_form(self), tolerance, cancel));
      }, py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
}

}  // namespace bindings
