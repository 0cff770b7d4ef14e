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

void bind_contour(py::module_& build) {
  build.def("contour", [](const py::object& points, const py::object& bulges, const py::object& closed,
                          const py::object& normal) {
              const std::vector<glm::dvec3> through = points_of(points);
              const std::vector<double> by = optional_numbers(bulges, "bulges");
              const bool is_closed = boolean(closed, "closed");
              const glm::dvec3 up = vector_of(normal, "normal");
              return unlocked([&] { return splinecore::contour(through, by, is_closed, up); });
            }, py::arg("points"), py::arg("bulges") = py::none(), py::arg("closed") = false,
            py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0));
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
              options.tolerance = optional_real(tolerance, "tolerance");
              return unlocked([&] { return splinecore::helix(about, options); }, cancel);
            }, py::arg("axis"), py::arg("radius"), py::arg("turns"), py::kw_only(), py::arg("end_radius") = py::none(),
            py::arg("phase") = 0.0, py::arg("start") = py::none(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none());
}

void bind_curve_on_patch(py::module_& build) {
  build.def("curve_on_patch", [](const py::object& patch, const py::object& image, const py::object& distance,
                                 const py::object& tolerance, const py::object& cancel) {
              const splinecore::NurbsPatch& on = any_patch(patch, "patch");
              const NurbsCurve& of = any_curve(image, "image");
              const double by = real(distance, "distance");
              const auto within = optional_real(tolerance, "tolerance");
              return unlocked([&] { return splinecore::curve_on_patch(on, of, by, within); }, cancel);
            }, py::arg("patch"), py::arg("image"), py::arg("distance") = 0.0, py::kw_only(),
            py::arg("tolerance") = py::none(), py::arg("cancel") = py::none());
}

void bind_join_curves(py::module_& build) {
  build.def("join_curves", [](const py::object& curves, const py::object& tolerance) {
              const std::vector<NurbsCurve> all = any_curves(curves, "curves");
              const double within = real(tolerance, "tolerance");
              return unlocked([&] { return splinecore::join_curves(all, within); });
            }, py::arg("curves"), py::arg("tolerance"));
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
            py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0));
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
