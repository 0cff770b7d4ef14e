#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "classes.hpp"
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

/// A curve of any kind, as the methods that all kinds have take it.
struct AnyCurve {
  const splinecore::NurbsCurve* nurbs = nullptr;
};
inline const splinecore::NurbsCurve& form(const AnyCurve& curve) { return *curve.nurbs; }

/// A patch of any kind.
struct AnyPatch {
  const splinecore::NurbsPatch* nurbs = nullptr;
};
inline const splinecore::NurbsPatch& patch_form(const AnyPatch& patch) { return *patch.nurbs; }

/// Classes that were bound before and are given the same methods.
class Classes {
 public:
  template <class Function, class... Extra>
  const Classes& def(const char* name, Function function, const Extra&... extra) const {
    namespace py = pybind11;
    for (const py::object& cls : classes_) {
      cls.attr(name) = py::cpp_function(plain_function(function), py::name(name), py::is_method(cls), plain(extra)...);
    }
    return *this;
  }

  template <class Getter>
  const Classes& def_property(const char* name, Getter getter, const char* text = nullptr) const {
    namespace py = pybind11;
    const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
    for (const py::object& cls : classes_) {
      cls.attr(name) = property(py::cpp_function(plain_function(getter), py::is_method(cls)), py::none(), py::none(), text);
    }
    return *this;
  }

 protected:
  Classes(const pybind11::module_& module, std::initializer_list<const char*> names) {
    for (const char* name : names) classes_.emplace_back(module.attr(name));
  }

 private:
  std::vector<pybind11::object> classes_;
};

struct CurveClasses : Classes {
  explicit CurveClasses(const pybind11::module_& module)
      : Classes(module, {"NurbsCurve", "BezierCurve", "HermiteCurve", "PowerCurve"}) {}
};

struct PatchClasses : Classes {
  explicit PatchClasses(const pybind11::module_& module) : Classes(module, {"NurbsPatch", "BezierPatch", "HermitePatch"}) {}
};

}  // namespace bindings

namespace pybind11::detail {

template <>
struct type_caster<bindings::AnyCurve> {
  PYBIND11_TYPE_CASTER(bindings::AnyCurve, const_name("Curve"));

  bool load(handle object, bool) {
    using namespace splinecore;
    return is<NurbsCurve>(object) || is<BezierCurve>(object) || is<HermiteCurve>(object) || is<PowerCurve>(object);
  }

 private:
  template <class Kind>
  bool is(handle object) {
    make_caster<Kind> kind;
    if (!type::handle_of(object).is(type::handle_of<Kind>()) || !kind.load(object, false)) return false;
    value.nurbs = &bindings::form(cast_op<const Kind&>(kind));
    return true;
  }
};

template <>
struct type_caster<bindings::AnyPatch> {
  PYBIND11_TYPE_CASTER(bindings::AnyPatch, const_name("Patch"));

  bool load(handle object, bool) {
    using namespace splinecore;
    return is<NurbsPatch>(object) || is<BezierPatch>(object) || is<HermitePatch>(object);
  }

 private:
  template <class Kind>
  bool is(handle object) {
    make_caster<Kind> kind;
    if (!type::handle_of(object).is(type::handle_of<Kind>()) || !kind.load(object, false)) return false;
    value.nurbs = &bindings::patch_form(cast_op<const Kind&>(kind));
    return true;
  }
};

}  // namespace pybind11::detail
