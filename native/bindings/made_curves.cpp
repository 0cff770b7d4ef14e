#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/build/contour.hpp"
#include "splinecore/build/curve_on_patch.hpp"
#include "splinecore/build/helix.hpp"
#include "splinecore/build/join_curves.hpp"
#include "splinecore/build/touching_circle.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::HelixOptions;
using splinecore::NurbsCurve;

namespace {

std::optional<double> tolerance_of(const py::object& value) {
  if (value.is_none()) return {};
  return real(value, "tolerance");
}

void bind_contour(py::module_& build) {
  build.def("contour", [](const py::object& points, const py::object& bulges, const py::object& closed,
                          const py::object& normal) {
              const std::vector<glm::dvec3> through = points_of(points);
              const std::vector<double> by = optional_numbers(bulges, "bulges");
              const bool is_closed = boolean(closed, "closed");
              const glm::dvec3 up = vector_of(normal, "normal");
              return unlocked([&] { return splinecore::contour(through, by, is_closed, up); });
            }, py::arg("points"), py::arg("bulges") = py::none(), py::arg("closed") = false,
            py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0),
            "A contour through points (n, 3), of segments and arcs: a NurbsCurve.\n\n"
            "bulges, one for each part, that from the last to the first point of a closed one too, are the tangents of a\n"
            "quarter of the arcs' angles, positive for those that run counterclockwise seen against the normal (3,), as in\n"
            "DXF files; 0 for a segment. Lecture row S18. InvalidShape if there are fewer than two points, counts disagree,\n"
            "two points that follow each other are one, or the normal is along the chord of an arc.");
}

void bind_helix(py::module_& build) {
  build.def("helix", [](const py::object& axis, const py::object& radius, const py::object& turns,
                        const py::object& end_radius, const py::object& phase, const py::object& start,
                        const py::object& tolerance, const py::object& cancel) {
              const NurbsCurve& about = any_curve(axis, "axis");
              HelixOptions options;
              options.radii[0] = real(radius, "radius");
              options.radii[1] = end_radius.is_none() ? options.radii[0] : real(end_radius, "end_radius");
              options.turns = real(turns, "turns");
              options.phase = real(phase, "phase");
              if (!start.is_none()) options.start = vector_of(start, "start");
              options.tolerance = tolerance_of(tolerance);
              return unlocked([&] { return splinecore::helix(about, options); }, cancel);
            }, py::arg("axis"), py::arg("radius"), py::arg("turns"), py::kw_only(), py::arg("end_radius") = py::none(),
            py::arg("phase") = 0.0, py::arg("start") = py::none(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none(),
            "A helix about a curve of any kind, or where the radii at its start and end differ a spiral: a NurbsCurve by the\n"
            "same parameter, of cubics with its tangents within the tolerance, a length, by default 2^-20 of the size.\n\n"
            "It turns evenly by the length of the curve, in frames that turn no more than they must: at a corner of that there is\n"
            "a gap. Left-handed where turns is negative. It starts at the angle phase, in radians, from the direction `start` (3,). Lecture row S18.\n"
            "InvalidShape if a radius is below 0, both are 0, the turns are 0 or more than 4096, or the axis is a point.");
}

void bind_curve_on_patch(py::module_& build) {
  build.def("curve_on_patch", [](const py::object& patch, const py::object& image, const py::object& distance,
                                 const py::object& tolerance, const py::object& cancel) {
              const splinecore::NurbsPatch& on = any_patch(patch, "patch");
              const NurbsCurve& of = any_curve(image, "image");
              const double by = real(distance, "distance");
              const auto within = tolerance_of(tolerance);
              return unlocked([&] { return splinecore::curve_on_patch(on, of, by, within); }, cancel);
            }, py::arg("patch"), py::arg("image"), py::arg("distance") = 0.0, py::kw_only(),
            py::arg("tolerance") = py::none(), py::arg("cancel") = py::none(),
            "The curve of a patch whose image in its parameters is a curve of any kind in the plane: x is u, y is v; or the\n"
            "curve at a distance from that along the patch's normals. A NurbsCurve by the same parameter as the image, of\n"
            "cubics with its tangents within the tolerance, a length, by default 2^-20 of the size of the patch.\n\n"
            "Corners of the image, and where it crosses creases of the patch, are its own: at a distance there are\n"
            "gaps. Beyond the domain the image goes on\n"
            "over the seam where the patch is closed. Lecture row S18. InvalidShape if it leaves the domain, or the patch has\n"
            "no normal there and the distance is not 0; PointAtInfinity.");
}

void bind_join_curves(py::module_& build) {
  build.def("join_curves", [](const py::object& curves, const py::object& tolerance) {
              const std::vector<NurbsCurve> all = any_curves(curves, "curves");
              const double within = real(tolerance, "tolerance");
              return unlocked([&] { return splinecore::join_curves(all, within); });
            }, py::arg("curves"), py::arg("tolerance"),
            "Curves of any kinds joined where their ends are within a tolerance, a length, of each other, the nearest first: a\n"
            "list of NurbsCurve. Ends meet in their middle.\n\n"
            "In the order of the first curve of each, which keeps its direction; the others are turned as they come. A chain\n"
            "that comes back closes. Closed curves, and those that no end is near, stay as they are. InvalidShape if there is\n"
            "no curve, or the tolerance is below 0.");
}

void bind_touching_circle(py::module_& build) {
  build.def("touching_circle", [](const py::object& a, const py::object& b, const py::object& c, const py::object& near,
                                  const py::object& normal) {
              const std::array<NurbsCurve, 3> curves{any_curve(a, "a"), any_curve(b, "b"), any_curve(c, "c")};
              const auto about = numbers_in<3>(near, "parameters");
              const glm::dvec3 up = vector_of(normal, "normal");
              const auto found = unlocked([&] { return splinecore::touching_circle(curves, about, up); });
              return py::make_tuple(found.arc, new_numbers(std::span<const double>(&found.center.x, 3)), found.radius,
                                    py::make_tuple(found.parameters[0], found.parameters[1], found.parameters[2]));
            }, py::arg("a"), py::arg("b"), py::arg("c"), py::arg("parameters"),
            py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0),
            "The circle that touches three curves of any kinds in one plane near `parameters` (3,), one of each:\n"
            "(arc, center (3,), radius, parameters). The NurbsCurve arc goes from where it touches a through b to c.\n\n"
            "By Newton's method from the circle through the three places; of Apollonius' eight the one with the center on that\n"
            "side of each curve. Lecture row S18. InvalidShape if the places are on one line, or there is none near them.");
}

}  // namespace

void bind_made_curves(py::module_& module) {
  py::module_ build = module.attr("build");
  bind_contour(build);
  bind_helix(build);
  bind_curve_on_patch(build);
  bind_join_curves(build);
  bind_touching_circle(build);
}

}  // namespace bindings
