#include "splinecore/meet/sections.hpp"

#include <algorithm>

#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::NurbsCurve;
using splinecore::NurbsPatch;
using splinecore::SectionKind;
using splinecore::Sections;

template <>
struct StateOf<SectionKind> {
  static py::object from(SectionKind kind) { return py::int_(static_cast<int>(kind)); }
  static SectionKind to(const py::object& state) {
    const int kind = integer(state, "the state");
    if (kind >= 0 && kind <= static_cast<int>(SectionKind::border)) return static_cast<SectionKind>(kind);
    throw splinecore::InvalidShape("the state has no kind of section");
  }
};

using splinecore::SectionCurve;
using splinecore::SectionPoint;

template <>
struct StateOf<SectionCurve> : StateOfMembers<&SectionCurve::curve, &SectionCurve::on_a, &SectionCurve::on_b,
                                              &SectionCurve::is_closed, &SectionCurve::kind> {};
template <>
struct StateOf<SectionPoint> : StateOfMembers<&SectionPoint::a, &SectionPoint::b, &SectionPoint::point> {};

namespace {

py::tuple curves_of(const Sections& found, NurbsCurve splinecore::SectionCurve::*which) {
  py::tuple out(found.curves.size());
  for (std::size_t i = 0; i < found.curves.size(); ++i) out[i] = py::cast(found.curves[i].*which);
  return out;
}

py::array_t<bool> closed_of(const Sections& found) {
  auto out = new_numbers<bool>(found.curves.size());
  std::ranges::transform(found.curves, out.mutable_data(), &splinecore::SectionCurve::is_closed);
  return out;
}

py::tuple kinds_of(const Sections& found) {
  py::tuple out(found.curves.size());
  for (std::size_t i = 0; i < found.curves.size(); ++i) {
    const SectionKind kind = found.curves[i].kind;
    out[i] = py::str(kind == SectionKind::crossing ? "crossing" : kind == SectionKind::touching ? "touching" : "border");
  }
  return out;
}

py::array_t<double> points_of(const Sections& found) {
  py::array_t<double> out({static_cast<py::ssize_t>(found.points.size()), py::ssize_t{3}});
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) out.mutable_at(static_cast<py::ssize_t>(i), k) = found.points[i].point[k];
  }
  return out;
}

py::array_t<double> parameters_of(const Sections& found) {
  py::array_t<double> out({static_cast<py::ssize_t>(found.points.size()), py::ssize_t{2}, py::ssize_t{2}});
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      out.mutable_at(static_cast<py::ssize_t>(i), 0, static_cast<py::ssize_t>(k)) = found.points[i].a[k];
      out.mutable_at(static_cast<py::ssize_t>(i), 1, static_cast<py::ssize_t>(k)) = found.points[i].b[k];
    }
  }
  return out;
}

void bind_section_methods(const PatchClasses& cls) {
  cls.def("sections", [](const AnyPatch& self, const py::object& other, const py::object& tolerance, const py::object& cancel) {
            const NurbsPatch& with = any_patch(other, "other");
            const auto most = tolerance_of(tolerance);
            return unlocked([&] { return splinecore::sections(patch_form(self), with, most); }, cancel);
          },
          py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("plane_sections", [](const AnyPatch& self, const py::object& origin, const py::object& normal,
                               const py::object& tolerance, const py::object& cancel) {
            const splinecore::Plane plane = splinecore::plane_across(vector_of(origin, "origin"), vector_of(normal, "normal"));
            const auto most = tolerance_of(tolerance);
            return unlocked([&] { return splinecore::sections(patch_form(self), plane, most); }, cancel);
          },
          py::arg("origin"), py::arg("normal"), py::arg("tolerance") = py::none(), py::kw_only(),
          py::arg("cancel") = py::none());
}

void bind_section_result(py::module_& module) {
  Class<Sections> cls(module, "Sections", py::module_local());
  seal(cls);
  pickle_members(cls, &Sections::curves, &Sections::points, &Sections::are_one);
  cls.def_property_readonly("curves", [](const Sections& self) { return curves_of(self, &splinecore::SectionCurve::curve); });
  cls.def_property_readonly("on_a", [](const Sections& self) { return curves_of(self, &splinecore::SectionCurve::on_a); });
  cls.def_property_readonly("on_b", [](const Sections& self) { return curves_of(self, &splinecore::SectionCurve::on_b); });
  cls.def_property_readonly("closed", &closed_of);
  cls.def_property_readonly("kinds", &kinds_of);
  cls.def_property_readonly("are_one", [](const Sections& self) { return self.are_one; });
  cls.def_property_readonly("points", &points_of);
  cls.def_property_readonly("parameters", &parameters_of);
  cls.def("__repr__", [](const Sections& self) {
    return "Sections(curves=" + std::to_string(self.curves.size()) + ", points=" + std::to_string(self.points.size()) + ")";
  });
}

}  // namespace

void bind_sections(py::module_& module) {
  bind_section_result(module);
  bind_section_methods(PatchClasses(module));
}

}  // namespace bindings
