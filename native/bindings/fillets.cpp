#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/build/blend.hpp"
#include "splinecore/build/fillet.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Fillet;
using splinecore::NurbsCurve;

namespace {

void bind_blend(py::module_& build) {
  build.def("blend", [](const py::object& a, const py::object& b, const py::object& continuity, const py::object& end_a,
                        const py::object& end_b, const py::object& strengths) {
              const splinecore::BlendEnd from{any_curve(a, "a"), is_end_of(end_a, "end_a")};
              const splinecore::BlendEnd to{any_curve(b, "b"), is_end_of(end_b, "end_b")};
              return splinecore::blend(from, to, integer(continuity, "continuity"), numbers_in<2>(strengths, "strengths"));
            }, py::arg("a"), py::arg("b"), py::arg("continuity") = 2, py::kw_only(), py::arg("end_a") = "end",
            py::arg("end_b") = "start", py::arg("strengths") = py::make_tuple(1.0, 1.0),
            "The BezierCurve that joins ends of two curves of any kinds smoothly: with\n"
            "the point, the direction, the curvature and its derivative by the length for continuity 0, 1, 2, 3 (G0 to G3); of\n"
            "degree 2 continuity + 1. Ends are 'start' or 'end'.\n\n"
            "strengths (2,) are the speeds at both ends by the distance between them: how far it follows each curve. Rows S7,\n"
            "S16. InvalidShape if the continuity is another, a strength is not above 0, the ends are one, or a curve stands\n"
            "still at its end; PointAtInfinity.");
}

}  // namespace

void bind_fillets(py::module_& module) {
  py::module_ build = module.attr("build");
  bind_blend(build);
  build.def("fillets", [](const py::object& a, const py::object& b, const py::object& radius, const py::object& normal,
                          const py::object& cancel) {
              const NurbsCurve& first = any_curve(a, "a");
              const NurbsCurve& second = any_curve(b, "b");
              const double of = real(radius, "radius");
              const glm::dvec3 up = vector_of(normal, "normal");
              py::list found;
              for (const Fillet& one : unlocked([&] { return splinecore::fillets(first, second, of, up); }, cancel)) {
                found.append(py::make_tuple(one.arc, one.a, one.b, one.goes_on_a, one.goes_on_b));
              }
              return found;
            }, py::arg("a"), py::arg("b"), py::arg("radius"), py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0),
            py::kw_only(), py::arg("cancel") = py::none(),
            "All arcs of circles with a radius that touch two curves of any kinds in one plane, in the order of the\n"
            "parameters of a: a list of (arc, a, b, goes_on_a, goes_on_b). arc is a NurbsCurve from a to b, no longer than\n"
            "half a turn; a and b are the parameters at which it touches them; goes_on_a is whether a runs into the arc\n"
            "there rather than away from it, goes_on_b whether the arc runs along b rather than against it.\n\n"
            "Centers are where the offsets of both curves cross, to either side, by Newton's method to rounding, or by\n"
            "halving where that does not tell; where offsets are one along a stretch, as of lines beside each other, its\n"
            "ends. Corners and cusps of the curves are touched by nothing. Lecture row S18. InvalidShape if the radius is not above 0,\n"
            "the normal (3,) is zero, the curves are not in a plane with it, or it is not told whether an arc touches both.");
}

}  // namespace bindings
