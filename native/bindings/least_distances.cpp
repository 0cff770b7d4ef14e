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
using splinecore::PatchSet;

namespace {

/// What Python sees of where two shapes are nearest.
struct LeastDistance {
  double distance;
  py::tuple parameters;
  py::tuple patches;
  py::array_t<double> points;
};

py::object parameters_of(const NurbsCurve&, const std::array<double, 2>& at) { return py::float_(at[0]); }
py::object parameters_of(const auto&, const std::array<double, 2>& at) { return py::make_tuple(at[0], at[1]); }

py::object patch_in(const auto&, std::size_t) { return py::none(); }
py::object patch_in(const PatchSet&, std::size_t patch) { return py::int_(patch); }

template <class A, class B>
LeastDistance between(const A& a, const B& b, const py::object& tolerance, const py::object& cancel) {
  const auto most = tolerance_of(tolerance);
  const auto found = unlocked([&] { return splinecore::least_distance(a, b, most); }, cancel);
  LeastDistance out{found.distance, py::make_tuple(parameters_of(a, found.a), parameters_of(b, found.b)),
                    py::make_tuple(patch_in(a, found.patch_a), patch_in(b, found.patch_b)),
                    py::array_t<double>(Shape{2, 3})};
  std::copy_n(&found.point_a.x, 3, out.points.mutable_data());
  std::copy_n(&found.point_b.x, 3, out.points.mutable_data() + 3);
  return out;
}

/// The same seen from the other shape.
LeastDistance turned(const LeastDistance& found) {
  LeastDistance out{found.distance, py::make_tuple(found.parameters[1], found.parameters[0]),
                    py::make_tuple(found.patches[1], found.patches[0]), py::array_t<double>(Shape{2, 3})};
  std::copy_n(found.points.data() + 3, 3, out.points.mutable_data());
  std::copy_n(found.points.data(), 3, out.points.mutable_data() + 3);
  return out;
}

bool is_patch(const py::object& value) {
  return py::isinstance<NurbsPatch>(value) || py::isinstance<splinecore::BezierPatch>(value) ||
         py::isinstance<splinecore::HermitePatch>(value);
}

const PatchSet* set_in(const py::object& value) {
  return py::isinstance<PatchSet>(value) ? &value.cast<const PatchSet&>() : nullptr;
}

void bind_least_distance(py::module_& module) {
  Class<LeastDistance> cls(module, "LeastDistance", py::module_local());
  seal(cls);
  pickle_members(cls, &LeastDistance::distance, &LeastDistance::parameters, &LeastDistance::patches, &LeastDistance::points);
  cls.def_readonly("distance", &LeastDistance::distance);
  cls.def_readonly("parameters", &LeastDistance::parameters);
  cls.def_readonly("patches", &LeastDistance::patches);
  cls.def_readonly("points", &LeastDistance::points);
  cls.def("__repr__", [](const LeastDistance& self) {
    return "LeastDistance(distance=" + splinecore::text_of(self.distance) + ")";
  });
}

}  // namespace

void bind_least_distances(py::module_& module) {
  bind_least_distance(module);
  const auto arguments = [](auto classes, auto function) {
    classes.def("least_distance", function, py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(),
                py::arg("cancel") = py::none());
  };
  arguments(CurveClasses(module), [](const AnyCurve& self, const py::object& other, const py::object& tolerance, const py::object& cancel) {
    if (const PatchSet* set = set_in(other)) return between(form(self), *set, tolerance, cancel);
    if (is_patch(other)) return between(form(self), any_patch(other, "other"), tolerance, cancel);
    return between(form(self), any_curve(other, "other"), tolerance, cancel);
  });
  arguments(PatchClasses(module), [](const AnyPatch& self, const py::object& other, const py::object& tolerance, const py::object& cancel) {
    if (const PatchSet* set = set_in(other)) return between(patch_form(self), *set, tolerance, cancel);
    if (is_patch(other)) return between(patch_form(self), any_patch(other, "other"), tolerance, cancel);
    return turned(between(any_curve(other, "other"), patch_form(self), tolerance, cancel));
  });
  arguments(class_of<PatchSet>(module, "PatchSet"), [](const PatchSet& self, const py::object& other, const py::object& tolerance,
                                                       const py::object& cancel) {
    if (const PatchSet* set = set_in(other)) return between(self, *set, tolerance, cancel);
    if (is_patch(other)) return turned(between(any_patch(other, "other"), self, tolerance, cancel));
    return turned(between(any_curve(other, "other"), self, tolerance, cancel));
  });
}

}  // namespace bindings
