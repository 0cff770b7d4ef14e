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
            py::arg("sweep") = py::none(),
            "The mantle of a cylinder as a NurbsPatch of degree (2, 1), exact.\n\n"
            "It stands on the circle about center (3,), at right angles to axis (3,), of which only the direction\n"
            "counts. u is the longitude, counterclockwise about the axis, v in [0, 1] the height; normals point\n"
            "outwards. start and sweep are radians: None is a whole turn, periodic in u; a negative sweep runs\n"
            "clockwise and turns the normals over. InvalidShape names what is not finite, no positive length, an axis\n"
            "without direction, or a sweep that is 0 or more than a turn. The NURBS Book, 8.3; row S20.");
  build.def("cone", [](const py::object& center, const py::object& axis, const py::object& radius,
                       const py::object& height, const py::object& top_radius, const py::object& start,
                       const py::object& sweep) {
              return splinecore::cone(vector_of(center, "center"), vector_of(axis, "axis"), real(radius, "radius"),
                                      real(height, "height"), real(top_radius, "top_radius"), turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("radius"), py::arg("height"), py::arg("top_radius") = 0.0,
            py::arg("start") = 0.0, py::arg("sweep") = py::none(),
            "The mantle of a cone as a NurbsPatch of degree (2, 1), truncated where top_radius is not 0.\n\n"
            "As cylinder(), from the circle of radius about center up to that of top_radius. A radius of 0 is a\n"
            "tip: the edge is a pole. InvalidShape if both are 0. The NURBS Book, 8.5; row S20.");
  build.def("disc", [](const py::object& center, const py::object& axis, const py::object& radius,
                       const py::object& start, const py::object& sweep) {
              return splinecore::disc(vector_of(center, "center"), vector_of(axis, "axis"), real(radius, "radius"),
                                      turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("radius"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none(),
            "A flat disc as a NurbsPatch of degree (2, 1): u is the angle, v runs from the rim to the pole inside.\n\n"
            "Its normal is the axis; its rim is that of a cylinder() or cone() about the same axis, which it closes.\n"
            "The rest as for cylinder(). Row S20.");
  build.def("sphere", [](const py::object& center, const py::object& radius, const py::object& axis,
                         const py::object& start, const py::object& sweep) {
              return splinecore::sphere(vector_of(center, "center"), real(radius, "radius"), vector_of(axis, "axis"),
                                        turn_of(start, sweep));
            },
            py::arg("center"), py::arg("radius"), py::arg("axis") = py::make_tuple(0.0, 0.0, 1.0),
            py::arg("start") = 0.0, py::arg("sweep") = py::none(),
            "A sphere as a NurbsPatch of degree (2, 2): u is the longitude, v in [0, 2] the latitude from south to\n"
            "north; both edges in v are poles. Normals point outwards.\n\n"
            "The rest as for cylinder(). The NURBS Book, 8.5; row S20.");
  build.def("torus", [](const py::object& center, const py::object& axis, const py::object& ring_radius,
                        const py::object& tube_radius, const py::object& start, const py::object& sweep) {
              return splinecore::torus(vector_of(center, "center"), vector_of(axis, "axis"),
                                       real(ring_radius, "ring_radius"), real(tube_radius, "tube_radius"),
                                       turn_of(start, sweep));
            },
            py::arg("center"), py::arg("axis"), py::arg("ring_radius"), py::arg("tube_radius"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none(),
            "A torus as a NurbsPatch of degree (2, 2), periodic in v and for a whole turn in u.\n\n"
            "The middle of its tube runs on the circle of ring_radius; v goes around the tube from the outer equator\n"
            "upwards. Normals point outwards. The rest as for cylinder(). The NURBS Book, 8.5; row S20.");
}

void bind_sweeps(py::module_& build) {
  build.def("plane", [](const py::object& origin, const py::object& axis_a, const py::object& axis_b) {
              return splinecore::plane(vector_of(origin, "origin"), vector_of(axis_a, "axis_a"),
                                       vector_of(axis_b, "axis_b"));
            }, py::arg("origin"), py::arg("axis_a"), py::arg("axis_b"),
            "The parallelogram origin + u axis_a + v axis_b, u and v in [0, 1], as a NurbsPatch of degree (1, 1).\n\n"
            "All (3,); the normal is along axis_a x axis_b. InvalidShape if they are zero or parallel. Row S20.");
  build.def("revolve", [](const py::object& curve, const py::object& axis_point, const py::object& axis_direction,
                          const py::object& start, const py::object& sweep) {
              const NurbsCurve profile = curve_of(curve, "curve");
              const glm::dvec3 point = vector_of(axis_point, "axis_point");
              const glm::dvec3 direction = vector_of(axis_direction, "axis_direction");
              const Turn turn = turn_of(start, sweep);
              return unlocked([&] { return splinecore::revolve(profile, point, direction, turn); });
            },
            py::arg("curve"), py::arg("axis_point"), py::arg("axis_direction"), py::arg("start") = 0.0,
            py::arg("sweep") = py::none(),
            "The surface of a curve of any kind that turns about an axis, as a NurbsPatch, exact.\n\n"
            "u runs about the axis, one span for each quarter turn, v along the curve on its own knots and\n"
            "domain. The angle 0 is the curve where it is; start and sweep are radians, None a whole turn, which is\n"
            "periodic in u.\n"
            "Normals point away from the axis where the curve runs in its direction. Control points on the axis make\n"
            "poles. InvalidShape if the axis has no direction, the sweep is 0 or more than a turn, or the curve lies\n"
            "on the axis. The NURBS Book, A8.1; row S20.");
  build.def("extrude", [](const py::object& curve, const py::object& vector) {
              return splinecore::extrude(curve_of(curve, "curve"), vector_of(vector, "vector"));
            }, py::arg("curve"), py::arg("vector"),
            "The surface of a curve of any kind that moves along a vector (3,), as a NurbsPatch.\n\n"
            "u is the curve's parameter, v in [0, 1] the share of the vector; normals point along C' x vector.\n"
            "InvalidShape if the vector has no length. The NURBS Book, 8.3; row S20.");
  build.def("ruled", [](const py::object& a, const py::object& b) {
              const NurbsCurve first = curve_of(a, "a");
              const NurbsCurve second = curve_of(b, "b");
              return unlocked([&] { return splinecore::ruled(first, second); });
            }, py::arg("a"), py::arg("b"),
            "The surface of the segments between two curves of any kinds at one parameter, as a NurbsPatch.\n\n"
            "u lies in the domain of a, to which that of b is mapped; the lower degree is raised and the knots are\n"
            "merged. v goes from a to b in [0, 1]: evenly where their weights are equal, otherwise along the same\n"
            "segment at another pace. Periodic if both are. The NURBS Book, 8.4; row S20.");
}

}  // namespace

void bind_primitives(py::module_& module) {
  py::module_ build = module.attr("build");
  bind_round_bodies(build);
  bind_sweeps(build);
}

}  // namespace bindings
