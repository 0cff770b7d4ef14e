#include "splinecore/build/corners.hpp"

#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::CornerBetween;
using splinecore::NurbsCurve;

namespace {

void bind_corner_verbs(const CurveClasses& cls) {
  cls.def("rounded", [](const AnyCurve& self, const py::object& radius, const py::object& shrink, const py::object& cancel) {
            const double of = real(radius, "radius");
            const bool shrinks = boolean(shrink, "shrink");
            return unlocked([&] { return splinecore::rounded(form(self), of, shrinks); }, cancel);
          }, py::arg("radius"), py::kw_only(), py::arg("shrink") = false, py::arg("cancel") = py::none());
  cls.def("chamfered", [](const AnyCurve& self, const py::object& length, const py::object& shrink, const py::object& cancel) {
            const double by = real(length, "length");
            const bool shrinks = boolean(shrink, "shrink");
            return unlocked([&] { return splinecore::chamfered(form(self), by, shrinks); }, cancel);
          }, py::arg("length"), py::kw_only(), py::arg("shrink") = false, py::arg("cancel") = py::none());
}

py::tuple tuple_of(const CornerBetween& made) { return py::make_tuple(made.a, made.bridge, made.b); }

}  // namespace

void bind_corners(py::module_& module) {
  bind_corner_verbs(CurveClasses(module));
  py::module_ build = module.attr("build");
  build.def("filleted", [](const py::object& a, const py::object& b, const py::object& radius, const py::object& kept,
                           const py::object& normal, const py::object& cancel) {
              const NurbsCurve& first = any_curve(a, "a");
              const NurbsCurve& second = any_curve(b, "b");
              const double of = real(radius, "radius");
              const auto about = numbers_in<2>(kept, "kept");
              const glm::dvec3 up = vector_of(normal, "normal");
              return tuple_of(unlocked([&] { return splinecore::filleted(first, second, of, about, up); }, cancel));
            }, py::arg("a"), py::arg("b"), py::arg("radius"), py::arg("kept"),
            py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0), py::kw_only(), py::arg("cancel") = py::none());
  build.def("chamfered", [](const py::object& a, const py::object& b, const py::object& lengths, const py::object& kept,
                            const py::object& cancel) {
              const NurbsCurve& first = any_curve(a, "a");
              const NurbsCurve& second = any_curve(b, "b");
              const auto by = numbers_in<2>(lengths, "lengths");
              const auto about = numbers_in<2>(kept, "kept");
              return tuple_of(unlocked([&] { return splinecore::chamfered(first, second, by, about); }, cancel));
            }, py::arg("a"), py::arg("b"), py::arg("lengths"), py::arg("kept"), py::kw_only(),
            py::arg("cancel") = py::none());
}

}  // namespace bindings
