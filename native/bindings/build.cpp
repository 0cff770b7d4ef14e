#include <optional>

#include "arrays.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/basis/hermite.hpp"
#include "splinecore/build/cardinal.hpp"
#include "splinecore/build/chain.hpp"
#include "splinecore/build/join.hpp"
#include "splinecore/build/polynomial.hpp"

namespace bindings {

using splinecore::BezierCurve;
using splinecore::Closing;
using splinecore::EndTangent;
using splinecore::InvalidShape;
using splinecore::Shaping;

namespace {

/// One point of two or three numbers.
glm::dvec3 place_of(const py::object& value, const char* name) {
  const Doubles given = real_array(value, name);
  const bool is_place = given.ndim() == 1 && (given.size() == 2 || given.size() == 3);
  if (!is_place) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(given) +
                       ", one point of 2 or 3 numbers is expected");
  }
  return {given.data()[0], given.data()[1], given.size() == 3 ? given.data()[2] : 0.0};
}

EndTangent ends_of(const py::object& word) {
  return chosen<EndTangent>(word, "ends", {{"chord", EndTangent::chord}, {"natural", EndTangent::natural},
                                           {"parabola", EndTangent::parabola}});
}

/// One number for all points, or one for each.
void set_part(const py::object& value, const char* name, double Shaping::*part, std::vector<Shaping>& shaping) {
  const Doubles given = real_array(value, name);
  const bool single = given.ndim() == 0;
  if (!single && (given.ndim() != 1 || given.size() != static_cast<py::ssize_t>(shaping.size()))) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(given) + " for " +
                       std::to_string(shaping.size()) + " points");
  }
  for (std::size_t i = 0; i < shaping.size(); ++i) shaping[i].*part = given.data()[single ? 0 : i];
}

splinecore::HermiteCurve kochanek_bartels(const py::object& points, const py::object& tension,
                                          const py::object& continuity, const py::object& bias,
                                          const py::object& parameterization, const py::object& closed,
                                          const py::object& ends) {
  const std::vector<glm::dvec3> rows = points_of(points);
  std::vector<Shaping> shaping(rows.size());
  set_part(tension, "tension", &Shaping::tension, shaping);
  set_part(continuity, "continuity", &Shaping::continuity, shaping);
  set_part(bias, "bias", &Shaping::bias, shaping);
  const Closing closing = boolean(closed, "closed") ? Closing::closed : Closing::open;
  const EndTangent tangent = ends_of(ends);
  const std::vector<double> at = parameters_of(rows, parameterization, closing, "parameterization");
  return unlocked([&] { return splinecore::kochanek_bartels(rows, shaping, at, closing, tangent); });
}

std::vector<BezierCurve> beziers_of(const py::object& value, const char* name) {
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (!is_list) throw py::type_error(std::string(name) + " must be a list of BezierCurve, not " + type_name(value));
  std::vector<BezierCurve> curves;
  for (const py::handle& item : py::cast<py::sequence>(value)) {
    if (!py::isinstance<BezierCurve>(item)) {
      throw py::type_error(name + splinecore::index_text(curves.size()) + " must be a BezierCurve, not " +
                           type_name(item));
    }
    curves.push_back(py::cast<const BezierCurve&>(item));
  }
  return curves;
}

std::vector<splinecore::Osculation> osculations_of(const py::object& data, const py::object& parameters) {
  const std::vector<double> at = numbers(parameters, "parameters");
  const bool is_text = py::isinstance<py::str>(data) || py::isinstance<py::bytes>(data);
  const bool is_list = PySequence_Check(data.ptr()) != 0 && !is_text;
  if (!is_list) throw py::type_error("data must be a list of arrays, not " + type_name(data));
  const auto rows = py::reinterpret_borrow<py::sequence>(data);
  if (rows.size() != at.size()) {
    throw InvalidShape("data has " + std::to_string(rows.size()) + " rows for " + std::to_string(at.size()) +
                       " parameters");
  }
  std::vector<splinecore::Osculation> places;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::string name = "data" + splinecore::index_text(i);
    places.push_back({at[i], vectors(real_array(py::object(rows[i]), name.c_str()), name.c_str(), 1)});
  }
  return places;
}

py::array lagrange_evaluate(const py::object& points, const py::object& u, const py::object& parameters) {
  const std::vector<glm::dvec3> rows = points_of(points);
  const Doubles at = real_array(u, "u");
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(3);
  py::array_t<double> out(shape);
  auto* first = reinterpret_cast<glm::dvec3*>(out.mutable_data());
  const auto count = static_cast<std::size_t>(at.size());
  const std::vector<double> given = optional_numbers(parameters, "parameters");
  unlocked([&] { splinecore::lagrange_evaluate(rows, given, {at.data(), count}, {first, count}); });
  return out;
}

py::array array_of_vectors(const std::vector<glm::dvec3>& rows) {
  py::array_t<double> out({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
  std::copy_n(&rows.data()->x, 3 * rows.size(), out.mutable_data());
  return out;
}

void bind_polynomials(py::module_& build) {
  build.def("polynomial_through", [](const py::object& points, const py::object& parameters) {
              const std::vector<glm::dvec3> rows = points_of(points);
              const std::vector<double> at = optional_numbers(parameters, "parameters");
              return unlocked([&] { return splinecore::polynomial_through(rows, at); });
            }, py::arg("points"), py::arg("parameters") = py::none(),
            "The NurbsCurve of degree n - 1 that is one polynomial through points (n, 2 or 3) at increasing\n"
            "parameters (n,), by default equal steps from 0 to 1: Lagrange's. One span, to_bezier() of which is a\n"
            "BezierCurve, or more where one span's points would be so large that rounding hides the curve.\n"
            "n from 2 to 256. Between equal steps it oscillates (Runge 1901). Lecture row S3.");
  build.def("osculating_polynomial", [](const py::object& data, const py::object& parameters) {
              const auto places = osculations_of(data, parameters);
              return unlocked([&] { return splinecore::osculating_polynomial(places); });
            }, py::arg("data"), py::arg("parameters"),
            "The polynomial NurbsCurve with given derivatives: data[i] is an array (k, 2 or 3) of the point and its\n"
            "first k - 1 derivatives at parameters[i], each of a k of its own. Its degree is the number of all rows\n"
            "less one, 255 at most. Divided differences with repeated nodes, of 32 digits. Lecture row S3.");
  build.def("lagrange_evaluate", &lagrange_evaluate, py::arg("points"), py::arg("u"), py::arg("parameters") = py::none(),
            "Points of Lagrange's polynomial at parameters u (...,) of its domain -> (..., 3), without a curve.\n\n"
            "The barycentric form of Berrut and Trefethen (2004), stable for hundreds of points at Chebyshev's\n"
            "parameters; at a parameter of a point it is that point in every bit. Lecture row S3.");
}

void bind_cardinal(py::module_& build) {
  build.def("catmull_rom", [](const py::object& points, const py::object& parameterization, const py::object& tension,
                              const py::object& closed, const py::object& ends) {
              return kochanek_bartels(points, tension, py::float_(0.0), py::float_(0.0), parameterization, closed, ends);
            },
            py::arg("points"), py::arg("parameterization") = "uniform", py::arg("tension") = 0.0,
            py::arg("closed") = false, py::arg("ends") = "parabola",
            "The HermiteCurve through points (n, 2 or 3) whose tangents come from the neighbors, times 1 - tension:\n"
            "a cardinal spline, with tension 0 Catmull's and Rom's (1974). Lecture row S5.\n\n"
            "parameterization: 'uniform', 'centripetal', 'chordal' or increasing parameters, one for each point and\n"
            "if closed one more. ends: the tangent at an open end is that of the 'parabola' through three points,\n"
            "of the 'chord', or 'natural', without second derivative. A closed chain has its first point once more\n"
            "as the last. Points that coincide are refused where their distance is the step of the parameter.");
  build.def("kochanek_bartels", &kochanek_bartels, py::arg("points"), py::arg("tension") = 0.0,
            py::arg("continuity") = 0.0, py::arg("bias") = 0.0, py::arg("parameterization") = "uniform",
            py::arg("closed") = false, py::arg("ends") = "parabola",
            "catmull_rom() with a tension, a continuity and a bias, each one number or one for each point (n,):\n"
            "incoming and outgoing tangents of Kochanek and Bartels (1984). With a continuity other than 0 the\n"
            "chain has corners. On unequal steps the two chords are weighted as catmull_rom() weights them. Row S5.");
}

void bind_chains(py::module_& build) {
  build.def("chain_from_polygon", [](const py::object& points, const py::object& parameters) {
              const std::vector<glm::dvec3> rows = points_of(points);
              const std::vector<double> at = optional_numbers(parameters, "parameters");
              return unlocked([&] { return splinecore::chain_from_polygon(rows, at); });
            }, py::arg("points"), py::arg("parameters") = py::none(),
            "The m cubic BezierCurves of the C2 chain of a polygon (m + 3, 2 or 3) on increasing parameters (m + 1,),\n"
            "by default 0, 1, 2, …: the cubic B-spline with fourfold ends. Lecture row S8.");
  build.def("polygon_of_chain", [](const py::object& chain, const py::object& lengths, const py::object& tolerance) {
              const std::optional<double> allowed = optional_real(tolerance, "tolerance");
              const std::vector<BezierCurve> curves = beziers_of(chain, "chain");
              const std::vector<double> steps = optional_numbers(lengths, "lengths");
              return array_of_vectors(unlocked([&] { return splinecore::polygon_of_chain(curves, steps, allowed); }));
            }, py::arg("chain"), py::arg("lengths") = py::none(), py::arg("tolerance") = py::none(),
            "The polygon (m + 3, 3) of m cubic BezierCurves on intervals of these lengths (m,), by default 1.\n\n"
            "Raises InvalidShape with the number of a joint that is not C2 within the tolerance, by default that of\n"
            "rounding. Lecture row S8.");
  build.def("join_beziers", [](const py::object& curves, const py::object& parameters, const py::object& tolerance) {
              const std::vector<BezierCurve> chain = beziers_of(curves, "curves");
              const std::vector<double> at = optional_numbers(parameters, "parameters");
              const double most = real(tolerance, "tolerance");
              return unlocked([&] { return splinecore::join_beziers(chain, at, most); });
            }, py::arg("curves"), py::arg("parameters") = py::none(), py::arg("tolerance") = 0.0,
            "BezierCurves of any degrees one after the other as one NurbsCurve on increasing parameters, one more\n"
            "than curves, by default 0, 1, 2, …\n\n"
            "All are raised to the highest degree, and inner parameters are knots of that multiplicity, so that\n"
            "every segment is kept exactly. An end may lie tolerance from the next start, by default not at all:\n"
            "InvalidShape has the number of the joint. Lecture row S7.");
  build.def("c2_pair", [](const py::object& q0, const py::object& q1, const py::object& d, const py::object& r2,
                          const py::object& r3, const py::object& a, const py::object& b) {
              return splinecore::c2_pair(place_of(q0, "q0"), place_of(q1, "q1"), place_of(d, "d"), place_of(r2, "r2"),
                                         place_of(r3, "r3"), real(a, "a"), real(b, "b"));
            }, py::arg("q0"), py::arg("q1"), py::arg("d"), py::arg("r2"), py::arg("r3"), py::arg("a") = 1.0,
            py::arg("b") = 1.0,
            "(q, r): the two cubic BezierCurves that meet with C2 continuity on intervals of lengths a and b, from\n"
            "the first two points of q, the last two of r, and the point d where their inner legs meet. Row S7.");
}

}  // namespace

void bind_build(py::module_& module) {
  py::module_ build = module.def_submodule("build", "Curves from points: polynomials, cardinal splines, chains.");
  bind_polynomials(build);
  bind_cardinal(build);
  bind_chains(build);
}

}  // namespace bindings
