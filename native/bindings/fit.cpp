#include "splinecore/fit/interpolate.hpp"

#include <cmath>
#include <string>

#include "approximation.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"

namespace bindings {

using splinecore::Closing;
using splinecore::FitEnds;
using splinecore::InterpolationOptions;
using splinecore::InvalidShape;

namespace {

/// Derivatives 1, 2, … at an end; one vector is the first.
std::vector<glm::dvec3> derivatives_of(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  const Doubles given = real_array(value, name);
  if (given.size() == 0) return {};
  return vectors(given, name, given.ndim() == 1 ? 0 : 1);
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

AnyApproximation interpolate(const py::object& points, const py::object& degree, const py::object& parameters,
                             const py::object& knots, const py::object& ends, const py::object& start,
                             const py::object& end, const py::object& tangents, const py::object& closed) {
  const std::vector<glm::dvec3> rows = points_of(points);
  InterpolationOptions options;
  options.degree = integer(degree, "degree");
  options.closing = boolean(closed, "closed") ? Closing::closed : Closing::open;
  options.ends = chosen<FitEnds>(ends, "ends", {{"averaged", FitEnds::averaged}, {"natural", FitEnds::natural},
                                                {"not_a_knot", FitEnds::not_a_knot}});
  options.start = derivatives_of(start, "start");
  options.end = derivatives_of(end, "end");
  options.tangents = tangents_of(tangents, rows.size());
  options.knots = optional_numbers(knots, "knots");
  const std::vector<double> at = parameters_of(rows, parameters, options.closing, "parameters");
  return wrap(unlocked([&] { return splinecore::interpolate(rows, at, options); }));
}

}  // namespace

void bind_fit(py::module_& module) {
  py::module_ fit = module.def_submodule("fit", "Curves through points.");
  fit.def("interpolate", &interpolate, py::arg("points"), py::arg("degree") = 3, py::arg("parameters") = "chordal",
          py::arg("knots") = py::none(), py::arg("ends") = "averaged", py::arg("start") = py::none(),
          py::arg("end") = py::none(), py::arg("tangents") = py::none(), py::arg("closed") = false,
          "The polynomial NurbsCurve through points (n, 2 or 3), in time linear in n, as an Approximation: its error is\n"
          "the largest distance from a point that rounding left. Lecture row S17.\n\n"
          "parameters: 'uniform', 'centripetal', 'chordal' or increasing ones, for each point and if closed one more.\n"
          "knots: all of them, where closed one period; else they are chosen by ends: 'averaged', averages of degree\n"
          "parameters each (The NURBS Book, eq. 9.8); 'not_a_knot', at the points but for those next to the ends;\n"
          "'natural', at the points, with derivatives (degree + 1)/2 … degree - 1 zero at both ends, of odd degrees.\n"
          "A closed curve is periodic, with knots at the points, of even degrees half-way between.\n\n"
          "start, end: derivatives 1, 2, … by the parameter at the ends (k, 2 or 3), or the first alone (2 or 3,). With\n"
          "(degree - 1)/2 at each end of a curve of odd degree its knots lie at the points. tangents (n, 2 or 3): first\n"
          "derivatives at points, rows of NaN where there is none. Where derivatives are given a parameter counts once\n"
          "for each when knots are averaged.\n\n"
          "Raises InvalidShape with fewer points than the degree needs, where points coincide and their distance is the\n"
          "step of the parameter, and for knots that have too many points between them (Schoenberg and Whitney 1953).");
}

}  // namespace bindings
