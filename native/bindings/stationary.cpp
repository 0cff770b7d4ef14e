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

}  // namespace

template <>
struct StateOf<Nearest> : StateOfMembers<&Nearest::parameters, &Nearest::points, &Nearest::distances> {};

namespace {

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

void bind_curve(const CurveClasses& cls) {
  cls.def("stationary_points", [](const AnyCurve& self, const py::object& point, const py::object& cancel) {
            return stationary_points(form(self), point, cancel);
          },
          py::arg("point"), py::kw_only(), py::arg("cancel") = py::none(),
          "All n places where the distance from a point (2 or 3,) is stationary, (C - P) · C' = 0, as\n"
          "StationaryPoints: the feet of all normals through it, the ends of the curve and of its pieces, and\n"
          "corners where the distance is a minimum or a maximum.\n\n"
          "In the order of parameters, each once, of a curve that ends where it begins in [start, end). Zeros of\n"
          "a polynomial in Bernstein's form on every span, by halving (Lane and Riesenfeld 1981); places that\n"
          "rounding does not tell apart are one. Of a curve that passes through infinity the finite places count.\n"
          "cancel is a callable that ends a long call by returning True. InvalidShape if the point is not finite\n"
          "or too far away, or, naming an interval, where the distance is constant, as from a circle's center.");
  cls.def("nearest_all", [](const AnyCurve& self, const py::object& point, const py::object& tolerance,
                            const py::object& cancel) {
            return nearest_all(form(self), point, tolerance, cancel);
          },
          py::arg("point"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(),
          "All n places where the distance from a point (2 or 3,) is a minimum and at most tolerance greater\n"
          "than the least one, by default a few roundings of the coordinates, as a Nearest: parameters (n,).\n\n"
          "Those of stationary_points(): ends and corners included, in the order of parameters. InvalidShape if\n"
          "the tolerance is below 0 or the point not finite, and where the distance is constant and as small.");
}

void bind_patch(const PatchClasses& cls) {
  cls.def("stationary_points", [](const AnyPatch& self, const py::object& point, const py::object& cancel) {
            return stationary_points(patch_form(self), point, cancel);
          },
          py::arg("point"), py::kw_only(), py::arg("cancel") = py::none(),
          "All n places where the distance from a point (2 or 3,) is stationary, (S - P) · S_u and (S - P) · S_v\n"
          "both 0, as StationaryPoints: the feet of all normals through it; and on borders and edges between\n"
          "pieces, in corners and poles those where the distance is a minimum or a maximum of the patch.\n\n"
          "In the order of u, then v, each once, where it closes in [start, end). Common zeros of two polynomials\n"
          "in Bernstein's form on every pair of spans, by halving (Sherbrooke and Patrikalakis 1993) and Newton's\n"
          "method; places that rounding does not tell apart are one. cancel is a callable that ends a long call\n"
          "by returning True. InvalidShape if the point is not finite or too far away, or, naming one of them,\n"
          "where such places are a curve or more, as from the center of a sphere.");
  cls.def("nearest_all", [](const AnyPatch& self, const py::object& point, const py::object& tolerance,
                            const py::object& cancel) {
            return nearest_all(patch_form(self), point, tolerance, cancel);
          },
          py::arg("point"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(),
          "All n places where the distance from a point (2 or 3,) is a minimum and at most tolerance greater\n"
          "than the least one, by default a few roundings of the coordinates, as a Nearest: parameters (n, 2).\n\n"
          "Those of stationary_points(): borders, corners and poles included, in the order of u, then v.\n"
          "InvalidShape if the tolerance is below 0 or the point not finite, and where such places are a curve.");
}

void bind_result(py::module_& module) {
  Class<StationaryPoints> cls(module, "StationaryPoints", py::module_local(),
                                   "The n places of a shape where the distance from a point is stationary.\n\n"
                                   "parameters is (n,) on a curve and (n, 2), u and v, on a patch; points is (n, 3),\n"
                                   "distances (n,). kinds holds for each 'minimum', 'maximum' or 'saddle', which is\n"
                                   "neither of them.");
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
  bind_result(module);
  bind_curve(CurveClasses(module));
  bind_patch(PatchClasses(module));
}

}  // namespace bindings
