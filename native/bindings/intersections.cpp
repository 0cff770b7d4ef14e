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
          py::arg("patch"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(),
          "Where the curve and a patch, of any kind, are at most tolerance apart, as PatchIntersections: places where\n"
          "their distance is least, ends of the curve included, in the order of its parameters, and stretches that lie\n"
          "on the patch. tolerance is a length, by default 2^-33 of how far control points of both reach from the middle\n"
          "of them all. Where the patch crosses itself there is a place for each of its sheets; a stretch over the end\n"
          "of a closed curve is one, and its end a turn further.\n\n"
          "By halving, as intersections(): a part goes through a part of the patch once at most where no tangent is\n"
          "parallel to a tangent plane. Lecture row S18. cancel is a callable that ends a long call by returning True.\n"
          "InvalidShape if the tolerance is below 0, or where more than 2^20 pairs of parts are within it.");
  cls.def("plane_intersections", [](const AnyCurve& self, const py::object& origin, const py::object& normal,
                                    const py::object& tolerance, const py::object& cancel) {
            const splinecore::Plane plane = splinecore::plane_across(vector_of(origin, "origin"), vector_of(normal, "normal"));
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::intersections(form(self), plane, most); }, cancel));
          },
          py::arg("origin"), py::arg("normal"), py::arg("tolerance") = py::none(), py::kw_only(),
          py::arg("cancel") = py::none(),
          "The same with the plane through a point (3,) at right angles to a vector (3,). Parameters on it are its own\n"
          "coordinates, with axes by the rule of DXF files: x and y where the normal is z. The default tolerance is by\n"
          "the curve alone.\n\n"
          "InvalidShape as patch_intersections(), and if the normal is zero.");
}

void bind_curve(const CurveClasses& cls) {
  cls.def("intersections", [](const AnyCurve& self, const py::object& other, const py::object& tolerance,
                              const py::object& cancel) {
            const NurbsCurve& with = any_curve(other, "other");
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::intersections(form(self), with, most); }, cancel));
          },
          py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(),
          "Where the curve and another one, of any kind, are at most tolerance apart, as Intersections: places where\n"
          "their distance is least, ends included, in the order of the parameters of this one, and stretches that\n"
          "they have in common. tolerance is a length, by default 2^-33 of how far control points of both reach from the\n"
          "middle of them all.\n\n"
          "Curves that cross are found however near the crossings are to each other; places are one only where both\n"
          "curves stay within the tolerance of each other from one to the other. What folds has an overlap for each\n"
          "way. Of a curve that ends where it begins places are in [start, end). What lies farther away than 2^20\n"
          "times the size, where a curve runs through infinity, meets nothing. Pairs of Bernstein pieces on two trees\n"
          "of boxes are halved until their hulls are apart, their tangents differ so that they cross once at most\n"
          "(Sederberg and Meyers 1988), or they lie together. Lecture row S18. cancel is a callable that ends a long call by returning True.\n"
          "InvalidShape if the tolerance is below 0, or where more than 2^22 pairs of parts are within it, and 512\n"
          "a span.");
  cls.def("self_intersections", [](const AnyCurve& self, const py::object& tolerance, const py::object& cancel) {
            const auto most = tolerance_of(tolerance);
            return arrays_of(unlocked([&] { return splinecore::self_intersections(form(self), most); }, cancel));
          },
          py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none(),
          "Where the curve meets itself, as intersections() has it of two: the first parameter is the smaller one.\n\n"
          "Without places next to each other along the curve, as at a cusp, and where it ends at its beginning; where it\n"
          "folds it lies on itself.");
}

void bind_result(py::module_& module) {
  Class<Intersections> cls(module, "Intersections", py::module_local(),
                                "The n places where two curves meet, and the m stretches that they have in common.\n\n"
                                "parameters is (n, 2): of the first and the second curve; points (n, 3), in the middle\n"
                                "between both; distances (n,), of the curves there; touches (n,), whether their tangents\n"
                                "are parallel. overlaps is (m, 2, 2): start and end on the first curve and on the second;\n"
                                "reversed (m,), whether they run against each other.");
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
  Class<PatchIntersections> cls(module, "PatchIntersections", py::module_local(),
                                     "The n places where a curve meets a patch, and the m stretches that lie on it.\n\n"
                                     "parameters is (n, 3): t of the curve, u and v of the patch; points (n, 3), in the\n"
                                     "middle between both; distances (n,), of both there; touches (n,), whether the curve\n"
                                     "does not go through the patch. overlaps is (m, 2): start and end on the curve.");
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
  bind_result(module);
  bind_patch_result(module);
  bind_curve(CurveClasses(module));
  bind_with_patches(CurveClasses(module));
}

}  // namespace bindings
