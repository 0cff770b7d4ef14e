#include "point_arguments.hpp"

#include "splinecore/basis/hermite.hpp"

namespace bindings {

using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::Parametrisation;

std::vector<glm::dvec3> points_of(const py::object& points) {
  return vectors(real_array(points, "points"), "points", 1);
}

Parametrisation parametrisation_of(const py::object& value, const char* name) {
  return chosen<Parametrisation>(value, name, {{"uniform", Parametrisation::uniform},
                                               {"centripetal", Parametrisation::centripetal},
                                               {"chordal", Parametrisation::chordal}});
}

std::vector<double> parameters_of(const std::vector<glm::dvec3>& points, const py::object& parametrisation,
                                  splinecore::Closing closing, const char* name) {
  if (py::isinstance<py::str>(parametrisation)) {
    return splinecore::parameters_of(points, parametrisation_of(parametrisation, name), closing);
  }
  std::vector<double> given = numbers(parametrisation, name);
  if (given.empty()) throw InvalidShape(std::string(name) + " has 0 values");
  return splinecore::hermite_parameters(std::move(given), points.size() + (closing == Closing::closed ? 1 : 0), name);
}

}  // namespace bindings
