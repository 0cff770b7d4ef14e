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
#include "splinecore/surface/rail_matrices.hpp"
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

RailFrame frame_of(const py::object& value) {
  return chosen<RailFrame>(value, "frame", {{"minimal", RailFrame::minimal},
                                            {"upright", RailFrame::upright},
                                            {"parallel", RailFrame::parallel}});
}

/// (…, 4, 4) of as many parameters, which map columns.
py::array_t<double> matrices_array(const std::vector<glm::dmat4>& matrices, const Doubles& at) {
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.insert(shape.end(), {4, 4});
  py::array_t<double> out(shape);
  double* entry = out.mutable_data();
  for (const glm::dmat4& matrix : matrices) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) *entry++ = matrix[column][row];
    }
  }
  return out;
}

/// Parameters of a rail. @throws InvalidShape if one lies outside.
std::span<const double> places_on(const NurbsCurve& rail, const Doubles& at) {
  require_inside(rail.knot_vector(), at, splinecore::Side::right, "at");
  return {at.data(), static_cast<std::size_t>(at.size())};
}

void bind_rail_frames(py::module_& build) {
  build.def("rail_frames", [](const py::object& rail, const py::object& at, const py::object& frame, const py::object& up,
                              const py::object& start, const py::object& cancel) {
              const NurbsCurve& along = any_curve(rail, "rail");
              const Doubles places = real_array(at, "at");
              SweepOptions options;
              options.frame = frame_of(frame);
              options.up = vector_of(up, "up");
              if (!start.is_none()) options.start = vector_of(start, "start");
              const std::span<const double> given = places_on(along, places);
              return matrices_array(unlocked([&] { return splinecore::rail_matrices(along, given, options); }, cancel), places);
            }, py::arg("rail"), py::arg("at"), py::kw_only(), py::arg("frame") = "minimal",
            py::arg("up") = py::make_tuple(0.0, 0.0, 1.0), py::arg("start") = py::none(), py::arg("cancel") = py::none());
  build.def("two_rail_frames", [](const py::object& rail, const py::object& second, const py::object& at, const py::object& up,
                                  const py::object& cancel) {
              const NurbsCurve& along = any_curve(rail, "rail");
              const NurbsCurve& other = any_curve(second, "second");
              const Doubles places = real_array(at, "at");
              TwoRailOptions options;
              if (!up.is_none()) options.up = vector_of(up, "up");
              const std::span<const double> given = places_on(along, places);
              return matrices_array(unlocked([&] { return splinecore::rail_matrices(along, other, given, options); }, cancel), places);
            }, py::arg("rail"), py::arg("second"), py::arg("at"), py::kw_only(), py::arg("up") = py::none(),
            py::arg("cancel") = py::none());
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
            py::arg("cancel") = py::none());
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
            py::arg("scale") = py::none(), py::arg("cancel") = py::none());
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
              options.frame = frame_of(frame);
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
            py::arg("cancel") = py::none());
  bind_two_rails(build);
  bind_rail_frames(build);
  bind_pipe(build);
}

}  // namespace bindings
