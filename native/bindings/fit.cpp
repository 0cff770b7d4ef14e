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

FitEnds ends_of(const py::object& value) {
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
  options.ends = ends_of(ends);
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
    made.ends = ends_of(GridArguments::of(end, axis));
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
          py::arg("end") = py::none(), py::arg("tangents") = py::none(), py::arg("closed") = false,
          "The polynomial NurbsCurve through points (n, 2 or 3), in time linear in n, as an Approximation: its error is\n"
          "the largest distance from a point that rounding left. Lecture row S17.\n\n"
          "parameters: 'calm', steps with which the curve stays near its points however uneven their distances are: the\n"
          "roots of the distances up to degree 3 (Lee 1989), fourth roots of degree 4, eighth roots of degree 5, equal ones\n"
          "above, all in such proportion that they end at the length of the polygon. Unless knots, derivatives or other ends are\n"
          "given the curve keeps nearer to the chord between two points than the longest chord is long, of which each counts\n"
          "three quarters as much for every point that it is farther away; one that does not gets even steps and, if open,\n"
          "even knots, with steps that are shorter towards the ends (Demko 1985);\n"
          "'uniform', 'centripetal', 'chordal' or increasing ones, for each point and if closed one more.\n"
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
  fit.def("interpolate_patch", &interpolate_patch, py::arg("points"), py::arg("degrees") = 3,
          py::arg("parameters") = "calm", py::arg("knots") = py::none(), py::arg("ends") = "averaged",
          py::arg("closed") = false, py::kw_only(), py::arg("cancel") = py::none(),
          "The polynomial NurbsPatch through a grid of points (nu, nv, 2 or 3), as an Approximation: its error is the\n"
          "largest distance from a point that rounding left. In time linear in the points, by one banded system a\n"
          "direction (The NURBS Book, §9.2.5). Lecture rows S17, S20.\n\n"
          "Every other argument is one value for both directions or a pair, for u and v, of what interpolate() takes.\n"
          "parameters: 'calm', by those points of two rows that lie farthest apart, steps of fourth roots up to degree 3,\n"
          "16th roots of degree 4, 64th roots of degree 5, equal ones above, or others where the patch would leave its points\n"
          "by more than three sides of the cells, as of interpolate(); 'uniform'; or 'centripetal' or\n"
          "'chordal', whose shares are averaged over the rows that are not\n"
          "a single point and end at their mean length (A9.3), or increasing numbers for each row, (nu,) and (nv,), and\n"
          "where closed one more. knots, ends, closed: as of interpolate(); None chooses knots by ends.\n\n"
          "cancel: a callable without arguments that ends the call by returning true.\n\n"
          "Raises InvalidShape with fewer rows than the degree needs, where a coordinate is not finite, where all\n"
          "points of two neighboring rows coincide and their distance is the step of the parameter, and for knots that\n"
          "have too many rows between them; the message names the direction or the point by both indices.");
}

}  // namespace bindings
