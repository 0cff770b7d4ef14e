#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/build/drag.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::BezierCurve;
using splinecore::BezierPatch;
using splinecore::Drag;
using splinecore::Following;
using splinecore::HermiteCurve;
using splinecore::HermitePatch;
using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::NurbsPatch;
using splinecore::PatchDrag;
using splinecore::PatchSet;

namespace {

Following following_of(const py::object& factors, const py::object& locality, const Shape& shape) {
  Following following;
  following.locality = real(locality, "locality");
  if (factors.is_none()) return following;
  const Doubles given = real_array(factors, "factors");
  require_net(given, "factors", shape);
  if (given.ndim() != static_cast<py::ssize_t>(shape.size())) {
    throw InvalidShape("factors has shape " + shape_text(given) + ": one number for each point is expected");
  }
  following.factors.assign(given.data(), given.data() + given.size());
  return following;
}

Shape shape_of(const HermiteCurve& curve) { return {3, static_cast<py::ssize_t>(curve.points().size())}; }
Shape shape_of(const HermitePatch& patch) { return {4, patch.count(Axis::u), patch.count(Axis::v)}; }
template <class Curve>
  requires requires(const Curve& curve) { curve.degree(); }
Shape shape_of(const Curve& curve) {
  return {static_cast<py::ssize_t>(curve.points().size())};
}
template <class Patch>
Shape shape_of(const Patch& patch) {
  return {patch.count(Axis::u), patch.count(Axis::v)};
}

/// What is added to a derivative, or None.
std::optional<glm::dvec3> gain_of(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  return vector_of(value, name);
}

template <class Curve>
void bind_curve(Class<Curve> cls) {
  cls.def("dragged", [](const Curve& self, const py::object& u, const py::object& by, const py::object& tangent_by,
                        const py::object& second_by, const py::object& factors, const py::object& locality) {
            const double at = real(u, "u");
            Drag drag{vector_of(by, "by"), {}};
            if (!tangent_by.is_none()) drag.tangent_by = vector_of(tangent_by, "tangent_by");
            if (!second_by.is_none()) drag.second_by = vector_of(second_by, "second_by");
            const Following following = following_of(factors, locality, shape_of(self));
            return unlocked([&] { return splinecore::dragged(self, at, drag, following); });
          }, py::arg("u"), py::arg("by"), py::arg("tangent_by") = py::none(),
          py::arg("second_by") = py::none(), py::kw_only(), py::arg("factors") = py::none(),
          py::arg("locality") = 0.0);
}

template <class Patch>
void bind_patch(Class<Patch> cls) {
  cls.def("dragged", [](const Patch& self, const py::object& u, const py::object& v, const py::object& by,
                        const py::object& tangent_u_by, const py::object& tangent_v_by, const py::object& factors,
                        const py::object& locality) {
            const double at_u = real(u, "u");
            const double at_v = real(v, "v");
            const PatchDrag drag{vector_of(by, "by"), gain_of(tangent_u_by, "tangent_u_by"),
                                 gain_of(tangent_v_by, "tangent_v_by")};
            const Following following = following_of(factors, locality, shape_of(self));
            return unlocked([&] { return splinecore::dragged(self, at_u, at_v, drag, following); });
          }, py::arg("u"), py::arg("v"), py::arg("by"), py::arg("tangent_u_by") = py::none(),
          py::arg("tangent_v_by") = py::none(), py::kw_only(), py::arg("factors") = py::none(),
          py::arg("locality") = 0.0);
}

void bind_set_drags(Class<PatchSet> cls) {
  cls.def("dragged", [](const PatchSet& self, const py::object& patch, const py::object& u, const py::object& v,
                        const py::object& by, const py::object& tangent_u_by, const py::object& tangent_v_by,
                        const py::object& factors, const py::object& locality) {
            const int number = integer(patch, "patch");
            if (number < 0) throw InvalidShape("patch = " + std::to_string(number) + " is below 0");
            const double at_u = real(u, "u");
            const double at_v = real(v, "v");
            const PatchDrag drag{vector_of(by, "by"), gain_of(tangent_u_by, "tangent_u_by"),
                                 gain_of(tangent_v_by, "tangent_v_by")};
            const Following following =
                following_of(factors, locality, {static_cast<py::ssize_t>(self.points().size())});
            return unlocked([&] {
              return splinecore::dragged(self, static_cast<std::size_t>(number), at_u, at_v, drag, following);
            });
          }, py::arg("patch"), py::arg("u"), py::arg("v"), py::arg("by"),
          py::arg("tangent_u_by") = py::none(), py::arg("tangent_v_by") = py::none(), py::kw_only(),
          py::arg("factors") = py::none(), py::arg("locality") = 0.0);
}

}  // namespace

void bind_drags(py::module_& module) {
  bind_curve(class_of<NurbsCurve>(module, "NurbsCurve"));
  bind_curve(class_of<BezierCurve>(module, "BezierCurve"));
  bind_curve(class_of<HermiteCurve>(module, "HermiteCurve"));
  bind_patch(class_of<NurbsPatch>(module, "NurbsPatch"));
  bind_patch(class_of<BezierPatch>(module, "BezierPatch"));
  bind_patch(class_of<HermitePatch>(module, "HermitePatch"));
  bind_set_drags(class_of<PatchSet>(module, "PatchSet"));
}

}  // namespace bindings
