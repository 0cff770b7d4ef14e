#include "splinecore/build/primitives.hpp"

#include <optional>

#include "arrays.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/power_curve.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::Turn;

namespace {

/// One vector of two or three numbers.
glm::dvec3 vector_of(const py::object& value, const char* name) {
  const Doubles given = real_array(value, name);
  if (given.ndim() != 1 || (given.size() != 2 && given.size() != 3)) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(given) + ", (2,) or (3,) is expected");
  }
  return {given.data()[0], given.data()[1], given.size() == 3 ? given.data()[2] : 0.0};
}

/// The NURBS form of any curve.
NurbsCurve curve_of(const py::object& value, const char* name) {
  if (py::isinstance<NurbsCurve>(value)) return py::cast<const NurbsCurve&>(value);
  if (py::isinstance<splinecore::BezierCurve>(value)) return py::cast<const splinecore::BezierCurve&>(value).nurbs();
  if (py::isinstance<splinecore::HermiteCurve>(value)) return py::cast<const splinecore::HermiteCurve&>(value).nurbs();
  if (py::isinstance<splinecore::PowerCurve>(value)) return py::cast<const splinecore::PowerCurve&>(value).nurbs();
  throw py::type_error(std::string(name) + " must be a curve, not " + type_name(value));
}

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
              const NurbsCurve profile = curve_of(curve, "curve");
              const glm::dvec3 point = vector_of(axis_point, "axis_point");
              const glm::dvec3 direction = vector_of(axis_direction, "axis_direction");
              const Turn turn = turn_of(start, sweep);
              return unlocked([&] { return splinecore::revolve(profile, point, direction, turn); });
            },
            py::arg("curve"), py::arg("axis_point"), py::arg("axis_direction"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none());
  build.def("extrude", [](const py::object& curve, const py::object& vector) {
              return splinecore::extrude(curve_of(curve, "curve"), vector_of(vector, "vector"));
            }, py::arg("curve"), py::arg("vector"));
  build.def("ruled", [](const py::object& a, const py::object& b) {
              const NurbsCurve first = curve_of(a, "a");
              const NurbsCurve second = curve_of(b, "b");
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
