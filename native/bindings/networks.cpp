#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/surface/coons.hpp"
#include "splinecore/surface/network.hpp"

namespace bindings {

using splinecore::NurbsCurve;

void bind_networks(py::module_& module) {
  py::module_ build = module.attr("build");
  build.def("coons", [](const py::object& sides, const py::object& tolerance, const py::object& cancel) {
              const std::vector<NurbsCurve> around = any_curves(sides, "sides");
              const auto within = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::coons(around, within); }, cancel));
            }, py::arg("sides"), py::kw_only(), py::arg("tolerance") = py::none(), py::arg("cancel") = py::none(),
            "The patch between three or four curves of any kinds that go round it, in any directions: (value, error), a\n"
            "NurbsPatch and how far an end was moved. Both ruled surfaces between opposite curves, less the bilinear patch of\n"
            "the corners (Coons 1967; lecture row S21). Of three the last side is a point.\n\n"
            "u runs along the first curve, v from there to the third one. Weights of sides are multiplied so that they are 1 at\n"
            "both ends. Ends may lie apart by the tolerance, a length, by default 2^-30 of the size: both go to their middle.\n"
            "InvalidShape if there are not three or four curves, one is closed or ends at infinity, or its end weights have\n"
            "not one sign; ToleranceNotReached says how far neighbours' ends lie apart.");
  build.def("network", [](const py::object& along_u, const py::object& along_v, const py::object& tolerance,
                          const py::object& cancel) {
              const std::vector<NurbsCurve> u = any_curves(along_u, "along_u");
              const std::vector<NurbsCurve> v = any_curves(along_v, "along_v");
              const auto within = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::network(u, v, within); }, cancel));
            }, py::arg("along_u"), py::arg("along_v"), py::kw_only(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none(),
            "The surface through a network of curves of any kinds, each of the first ones meeting each of the others once:\n"
            "(value, error), a NurbsPatch and the largest distance from a curve. The surfaces through either, less the one\n"
            "through their crossings (Gordon 1969; lecture row S21).\n\n"
            "Any order and directions; what hangs over the outermost curves is cut off. Where curves are not at the same\n"
            "parameters at all crossings, or their weights cannot be made one there, they are run through at another pace, as\n"
            "polynomials within half the tolerance, a length, by default 2^-20 of the size; otherwise nothing is rounded, and\n"
            "curves of a patch give it back where they are as many as its control points in one direction. If all curves of\n"
            "a direction are closed, the surface is. InvalidShape names curves that do not meet once or in the order of the\n"
            "others, and says how near they come; ToleranceNotReached.");
}

}  // namespace bindings
