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
#include "splinecore/region/region.hpp"
#include "values.hpp"
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
          }, py::arg("matrix"));
  cls.def("translated", [](const Shape& self, const py::object& by) {
            return splinecore::transformed(self, splinecore::translation(vector_of(by, "by")));
          }, py::arg("by"));
  cls.def("rotated", [](const Shape& self, const py::object& angle, const py::object& axis, const py::object& about) {
            return splinecore::transformed(
                self, splinecore::rotation(real(angle, "angle"), vector_of(axis, "axis"), vector_of(about, "about")));
          }, py::arg("angle"), py::arg("axis") = py::make_tuple(0, 0, 1), py::arg("about") = py::make_tuple(0, 0, 0));
  cls.def("scaled", [](const Shape& self, const py::object& factor, const py::object& about) {
            const bool is_one = py::isinstance<py::float_>(factor) || py::isinstance<py::int_>(factor);
            const glm::dvec3 factors = is_one ? glm::dvec3(real(factor, "factor")) : vector_of(factor, "factor");
            return splinecore::transformed(self, splinecore::scaling(factors, vector_of(about, "about")));
          }, py::arg("factor"), py::arg("about") = py::make_tuple(0, 0, 0));
}

Smoothness curve_smoothness_of(const py::object& value) {
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
            const Smoothness smoothness = curve_smoothness_of(continuity);
            return wrap(unlocked([&] { return splinecore::joined(form(self), more, smoothness); }));
          }, py::arg("other"), py::arg("continuity") = "C0");
  cls.def("continuity_to", [](const AnyCurve& self, const py::object& other, const py::object& tolerance) {
            const splinecore::NurbsCurve& more = any_curve(other, "other");
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::continuity_between(form(self), more, most); });
          }, py::arg("other"), py::arg("tolerance") = splinecore::kContinuityTolerance);
  cls.def_property("is_closed", [](const AnyCurve& self) {
    return unlocked([&] { return splinecore::is_closed(form(self)); });
  });
}

void bind_patch_closedness(const PatchClasses& cls) {
  cls.def_property("is_closed", [](const AnyPatch& self) {
    return unlocked([&] {
      const splinecore::AnyPatch patch(patch_form(self));
      return splinecore::is_closed(PatchSet::of(std::span(&patch, 1), true));
    });
  });
}

/// The patches of one set after those of another.
PatchSet joined_sets(const PatchSet& self, const py::object& other, const py::object& merge) {
  const bool is_merged = boolean(merge, "merge");
  std::vector<splinecore::AnyPatch> all;
  for (std::size_t i = 0; i < self.patches().size(); ++i) all.push_back(self.patch(static_cast<int>(i)));
  std::optional<splinecore::AnyPatch> one;
  if (py::isinstance<PatchSet>(other)) {
    const auto& more = other.cast<const PatchSet&>();
    for (std::size_t i = 0; i < more.patches().size(); ++i) all.push_back(more.patch(static_cast<int>(i)));
  } else if (unwrap(other, one)) {
    all.push_back(*one);
  } else {
    throw py::type_error("other must be a patch or a PatchSet, not " + type_name(other));
  }
  return unlocked([&] { return PatchSet::of(all, is_merged); });
}

void bind_set(Class<PatchSet> cls) {
  cls.def("join", &joined_sets, py::arg("other"), py::arg("merge") = true);
  cls.def_property_readonly("is_closed", [](const PatchSet& self) {
    return unlocked([&] { return splinecore::is_closed(self); });
  });
  cls.def("oriented", [](const PatchSet& self, const py::object& cancel) {
            return unlocked([&] { return splinecore::oriented(self); }, cancel);
          }, py::kw_only(), py::arg("cancel") = py::none());
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
  bind_motions(class_of<splinecore::Region>(module, "Region"));
  bind_joins(CurveClasses(module));
  bind_patch_closedness(PatchClasses(module));
  bind_set(class_of<PatchSet>(module, "PatchSet"));
  bind_least_distances(module);
}

}  // namespace bindings
