#pragma once

#include <string>
#include <vector>

#include "arrays.hpp"
#include "class_of.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/curve/power_curve.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/hermite_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace bindings {

/// The NURBS form of any kind of curve.
inline const splinecore::NurbsCurve& form(const splinecore::NurbsCurve& curve) { return curve; }
template <class Curve>
const splinecore::NurbsCurve& form(const Curve& curve) {
  return curve.nurbs();
}

/// The NURBS form of a curve of any kind. @throws InvalidShape if it is none
inline const splinecore::NurbsCurve& any_curve(const pybind11::object& value, const char* name) {
  namespace py = pybind11;
  if (py::isinstance<splinecore::NurbsCurve>(value)) return value.cast<const splinecore::NurbsCurve&>();
  if (py::isinstance<splinecore::BezierCurve>(value)) return form(value.cast<const splinecore::BezierCurve&>());
  if (py::isinstance<splinecore::HermiteCurve>(value)) return form(value.cast<const splinecore::HermiteCurve&>());
  if (py::isinstance<splinecore::PowerCurve>(value)) return form(value.cast<const splinecore::PowerCurve&>());
  throw splinecore::InvalidShape(std::string(name) + " is " + std::string(py::str(py::type::of(value).attr("__name__"))) +
                                 ", a curve is expected");
}

/// The NURBS forms of curves of any kinds. @throws py::type_error if it is no list, InvalidShape if one is no curve
inline std::vector<splinecore::NurbsCurve> any_curves(const pybind11::object& value, const char* name) {
  namespace py = pybind11;
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (!is_list) throw py::type_error(std::string(name) + " must be a list of curves, not " + type_name(value));
  std::vector<splinecore::NurbsCurve> curves;
  for (const py::handle& item : value) {
    const std::string place = name + splinecore::index_text(curves.size());
    curves.push_back(any_curve(py::reinterpret_borrow<py::object>(item), place.c_str()));
  }
  return curves;
}

/// The NURBS form of any kind of patch.
inline const splinecore::NurbsPatch& patch_form(const splinecore::NurbsPatch& patch) { return patch; }
template <class Patch>
const splinecore::NurbsPatch& patch_form(const Patch& patch) {
  return patch.nurbs();
}

/// The NURBS form of a patch of any kind. @throws InvalidShape if it is none
inline const splinecore::NurbsPatch& any_patch(const pybind11::object& value, const char* name) {
  namespace py = pybind11;
  if (py::isinstance<splinecore::NurbsPatch>(value)) return value.cast<const splinecore::NurbsPatch&>();
  if (py::isinstance<splinecore::BezierPatch>(value)) return patch_form(value.cast<const splinecore::BezierPatch&>());
  if (py::isinstance<splinecore::HermitePatch>(value)) return patch_form(value.cast<const splinecore::HermitePatch&>());
  throw splinecore::InvalidShape(std::string(name) + " is " + std::string(py::str(py::type::of(value).attr("__name__"))) +
                                 ", a patch is expected");
}

/// Gives the class of every kind of curve, bound before, more methods.
template <class Bind>
void for_curves(const pybind11::module_& module, Bind bind) {
  bind(class_of<splinecore::NurbsCurve>(module, "NurbsCurve"));
  bind(class_of<splinecore::BezierCurve>(module, "BezierCurve"));
  bind(class_of<splinecore::HermiteCurve>(module, "HermiteCurve"));
  bind(class_of<splinecore::PowerCurve>(module, "PowerCurve"));
}

/// The same of patches.
template <class Bind>
void for_patches(const pybind11::module_& module, Bind bind) {
  bind(class_of<splinecore::NurbsPatch>(module, "NurbsPatch"));
  bind(class_of<splinecore::BezierPatch>(module, "BezierPatch"));
  bind(class_of<splinecore::HermitePatch>(module, "HermitePatch"));
}

}  // namespace bindings
