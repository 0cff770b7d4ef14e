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
            }, py::arg("points"), py::arg("parameters") = py::none());
  build.def("osculating_polynomial", [](const py::object& data, const py::object& parameters) {
              const auto places = osculations_of(data, parameters);
              return unlocked([&] { return splinecore::osculating_polynomial(places); });
            }, py::arg("data"), py::arg("parameters"));
  build.def("lagrange_evaluate", &lagrange_evaluate, py::arg("points"), py::arg("u"), py::arg("parameters") = py::none());
}

void bind_cardinal(py::module_& build) {
  build.def("catmull_rom", [](const py::object& points, const py::object& parameterization, const py::object& tension,
                              const py::object& closed, const py::object& ends) {
              return kochanek_bartels(points, tension, py::float_(0.0), py::float_(0.0), parameterization, closed, ends);
            },
            py::arg("points"), py::arg("parameterization") = "uniform", py::arg("tension") = 0.0,
            py::arg("closed") = false, py::arg("ends") = "parabola");
  build.def("kochanek_bartels", &kochanek_bartels, py::arg("points"), py::arg("tension") = 0.0,
            py::arg("continuity") = 0.0, py::arg("bias") = 0.0, py::arg("parameterization") = "uniform",
            py::arg("closed") = false, py::arg("ends") = "parabola");
}

void bind_chains(py::module_& build) {
  build.def("chain_from_polygon", [](const py::object& points, const py::object& parameters) {
              const std::vector<glm::dvec3> rows = points_of(points);
              const std::vector<double> at = optional_numbers(parameters, "parameters");
              return unlocked([&] { return splinecore::chain_from_polygon(rows, at); });
            }, py::arg("points"), py::arg("parameters") = py::none());
  build.def("polygon_of_chain", [](const py::object& chain, const py::object& lengths, const py::object& tolerance) {
              const std::optional<double> allowed = optional_real(tolerance, "tolerance");
              const std::vector<BezierCurve> curves = beziers_of(chain, "chain");
              const std::vector<double> steps = optional_numbers(lengths, "lengths");
              return array_of_vectors(unlocked([&] { return splinecore::polygon_of_chain(curves, steps, allowed); }));
            }, py::arg("chain"), py::arg("lengths") = py::none(), py::arg("tolerance") = py::none());
  build.def("join_beziers", [](const py::object& curves, const py::object& parameters, const py::object& tolerance) {
              const std::vector<BezierCurve> chain = beziers_of(curves, "curves");
              const std::vector<double> at = optional_numbers(parameters, "parameters");
              const double most = real(tolerance, "tolerance");
              return unlocked([&] { return splinecore::join_beziers(chain, at, most); });
            }, py::arg("curves"), py::arg("parameters") = py::none(), py::arg("tolerance") = 0.0);
  build.def("c2_pair", [](const py::object& q0, const py::object& q1, const py::object& d, const py::object& r2,
                          const py::object& r3, const py::object& a, const py::object& b) {
              return splinecore::c2_pair(place_of(q0, "q0"), place_of(q1, "q1"), place_of(d, "d"), place_of(r2, "r2"),
                                         place_of(r3, "r3"), real(a, "a"), real(b, "b"));
            }, py::arg("q0"), py::arg("q1"), py::arg("d"), py::arg("r2"), py::arg("r3"), py::arg("a") = 1.0,
            py::arg("b") = 1.0);
}

}  // namespace

void bind_build(py::module_& module) {
  py::module_ build = module.def_submodule("build", "Curves from points: polynomials, cardinal splines, chains.");
  bind_polynomials(build);
  bind_cardinal(build);
  bind_chains(build);
}

}  // namespace bindings
