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

const char* const kCurve =
    "The curve with its control points moved as little as can be so that its point at u moves by `by` (3,).\n\n"
    "To bring it to a place, give place - evaluate(u). tangent_by is added to the derivative there: zero keeps it, None\n"
    "lets it go; second_by is the same of the second derivative, and needs a tangent_by. Least is the sum of squares of\n"
    "the points' motions, each divided by its factor (n,), 0 for a point that stays. The larger locality is, the fewer\n"
    "follow: factors are multiplied by what a point counts at u, to this power. Weights, knots and points at infinity\n"
    "stay, ends that meet go together. InvalidShape where nothing that the point depends on may move, or too little to\n"
    "choose the derivatives. The NURBS Book, 11.5.";
const char* const kHermiteCurve =
    "The chain with points and tangents moved as little as can be so that its point at u moves by `by` (3,).\n\n"
    "As NurbsCurve.dragged(), with factors (3, n) of points, incoming and outgoing tangents. The motion of a tangent is\n"
    "measured at the end of its handle, a third of the span away. Tangents that are equal at a point remain so.";
/// What is added to a derivative, or None.
std::optional<glm::dvec3> gain_of(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  return vector_of(value, name);
}

const char* const kPatch =
    "The patch with its control points moved as little as can be so that its point at (u, v) moves by `by` (3,).\n\n"
    "As NurbsCurve.dragged(), with factors (nu, nv); tangent_u_by and tangent_v_by are added to the derivatives along u\n"
    "and v there: zero keeps one, None lets it go. Points that lie in one place go together: seams and poles stay.";
const char* const kHermitePatch =
    "The patch with points, tangents and twists moved as little as can be so that its point at (u, v) moves by `by`.\n\n"
    "As NurbsPatch.dragged(), with factors (4, nu, nv) of points, tangents along u, along v, and twists. Tangents are\n"
    "measured at a third of the span, twists at a ninth.";

template <class Curve>
void bind_curve(Class<Curve> cls, const char* text) {
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
          py::arg("locality") = 0.0, text);
}

template <class Patch>
void bind_patch(Class<Patch> cls, const char* text) {
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
          py::arg("locality") = 0.0, text);
}

void bind_set(Class<PatchSet> cls) {
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
          py::arg("factors") = py::none(), py::arg("locality") = 0.0,
          "The set with its pool moved as little as can be so that the point of a patch at (u, v) moves by `by` (3,).\n\n"
          "As NurbsPatch.dragged(), with factors (n,) of the pool. What patches share moves once, and the neighbors go\n"
          "along, as do points that lie in one place. A tangent or twist that serves several corners stays.");
}

}  // namespace

void bind_drags(py::module_& module) {
  bind_curve(class_of<NurbsCurve>(module, "NurbsCurve"), kCurve);
  bind_curve(class_of<BezierCurve>(module, "BezierCurve"), kCurve);
  bind_curve(class_of<HermiteCurve>(module, "HermiteCurve"), kHermiteCurve);
  bind_patch(class_of<NurbsPatch>(module, "NurbsPatch"), kPatch);
  bind_patch(class_of<BezierPatch>(module, "BezierPatch"), kPatch);
  bind_patch(class_of<HermitePatch>(module, "HermitePatch"), kHermitePatch);
  bind_set(class_of<PatchSet>(module, "PatchSet"));
}

}  // namespace bindings
