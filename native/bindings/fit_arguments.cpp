#include "fit_arguments.hpp"

#include <cmath>
#include <string>

#include "arguments.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::Parameterization;
using splinecore::PointGrid;

std::size_t count_of(const py::object& value, const char* name) {
  const int count = integer(value, name);
  if (count < 1) throw InvalidShape(std::string(name) + " = " + std::to_string(count) + " is not above 0");
  return static_cast<std::size_t>(count);
}

/// A number above 0; None for none.
std::optional<double> positive(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  const double number = real(value, name);
  if (number > 0.0 && std::isfinite(number)) return number;
  throw InvalidShape(std::string(name) + " = " + splinecore::text_of(number) + " is not a positive number");
}

namespace {

/// None of 'calm'.
std::optional<Parameterization> kind_of(const py::object& word) {
  using Kind = std::optional<Parameterization>;
  return chosen<Kind>(word, "parameters", {{"calm", Kind()}, {"centripetal", Kind(Parameterization::centripetal)},
                                           {"chordal", Kind(Parameterization::chordal)},
                                           {"uniform", Kind(Parameterization::uniform)}});
}

}  // namespace

std::vector<double> curve_parameters(std::span<const glm::dvec3> points, const py::object& parameters, int degree,
                                     Closing closing) {
  if (!py::isinstance<py::str>(parameters)) return parameters_of(points, parameters, closing, "parameters");
  const auto kind = kind_of(parameters);
  return kind ? splinecore::parameters_of(points, *kind, closing) : splinecore::calm_parameters(points, degree, closing);
}

std::vector<double> grid_parameters(const PointGrid& grid, const py::object& parameters, Axis axis, int degree,
                                    Closing closing) {
  if (parameters.is_none()) return {};
  if (!py::isinstance<py::str>(parameters)) return numbers(parameters, "parameters");
  const auto kind = kind_of(parameters);
  return unlocked([&] {
    return kind ? splinecore::parameters_of(grid, axis, *kind, closing)
                : splinecore::calm_parameters(grid, axis, degree, closing);
  });
}

GridArguments::GridArguments(const PointGrid& grid, const py::object& degrees, const py::object& parameters,
                             const py::object& knots, const py::object& closed)
    : grid_(grid), degrees_(both(degrees, "degrees")), parameters_(both(parameters, "parameters")),
      knots_(both(knots, "knots")), closed_(both(closed, "closed")) {}

}  // namespace bindings
