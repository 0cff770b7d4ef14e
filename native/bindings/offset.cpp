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

void bind_offsets(const CurveClasses& cls) {
  cls.def("offset", [](const AnyCurve& self, const py::object& distance, const py::object& normal, const py::object& tolerance,
                       const py::object& corner, const py::object& trimmed, const py::object& cancel) {
            OffsetOptions options{vector_of(normal, "normal"), {}, chosen<OffsetCorner>(corner, "corner", {{"round", OffsetCorner::round}, {"sharp", OffsetCorner::sharp}}), boolean(trimmed, "trimmed")};
            if (!tolerance.is_none()) options.tolerance = real(tolerance, "tolerance");
            const double by = real(distance, "distance");
            return unlocked([&] { return splinecore::offset(form(self), by, options); }, cancel);
          },
          py::arg("distance"), py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0), py::kw_only(),
          py::arg("tolerance") = py::none(), py::arg("corner") = "round", py::arg("trimmed") = false,
          py::arg("cancel") = py::none());
}

}  // namespace

void bind_offset(py::module_& module) {
  bind_offsets(CurveClasses(module));
}

}  // namespace bindings
