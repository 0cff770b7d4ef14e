#include <optional>
#include <string>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/surface/sweep.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::RailFrame;
using splinecore::RailSection;
using splinecore::SweepOptions;

namespace {

/// One curve, or several with the parameters of the rail to which they belong.
std::vector<RailSection> sections_of(const py::object& value, const py::object& at, const NurbsCurve& rail) {
  const bool are_many = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  const std::vector<NurbsCurve> curves =
      are_many ? any_curves(value, "sections") : std::vector<NurbsCurve>{any_curve(value, "sections")};
  std::vector<double> places = optional_numbers(at, "at");
  if (places.empty()) {
    const splinecore::Interval domain = rail.domain();
    const auto steps = static_cast<double>(curves.size() < 2 ? 1 : curves.size() - 1);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      places.push_back(i > 0 && i + 1 == curves.size() ? domain.end
                                                       : domain.start + domain.length() * static_cast<double>(i) / steps);
    }
  }
  if (places.size() != curves.size()) {
    throw InvalidShape("at has " + std::to_string(places.size()) + " parameters for " + std::to_string(curves.size()) + " sections");
  }
  std::vector<RailSection> sections;
  for (std::size_t i = 0; i < curves.size(); ++i) sections.push_back({curves[i], places[i]});
  return sections;
}

}  // namespace

void bind_rails(py::module_& module) {
  py::module_ build = module.attr("build");
  build.def("sweep", [](const py::object& rail, const py::object& sections, const py::object& at, const py::object& frame,
                        const py::object& up, const py::object& start, const py::object& end_scale, const py::object& twist,
                        const py::object& tolerance, const py::object& cancel) {
              const NurbsCurve& along = any_curve(rail, "rail");
              const std::vector<RailSection> given = sections_of(sections, at, along);
              SweepOptions options;
              options.frame = chosen<RailFrame>(frame, "frame", {{"minimal", RailFrame::minimal},
                                                                 {"upright", RailFrame::upright},
                                                                 {"parallel", RailFrame::parallel}});
              options.up = vector_of(up, "up");
              if (!start.is_none()) options.start = vector_of(start, "start");
              options.end_scale = real(end_scale, "end_scale");
              options.twist = real(twist, "twist");
              options.tolerance = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::sweep(along, given, options); }, cancel));
            }, py::arg("rail"), py::arg("sections"), py::kw_only(), py::arg("at") = py::none(), py::arg("frame") = "minimal",
            py::arg("up") = py::make_tuple(0.0, 0.0, 1.0), py::arg("start") = py::none(), py::arg("end_scale") = 1.0,
            py::arg("twist") = 0.0, py::arg("tolerance") = py::none(), py::arg("cancel") = py::none(),
            "The surface of a section that moves along a rail, curves of any kinds; of several sections at the parameters `at`\n"
            "of the rail, by default even ones: (value, error), a NurbsPatch with u along the sections and v along the rail,\n"
            "and how far rows of control points were found to be from where they should be (The NURBS Book, 10.4; row S20).\n\n"
            "Sections are given in the frame of the rail: x along its normal, y along its binormal, z along its tangent. frame:\n"
            "'minimal' turns about the rail no more than it must, x being `start` (3,) at first; of 'upright' y stays as near to\n"
            "`up` (3,) as it can; 'parallel' does not turn. Sections grow up to end_scale, and turn by twist, in radians, evenly\n"
            "by the length of the rail. Exact if parallel or the rail is straight, otherwise within the tolerance, a length, by\n"
            "default 2^-20 of the size of the rail. Corners between straight stretches are mitred.\n"
            "InvalidShape if there is no section, `at` does not increase or leaves the rail, the rail runs along `up`, turns\n"
            "back, or has a corner beside a curved stretch; ToleranceNotReached.");
}

}  // namespace bindings
