#include "splinecore/meet/stationary.hpp"

#include <algorithm>

#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "nearest.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Stationary;

namespace {

/// What Python sees of the places where a distance is stationary.
struct StationaryPoints {
  Nearest places;
  py::tuple kinds;
};

const char* name_of(Stationary kind) {
  if (kind == Stationary::minimum) return "minimum";
  return kind == Stationary::maximum ? "maximum" : "saddle";
}

py::tuple kinds_of(const auto& found) {
  py::tuple kinds(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) kinds[i] = name_of(found[i].kind);
  return kinds;
}

template <class Form>
StationaryPoints stationary_points(const Form& form, const py::object& point, const py::object& cancel) {
  const glm::dvec3 from = vector_of(point, "point");
  const auto found = unlocked([&] { return splinecore::stationary_points(form, from); }, cancel);
  return {arrays_of(found), kinds_of(found)};
}

template <class Form>
Nearest nearest_all(const Form& form, const py::object& point, const py::object& tolerance,
                    const py::object& cancel) {
  const glm::dvec3 from = vector_of(point, "point");
  const auto most = optional_real(tolerance, "tolerance");
  return arrays_of(unlocked([&] { return splinecore::nearest_all(form, from, most); }, cancel));
}

void bind_stationary_points(const CurveClasses& cls) {
  cls.def("stationary_points", [](const AnyCurve& self, const py::object& point, const py::object& cancel) {
            return stationary_points(form(self), point, cancel);
          },
          py::arg("point"), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("nearest_all", [](const AnyCurve& self, const py::object& point, const py::object& tolerance,
                            const py::object& cancel) {
            return nearest_all(form(self), point, tolerance, cancel);
          },
          py::arg("point"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
}

void bind_stationary_methods(const PatchClasses& cls) {
  cls.def("stationary_points", [](const AnyPatch& self, const py::object& point, const py::object& cancel) {
            return stationary_points(patch_form(self), point, cancel);
          },
          py::arg("point"), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("nearest_all", [](const AnyPatch& self, const py::object& point, const py::object& tolerance,
                            const py::object& cancel) {
            return nearest_all(patch_form(self), point, tolerance, cancel);
          },
          py::arg("point"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
}

void bind_stationary_result(py::module_& module) {
  Class<StationaryPoints> cls(module, "StationaryPoints", py::module_local());
  seal(cls);
  pickle_members(cls, &StationaryPoints::places, &StationaryPoints::kinds);
  cls.def_property_readonly("parameters", [](const StationaryPoints& self) { return self.places.parameters; });
  cls.def_property_readonly("points", [](const StationaryPoints& self) { return self.places.points; });
  cls.def_property_readonly("distances", [](const StationaryPoints& self) { return self.places.distances; });
  cls.def_readonly("kinds", &StationaryPoints::kinds);
  cls.def("__repr__", [](const StationaryPoints& self) {
    return "StationaryPoints(count=" + std::to_string(self.kinds.size()) + ")";
  });
}

}  // namespace

void bind_stationary(py::module_& module) {
  bind_stationary_result(module);
  bind_stationary_points(CurveClasses(module));
  bind_stationary_methods(PatchClasses(module));
}

}  // namespace bindings
