#include "splinecore/fit/interpolate_patch.hpp"

#include <cmath>
#include <string>

#include "approximation.hpp"
#include "fit_arguments.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::Closing;
using splinecore::FitDirection;
using splinecore::FitEnds;
using splinecore::InterpolationOptions;
using splinecore::InvalidShape;
using splinecore::PointGrid;

namespace {

FitEnds fit_ends(const py::object& value) {
  return chosen<FitEnds>(value, "ends", {{"averaged", FitEnds::averaged}, {"natural", FitEnds::natural},
                                         {"not_a_knot", FitEnds::not_a_knot}});
}

/// Rows of NaN stand for none.
std::vector<splinecore::PointTangent> tangents_of(const py::object& value, std::size_t count) {
  if (value.is_none()) return {};
  const Doubles given = real_array(value, "tangents");
  const std::vector<glm::dvec3> rows = vectors(given, "tangents", 1);
  if (rows.size() != count) {
    throw InvalidShape("tangents has " + std::to_string(rows.size()) + " rows for " + std::to_string(count) +
                       " points");
  }
  std::vector<splinecore::PointTangent> tangents;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_none = std::isnan(rows[i].x) && std::isnan(rows[i].y) && (given.shape(1) == 2 || std::isnan(rows[i].z));
    if (!is_none) tangents.push_back({i, rows[i]});
  }
  return tangents;
}

bool is_calm(const py::object& parameters) {
  return py::isinstance<py::str>(parameters) && py::cast<std::string>(parameters) == "calm";
}

AnyApproximation interpolate(const py::object& points, const py::object& degree, const py::object& parameters,
                             const py::object& knots, const py::object& ends, const py::object& start,
                             const py::object& end, const py::object& tangents, const py::object& closed) {
  const GivenPoints given(points, "points", 1);
  const std::span<const glm::dvec3> rows = given.points();
  InterpolationOptions options;
  options.degree = integer(degree, "degree");
  options.closing = boolean(closed, "closed") ? Closing::closed : Closing::open;
  options.ends = fit_ends(ends);
  options.start = derivatives_of(start, "start");
  options.end = derivatives_of(end, "end");
  options.tangents = tangents_of(tangents, rows.size());
  options.knots = optional_numbers(knots, "knots");
  if (is_calm(parameters)) return wrap(unlocked([&] { return splinecore::interpolate_calmly(rows, options); }));
  const std::vector<double> at = curve_parameters(rows, parameters, options.degree, options.closing);
  return wrap(unlocked([&] { return splinecore::interpolate(rows, at, options); }));
}

AnyApproximation interpolate_patch(const py::object& points, const py::object& degrees, const py::object& parameters,
                                   const py::object& knots, const py::object& ends, const py::object& closed,
                                   const py::object& cancel) {
  const GivenPoints given(points, "points", 2);
  const PointGrid grid{given.points(), given.count(0), given.count(1)};
  const GridArguments given_both(grid, degrees, parameters, knots, closed);
  const auto end = both(ends, "ends");
  const auto both_parameters = both(parameters, "parameters");
  const auto direction = [&](Axis axis) {
    auto made = given_both.direction<FitDirection>(axis);
    made.ends = fit_ends(GridArguments::of(end, axis));
    if (is_calm(GridArguments::of(both_parameters, axis))) made.parameters.clear();
    return made;
  };
  const FitDirection u = direction(Axis::u);
  const FitDirection v = direction(Axis::v);
  return wrap(unlocked([&] { return splinecore::interpolate_calmly(grid, u, v); }, cancel));
}

}  // namespace

void bind_fit(py::module_& module) {
  py::module_ fit = module.def_submodule("fit", "Curves and patches through points.");
  fit.def("interpolate", &interpolate, py::arg("points"), py::arg("degree") = 3, py::arg("parameters") = "calm",
          py::arg("knots") = py::none(), py::arg("ends") = "averaged", py::arg("start") = py::none(),
          py::arg("end") = py::none(), py::arg("tangents") = py::none(), py::arg("closed") = false);
  fit.def("interpolate_patch", &interpolate_patch, py::arg("points"), py::arg("degrees") = 3,
          py::arg("parameters") = "calm", py::arg("knots") = py::none(), py::arg("ends") = "averaged",
          py::arg("closed") = false, py::kw_only(), py::arg("cancel") = py::none());
}

}  // namespace bindings
