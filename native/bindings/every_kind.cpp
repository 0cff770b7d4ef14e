#include "every_kind.hpp"

#include "approximation.hpp"
#include "arguments.hpp"
#include "least_distances.hpp"
#include "long_calls.hpp"
#include "splinecore/base/motions.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/curve/transform.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/continuity.hpp"
#include "splinecore/measure/oriented.hpp"
#include "splinecore/patch/transform.hpp"
#include "verbs.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::PatchSet;
using splinecore::Smoothness;

namespace {

/// Where a shape is brought: methods of each kind, which give one of that kind.
template <class Shape>
void bind_motions(Class<Shape> cls) {
  cls.def("transformed", [](const Shape& self, const py::object& matrix) {
            return splinecore::transformed(self, matrix_of(matrix));
          }, py::arg("matrix"),
          "The shape under a linear (3, 3), affine (3, 4) or projective (4, 4) map of columns, of its own kind.\n\n"
          "Under a projective one the weights change; a point that goes to infinity gets weight 0. The image of a Hermite\n"
          "curve or patch under one that is not affine is none, which InvalidShape says. Rows S9, S15, S20.");
  cls.def("translated", [](const Shape& self, const py::object& by) {
            return splinecore::transformed(self, splinecore::translation(vector_of(by, "by")));
          }, py::arg("by"),
          "The shape moved by a vector (2 or 3,).");
  cls.def("rotated", [](const Shape& self, const py::object& angle, const py::object& axis, const py::object& about) {
            return splinecore::transformed(
                self, splinecore::rotation(real(angle, "angle"), vector_of(axis, "axis"), vector_of(about, "about")));
          }, py::arg("angle"), py::arg("axis") = py::make_tuple(0, 0, 1), py::arg("about") = py::make_tuple(0, 0, 0),
          "The shape turned by an angle in radians about an axis (3,) through a point (2 or 3,), counterclockwise seen from\n"
          "the tip of the axis. InvalidShape if that is zero.");
  cls.def("scaled", [](const Shape& self, const py::object& factor, const py::object& about) {
            const bool is_one = py::isinstance<py::float_>(factor) || py::isinstance<py::int_>(factor);
            const glm::dvec3 factors = is_one ? glm::dvec3(real(factor, "factor")) : vector_of(factor, "factor");
            return splinecore::transformed(self, splinecore::scaling(factors, vector_of(about, "about")));
          }, py::arg("factor"), py::arg("about") = py::make_tuple(0, 0, 0),
          "The shape scaled about a point (2 or 3,) by a factor, or by one (3,) along each axis of coordinates: -1 mirrors.\n"
          "InvalidShape if one is zero.");
}

Smoothness smoothness_of(const py::object& value) {
  const std::pair<const char*, Smoothness> known[] = {
      {"C0", Smoothness::c0}, {"G1", Smoothness::g1}, {"C1", Smoothness::c1}, {"C2", Smoothness::c2}};
  for (const auto& [name, smoothness] : known) {
    if (py::isinstance<py::str>(value) && value.cast<std::string>() == name) return smoothness;
  }
  throw InvalidShape("continuity = " + std::string(py::repr(value)) + " is not 'C0', 'G1', 'C1' or 'C2'");
}

void bind_joins(const CurveClasses& cls) {
  cls.def("join", [](const AnyCurve& self, const py::object& other, const py::object& continuity) {
            const splinecore::NurbsCurve& more = any_curve(other, "other");
            const Smoothness smoothness = smoothness_of(continuity);
            return wrap(unlocked([&] { return splinecore::joined(form(self), more, smoothness); }));
          }, py::arg("other"), py::arg("continuity") = "C0",
          "Approximation by a NurbsCurve: this curve and then the other, of any kinds, 'C0', 'G1', 'C1' or 'C2' at the joint.\n\n"
          "Points next to the joint move as little as that asks; the error is how far the curves moved. For C1 and\n"
          "C2 the other's domain is scaled first. InvalidShape if a curve is periodic or an end lies at infinity.\n"
          "Row S7.");
  cls.def("continuity_to", [](const AnyCurve& self, const py::object& other, const py::object& tolerance) {
            const splinecore::NurbsCurve& more = any_curve(other, "other");
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::continuity_between(form(self), more, most); });
          }, py::arg("other"), py::arg("tolerance") = splinecore::kContinuityTolerance,
          "The Continuity between the end of this curve and the start of the other, of any kinds.\nRow S16.");
  cls.def_property("is_closed", [](const AnyCurve& self) {
    return unlocked([&] { return splinecore::is_closed(form(self)); });
  }, "Whether the curve is in one piece and ends where it begins, in every bit.");
}

void bind_set(Class<PatchSet> cls) {
  cls.def_property_readonly("is_closed", [](const PatchSet& self) {
    return unlocked([&] { return splinecore::is_closed(self); });
  }, "Whether no side is free: each is a pole, lies across a closed direction, or lies on another one.");
  cls.def("oriented", [](const PatchSet& self, const py::object& cancel) {
            return unlocked([&] { return splinecore::oriented(self); }, cancel);
          }, py::kw_only(), py::arg("cancel") = py::none(),
          "The patches with normals that go on from each to its neighbors, and outwards from what is closed.\n\n"
          "Those that point the other way are seen from the other side, u and v exchanged, on the same pool of points; of\n"
          "patches that hang together but are open the first one stays. InvalidShape names an edge where more than two sides\n"
          "meet, or from which normals come back the other way, as on a band with half a turn; and as volume(). Row S20.");
}

}  // namespace

void bind_every_kind(py::module_& module) {
  bind_motions(class_of<splinecore::NurbsCurve>(module, "NurbsCurve"));
  bind_motions(class_of<splinecore::BezierCurve>(module, "BezierCurve"));
  bind_motions(class_of<splinecore::HermiteCurve>(module, "HermiteCurve"));
  bind_motions(class_of<splinecore::PowerCurve>(module, "PowerCurve"));
  bind_motions(class_of<splinecore::NurbsPatch>(module, "NurbsPatch"));
  bind_motions(class_of<splinecore::BezierPatch>(module, "BezierPatch"));
  bind_motions(class_of<splinecore::HermitePatch>(module, "HermitePatch"));
  bind_motions(class_of<PatchSet>(module, "PatchSet"));
  bind_joins(CurveClasses(module));
  bind_set(class_of<PatchSet>(module, "PatchSet"));
  bind_least_distances(module);
}

}  // namespace bindings
