#include "splinecore/meet/intersections.hpp"

#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::CurveIntersections;
using splinecore::NurbsCurve;

namespace {

/// What Python sees of the places where two shapes meet.
struct Intersections {
  py::array_t<double> parameters;
  py::array_t<double> points;
  py::array_t<double> distances;
  py::array_t<bool> touches;
  py::array_t<double> overlaps;
  py::array_t<bool> reversed;
};

Intersections arrays_of(const CurveIntersections& found) {
  const auto count = static_cast<py::ssize_t>(found.places.size());
  const auto overlaps = static_cast<py::ssize_t>(found.overlaps.size());
  Intersections out{py::array_t<double>({count, py::ssize_t{2}}), py::array_t<double>({count, py::ssize_t{3}}),
                    new_numbers<double>(found.places.size()), new_numbers<bool>(found.places.size()),
                    py::array_t<double>({overlaps, py::ssize_t{2}, py::ssize_t{2}}), new_numbers<bool>(found.overlaps.size())};
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto& place = found.places[static_cast<std::size_t>(i)];
    out.parameters.mutable_at(i, 0) = place.a;
    out.parameters.mutable_at(i, 1) = place.b;
    for (int axis = 0; axis < 3; ++axis) out.points.mutable_at(i, axis) = place.point[axis];
    out.distances.mutable_at(i) = place.distance;
    out.touches.mutable_at(i) = place.touches;
  }
  for (py::ssize_t i = 0; i < overlaps; ++i) {
    const auto& overlap = found.overlaps[static_cast<std::size_t>(i)];
    out.overlaps.mutable_at(i, 0, 0) = overlap.a.start;
    out.overlaps.mutable_at(i, 0, 1) = overlap.a.end;
    out.overlaps.mutable_at(i, 1, 0) = overlap.b.start;
    out.overlaps.mutable_at(i, 1, 1) = overlap.b.end;
    out.reversed.mutable_at(i) = overlap.is_reversed;
  }
  return out;
}

/// The same of a curve and a patch.
struct PatchIntersections {
  py::array_t<double> parameters;
  py::array_t<double> points;
  py::array_t<double> distances;
  py::array_t<bool> touches;
  py::array_t<double> overlaps;
};

PatchIntersections arrays_of(const splinecore::PatchIntersections& found) {
  const auto count = static_cast<py::ssize_t>(found.places.size());
  const auto overlaps = static_cast<py::ssize_t>(found.overlaps.size());
  PatchIntersections out{py::array_t<double>({count, py::ssize_t{3}}), py::array_t<double>({count, py::ssize_t{3}}),
                         new_numbers<double>(found.places.size()), new_numbers<bool>(found.places.size()),
                         py::array_t<double>({overlaps, py::ssize_t{2}})};
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto& place = found.places[static_cast<std::size_t>(i)];
    out.parameters.mutable_at(i, 0) = place.t;
    out.parameters.mutable_at(i, 1) = place.parameters[0];
    out.parameters.mutable_at(i, 2) = place.parameters[1];
    for (int axis = 0; axis < 3; ++axis) out.points.mutable_at(i, axis) = place.point[axis];
    out.distances.mutable_at(i) = place.distance;
    out.touches.mutable_at(i) = place.touches;
  }
  for (py::ssize_t i = 0; i < overlaps; ++i) {
    out.overlaps.mutable_at(i, 0) = found.overlaps[static_cast<std::size_t>(i)].start;
    out.overlaps.mutable_at(i, 1) = found.overlaps[static_cast<std::size_t>(i)].end;
  }
  return out;
}

void bind_with_patches(const CurveClasses& cls) {
  cls.def("patch_intersections", [](const AnyCurve& self, const py::object& patch, const py::object& tolerance,
                                    const py::object& cancel) {
            const splinecore::NurbsPatch& with = any_patch(patch, "patch");
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::intersections(form(self), with, most); }, cancel));
          },
          py::arg("patch"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("plane_intersections", [](const AnyCurve& self, const py::object& origin, const py::object& normal,
                                    const py::object& tolerance, const py::object& cancel) {
            const splinecore::Plane plane = splinecore::plane_across(vector_of(origin, "origin"), vector_of(normal, "normal"));
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::intersections(form(self), plane, most); }, cancel));
          },
          py::arg("origin"), py::arg("normal"), py::arg("tolerance") = py::none(), py::kw_only(),
          py::arg("cancel") = py::none());
}

void bind_meets_of_curves(const CurveClasses& cls) {
  cls.def("intersections", [](const AnyCurve& self, const py::object& other, const py::object& tolerance,
                              const py::object& cancel) {
            const NurbsCurve& with = any_curve(other, "other");
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::intersections(form(self), with, most); }, cancel));
          },
          py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
  cls.def("self_intersections", [](const AnyCurve& self, const py::object& tolerance, const py::object& cancel) {
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::self_intersections(form(self), most); }, cancel));
          },
          py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
}

void bind_meets(py::module_& module) {
  Class<Intersections> cls(module, "Intersections", py::module_local());
  seal(cls);
  pickle_members(cls, &Intersections::parameters, &Intersections::points, &Intersections::distances,
                  &Intersections::touches, &Intersections::overlaps, &Intersections::reversed);
  cls.def_property_readonly("parameters", [](const Intersections& self) { return self.parameters; });
  cls.def_property_readonly("points", [](const Intersections& self) { return self.points; });
  cls.def_property_readonly("distances", [](const Intersections& self) { return self.distances; });
  cls.def_property_readonly("touches", [](const Intersections& self) { return self.touches; });
  cls.def_property_readonly("overlaps", [](const Intersections& self) { return self.overlaps; });
  cls.def_property_readonly("reversed", [](const Intersections& self) { return self.reversed; });
  cls.def("__repr__", [](const Intersections& self) {
    return "Intersections(count=" + std::to_string(self.distances.size()) +
           ", overlaps=" + std::to_string(self.reversed.size()) + ")";
  });
}

void bind_patch_result(py::module_& module) {
  Class<PatchIntersections> cls(module, "PatchIntersections", py::module_local());
  seal(cls);
  pickle_members(cls, &PatchIntersections::parameters, &PatchIntersections::points, &PatchIntersections::distances,
                  &PatchIntersections::touches, &PatchIntersections::overlaps);
  cls.def_property_readonly("parameters", [](const PatchIntersections& self) { return self.parameters; });
  cls.def_property_readonly("points", [](const PatchIntersections& self) { return self.points; });
  cls.def_property_readonly("distances", [](const PatchIntersections& self) { return self.distances; });
  cls.def_property_readonly("touches", [](const PatchIntersections& self) { return self.touches; });
  cls.def_property_readonly("overlaps", [](const PatchIntersections& self) { return self.overlaps; });
  cls.def("__repr__", [](const PatchIntersections& self) {
    return "PatchIntersections(count=" + std::to_string(self.distances.size()) +
           ", overlaps=" + std::to_string(self.overlaps.shape(0)) + ")";
  });
}

}  // namespace

void bind_intersections(py::module_& module) {
  bind_meets(module);
  bind_patch_result(module);
  bind_meets_of_curves(CurveClasses(module));
  bind_with_patches(CurveClasses(module));
}

}  // namespace bindings
