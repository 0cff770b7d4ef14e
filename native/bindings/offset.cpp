#include "splinecore/build/offset.hpp"

#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::NurbsCurve;
using splinecore::OffsetCorner;
using splinecore::OffsetOptions;

namespace {

void bind_curve(const CurveClasses& cls) {
  cls.def("offset", [](const AnyCurve& self, const py::object& distance, const py::object& normal, const py::object& tolerance,
                       const py::object& corner, const py::object& trimmed, const py::object& cancel) {
            OffsetOptions options{vector_of(normal, "normal"), {}, chosen<OffsetCorner>(corner, "corner", {{"round", OffsetCorner::round}, {"sharp", OffsetCorner::sharp}}), boolean(trimmed, "trimmed")};
            if (!tolerance.is_none()) options.tolerance = real(tolerance, "tolerance");
            const double by = real(distance, "distance");
            return unlocked([&] { return splinecore::offset(form(self), by, options); }, cancel);
          },
          py::arg("distance"), py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0), py::kw_only(),
          py::arg("tolerance") = py::none(), py::arg("corner") = "round", py::arg("trimmed") = false,
          py::arg("cancel") = py::none(),
          "The curve at a distance to the left of a plane curve, seen against the normal (3,), to the right where it is\n"
          "negative: a list of NurbsCurve, several where the curve has gaps or the offset is trimmed.\n\n"
          "Lines and arcs of circles are moved exactly; other spans become cubics with the tangents of the offset,\n"
          "halved until they are within the tolerance, a length, by default 2^-20 of the size (Tiller and Hanson 1984),\n"
          "with ends where it has cusps. At corners an arc ('round'), or the corner of both tangents ('sharp') up to four\n"
          "times the distance away. trimmed: where it crosses itself all parts stay that are nowhere nearer to the curve\n"
          "than the distance less the tolerance; what goes round ends where it begins, in every bit. Lecture row S18. cancel is a callable that ends a long call by returning True.\n"
          "InvalidShape if the curve is not in a plane with that normal, the distance is zero, or nothing is left.");
}

}  // namespace

void bind_offset(py::module_& module) {
  bind_curve(CurveClasses(module));
}

}  // namespace bindings
