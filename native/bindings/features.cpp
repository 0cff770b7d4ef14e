#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/measure/bounding_box.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/measure/features.hpp"

namespace bindings {

using splinecore::Box;
using splinecore::NurbsCurve;
using splinecore::NurbsPatch;
using splinecore::PatchSet;

namespace {

/// The argument, or the normal of the curve's plane for None.
glm::dvec3 normal_of(const NurbsCurve& curve, const py::object& normal, const char* name) {
  if (!normal.is_none()) return vector_of(normal, name);
  return unlocked([&] { return splinecore::plane_normal(curve); });
}

py::array_t<double> signed_curvature(const NurbsCurve& curve, const py::object& u, const py::object& normal,
                                     const py::object& side) {
  const Doubles at = real_array(u, "u");
  const splinecore::Side from = side_of(side, "side");
  require_inside(curve.knot_vector(), at, from, "u");
  const glm::dvec3 across = normal_of(curve, normal, "normal");
  py::array_t<double> out(Shape(at.shape(), at.shape() + at.ndim()));
  const auto count = static_cast<std::size_t>(at.size());
  double* const numbers = out.mutable_data();
  unlocked([&] { splinecore::signed_curvature(curve, {at.data(), count}, across, {numbers, count}, from); });
  return out;
}

py::array_t<double> inflections(const NurbsCurve& curve, const py::object& direction) {
  const glm::dvec3 view = normal_of(curve, direction, "direction");
  const auto found = unlocked([&] { return splinecore::inflections(curve, view); });
  return new_numbers(std::span(found));
}

py::array_t<double> extrema(const NurbsCurve& curve, const py::object& direction) {
  const glm::dvec3 way = vector_of(direction, "direction");
  const auto found = unlocked([&] { return splinecore::extrema(curve, way); });
  return new_numbers(std::span(found));
}

py::array_t<double> rows_of(const Box& box) {
  py::array_t<double> out(Shape{2, 3});
  for (int axis = 0; axis < 3; ++axis) {
    out.mutable_at(0, axis) = box.low[axis];
    out.mutable_at(1, axis) = box.high[axis];
  }
  return out;
}

void bind_feature_methods(const CurveClasses& cls) {
  cls.def("signed_curvature", [](const AnyCurve& self, const py::object& u, const py::object& normal,
                                 const py::object& side) { return signed_curvature(form(self), u, normal, side); },
          py::arg("u"), py::arg("normal") = py::none(), py::kw_only(), py::arg("side") = "right");
  cls.def("inflections", [](const AnyCurve& self, const py::object& direction) {
            return inflections(form(self), direction);
          }, py::arg("direction") = py::none());
  cls.def("extrema", [](const AnyCurve& self, const py::object& direction) { return extrema(form(self), direction); },
          py::arg("direction"));
  cls.def("bounding_box", [](const AnyCurve& self) {
            return rows_of(unlocked([&] { return splinecore::bounding_box(form(self)); }));
          });
}

const NurbsPatch& form_of(const AnyPatch& patch) { return patch_form(patch); }
const PatchSet& form_of(const PatchSet& set) { return set; }

template <class Shaped, class Owner>
void bind_box(Owner cls) {
  cls.def("bounding_box", [](const Shaped& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return rows_of(unlocked([&] { return splinecore::bounding_box(form_of(self), most); }, cancel));
          }, py::kw_only(), py::arg("tolerance") = splinecore::kBoxTolerance, py::arg("cancel") = py::none());
}

}  // namespace

void bind_features(py::module_& module) {
  bind_feature_methods(CurveClasses(module));
  bind_box<AnyPatch>(PatchClasses(module));
  bind_box<PatchSet>(class_of<PatchSet>(module, "PatchSet"));
}

}  // namespace bindings
