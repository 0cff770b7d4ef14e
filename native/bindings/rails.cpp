#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rail_numbers.hpp"
#include "rooms.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/surface/pipe.hpp"
#include "splinecore/surface/sweep.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::PipeCaps;
using splinecore::RailFrame;
using splinecore::RailNumber;
using splinecore::RailSection;
using splinecore::SweepOptions;
using splinecore::TwoRailOptions;

namespace {

/// One curve, or several with the parameters of the rail to which they belong: even ones, the last at its end, if that is not
/// its start.
std::vector<RailSection> sections_of(const py::object& value, const py::object& at, const NurbsCurve& rail) {
  const bool are_many = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  const std::vector<NurbsCurve> curves =
      are_many ? any_curves(value, "sections") : std::vector<NurbsCurve>{any_curve(value, "sections")};
  std::vector<double> places = optional_numbers(at, "at");
  if (places.empty()) {
    const splinecore::Interval domain = rail.domain();
    const bool goes_round = rail.periodic() || is_closed(rail);
    const std::size_t steps = goes_round ? curves.size() : std::max<std::size_t>(curves.size(), 2) - 1;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      places.push_back(i == steps ? domain.end : domain.start + domain.length() * static_cast<double>(i) / static_cast<double>(steps));
    }
  }
  if (places.size() != curves.size()) {
    throw InvalidShape("at has " + std::to_string(places.size()) + " parameters for " + std::to_string(curves.size()) + " sections");
  }
  std::vector<RailSection> sections;
  for (std::size_t i = 0; i < curves.size(); ++i) sections.push_back({curves[i], places[i]});
  return sections;
}

/// A factor along a rail: a curve of any kind, of which x counts.
std::optional<NurbsCurve> scale_of(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return any_curve(value, "scale");
}

void bind_two_rails(py::module_& build) {
  build.def("sweep_two_rails", [](const py::object& rail, const py::object& second, const py::object& sections, const py::object& at,
                                  const py::object& height, const py::object& up, const py::object& tolerance,
                                  const py::object& cancel) {
              const NurbsCurve& along = any_curve(rail, "rail");
              const NurbsCurve& other = any_curve(second, "second");
              const std::vector<RailSection> given = sections_of(sections, at, along);
              TwoRailOptions options;
              options.is_height_scaled = chosen<bool>(height, "height", {{"scaled", true}, {"kept", false}});
              if (!up.is_none()) options.up = vector_of(up, "up");
              options.tolerance = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::sweep(along, other, given, options); }, cancel));
            }, py::arg("rail"), py::arg("second"), py::arg("sections"), py::kw_only(), py::arg("at") = py::none(),
            py::arg("height") = "scaled", py::arg("up") = py::none(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none(),
            "The surface of a section between two rails, run through at equal parts of their domains, so that both are to run the\n"
            "same way; of several sections at the parameters `at` of the first one, by default even ones: (value, error) as of\n"
            "sweep(), u along the sections, v by the parameter of the first rail (row S20).\n\n"
            "Sections are given with x from the first rail to the second one, and stretched along it so that they stay between\n"
            "both; their height, along y and z, is 'scaled' with it or 'kept'. y stays near `up` (3,), or is at right angles to\n"
            "the rails. What a section passes by a rail is in the error. tolerance, a length: by default 2^-20 of the size of the\n"
            "rails.\n"
            "InvalidShape as sweep(), or if a section touches neither rail, the rails meet, have corners and there is no `up`, run from one to the other\n"
            "or against each other; ToleranceNotReached.");
}

void bind_pipe(py::module_& build) {
  build.def("pipe", [](const py::object& axis, const py::object& radius, const py::object& caps, const py::object& tolerance,
                       const py::object& scale, const py::object& cancel) {
              const NurbsCurve& about = any_curve(axis, "axis");
              const std::vector<RailNumber> radii = radii_of(radius, "radius", about.domain());
              const auto ends = chosen<PipeCaps>(caps, "caps", {{"none", PipeCaps::none}, {"flat", PipeCaps::flat}, {"round", PipeCaps::round}});
              const std::optional<double> within = tolerance_of(tolerance);
              const std::optional<NurbsCurve> factor = scale_of(scale);
              return wrap(unlocked([&] { return splinecore::pipe(about, radii, ends, within, factor); }, cancel));
            }, py::arg("axis"), py::arg("radius"), py::kw_only(), py::arg("caps") = "none", py::arg("tolerance") = py::none(),
            py::arg("scale") = py::none(), py::arg("cancel") = py::none(),
            "A pipe about a curve of any kind: (value, error), a list of NurbsPatch with normals outwards, the mantle and then the\n"
            "caps at its start and end, and how far rows of the mantle were found to be from where they should be (row S20).\n\n"
            "radius is a number, or (n, 2): parameters of the curve, which increase, and radii there, between which it goes without\n"
            "overshoot, times what x of the curve `scale` is at the parameters of the axis. caps: 'none', 'flat' or 'round', exact;\n"
            "a closed curve has none. tolerance, a length: by default 2^-20 of the size of the curve.\n"
            "InvalidShape if a radius is not above 0, and as sweep(); ToleranceNotReached.");
}

}  // namespace

void bind_rails(py::module_& module) {
  py::module_ build = module.attr("build");
  build.def("sweep", [](const py::object& rail, const py::object& sections, const py::object& at, const py::object& frame,
                        const py::object& up, const py::object& start, const py::object& end_scale, const py::object& scales,
                        const py::object& twist, const py::object& tolerance, const py::object& scale,
                        const py::object& cancel) {
              const NurbsCurve& along = any_curve(rail, "rail");
              const std::vector<RailSection> given = sections_of(sections, at, along);
              SweepOptions options;
              options.frame = chosen<RailFrame>(frame, "frame", {{"minimal", RailFrame::minimal},
                                                                 {"upright", RailFrame::upright},
                                                                 {"parallel", RailFrame::parallel}});
              options.up = vector_of(up, "up");
              if (!start.is_none()) options.start = vector_of(start, "start");
              options.end_scale = real(end_scale, "end_scale");
              options.scales = numbers_along(scales, "scales");
              options.scale = scale_of(scale);
              options.twist = real(twist, "twist");
              options.tolerance = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::sweep(along, given, options); }, cancel));
            }, py::arg("rail"), py::arg("sections"), py::kw_only(), py::arg("at") = py::none(), py::arg("frame") = "minimal",
            py::arg("up") = py::make_tuple(0.0, 0.0, 1.0), py::arg("start") = py::none(), py::arg("end_scale") = 1.0,
            py::arg("scales") = py::none(), py::arg("twist") = 0.0, py::arg("tolerance") = py::none(), py::arg("scale") = py::none(),
            py::arg("cancel") = py::none(),
            "The surface of a section that moves along a rail, curves of any kinds; of several sections at the parameters `at`\n"
            "of the rail, by default even ones: (value, error), a NurbsPatch with u along the sections and v along the rail,\n"
            "and how far rows of control points were found to be from where they should be (The NURBS Book, 10.4; row S20).\n\n"
            "Sections are given in the frame of the rail: x along its normal, y along its binormal, z along its tangent. frame:\n"
            "'minimal' turns about the rail no more than it must, x being `start` (3,) at first; of 'upright' y stays as near to\n"
            "`up` (3,) as it can; 'parallel' does not turn. Sections grow up to end_scale, and turn by twist, in radians, evenly\n"
            "by the length of the rail; scales (n, 2), parameters of the rail and factors, make them grow without overshoot,\n"
            "and `scale`, a curve over the domain of the rail, by what its x is there. Exact if parallel or the rail is straight, otherwise within the tolerance, a length, by\n"
            "default 2^-20 of the size of the rail. Corners between straight stretches are mitered.\n"
            "InvalidShape if there is no section, `at` does not increase or leaves the rail, the rail runs along `up`, turns\n"
            "back, or has a corner beside a curved stretch, or a scale has another domain, jumps or has a point that is not above\n"
            "0; ToleranceNotReached.");
  bind_two_rails(build);
  bind_pipe(build);
}

}  // namespace bindings
