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
            py::arg("end_b") = "start", py::arg("strengths") = py::make_tuple(1.0, 1.0));
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
            py::kw_only(), py::arg("cancel") = py::none());
}

}  // namespace bindings
