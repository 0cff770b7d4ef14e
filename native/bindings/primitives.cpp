#include "splinecore/build/primitives.hpp"

#include <optional>

#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"

namespace bindings {

using splinecore::NurbsCurve;
using splinecore::Turn;

namespace {

Turn turn_of(const py::object& start, const py::object& sweep) {
  Turn turn;
  turn.start = real(start, "start");
  turn.sweep = optional_real(sweep, "sweep").value_or(turn.sweep);
  return turn;
}

void bind_round_bodies(py::module_& build) {
  build.def("cylinder", [](const py::object& center, const py::object& axis, const py::object& radius,
                           const py::object& height, const py::object& start, const py::object& sweep) {
              return splinecore::cylinder(vector_of(center, "center"), vector_of(axis, "axis"), real(radius, "radius"),
                                          real(height, "height"), turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("radius"), py::arg("height"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none());
  build.def("cone", [](const py::object& center, const py::object& axis, const py::object& radius,
                       const py::object& height, const py::object& top_radius, const py::object& start,
                       const py::object& sweep) {
              return splinecore::cone(vector_of(center, "center"), vector_of(axis, "axis"), real(radius, "radius"),
                                      real(height, "height"), real(top_radius, "top_radius"), turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("radius"), py::arg("height"), py::arg("top_radius") = 0.0,
            py::arg("start") = 0.0, py::arg("sweep") = py::none());
  build.def("disc", [](const py::object& center, const py::object& axis, const py::object& radius,
                       const py::object& start, const py::object& sweep) {
              return splinecore::disc(vector_of(center, "center"), vector_of(axis, "axis"), real(radius, "radius"),
                                      turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("radius"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none());
  build.def("sphere", [](const py::object& center, const py::object& radius, const py::object& axis,
                         const py::object& start, const py::object& sweep) {
              return splinecore::sphere(vector_of(center, "center"), real(radius, "radius"), vector_of(axis, "axis"),
                                        turn_of(start, sweep));
            },
            py::arg("center"), py::arg("radius"), py::arg("axis") = py::make_tuple(0.0, 0.0, 1.0),
            py::arg("start") = 0.0, py::arg("sweep") = py::none());
  build.def("torus", [](const py::object& center, const py::object& axis, const py::object& ring_radius,
                        const py::object& tube_radius, const py::object& start, const py::object& sweep) {
              return splinecore::torus(vector_of(center, "center"), vector_of(axis, "axis"),
                                       real(ring_radius, "ring_radius"), real(tube_radius, "tube_radius"),
                                       turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("ring_radius"), py::arg("tube_radius"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none());
}

void bind_sweeps(py::module_& build) {
  build.def("plane", [](const py::object& origin, const py::object& axis_a, const py::object& axis_b) {
              return splinecore::plane(vector_of(origin, "origin"), vector_of(axis_a, "axis_a"),
                                       vector_of(axis_b, "axis_b"));
            }, py::arg("origin"), py::arg("axis_a"), py::arg("axis_b"));
  build.def("revolve", [](const py::object& curve, const py::object& axis_point, const py::object& axis_direction,
                          const py::object& start, const py::object& sweep) {
              const NurbsCurve profile = any_curve(curve, "curve");
              const glm::dvec3 point = vector_of(axis_point, "axis_point");
              const glm::dvec3 direction = vector_of(axis_direction, "axis_direction");
              const Turn turn = turn_of(start, sweep);
              return unlocked([&] { return splinecore::revolve(profile, point, direction, turn); });
            },
            py::arg("curve"), py::arg("axis_point"), py::arg("axis_direction"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none());
  build.def("extrude", [](const py::object& curve, const py::object& vector) {
              return splinecore::extrude(any_curve(curve, "curve"), vector_of(vector, "vector"));
            }, py::arg("curve"), py::arg("vector"));
  build.def("ruled", [](const py::object& a, const py::object& b) {
              const NurbsCurve first = any_curve(a, "a");
              const NurbsCurve second = any_curve(b, "b");
              return unlocked([&] { return splinecore::ruled(first, second); });
            }, py::arg("a"), py::arg("b"));
}

}  // namespace

void bind_primitives(py::module_& module) {
  py::module_ build = module.attr("build");
  bind_round_bodies(build);
  bind_sweeps(build);
}

}  // namespace bindings
