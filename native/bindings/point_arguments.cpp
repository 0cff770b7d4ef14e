#include "point_arguments.hpp"

#include "splinecore/basis/hermite.hpp"

namespace bindings {

using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::Parametrisation;

std::vector<glm::dvec3> points_of(const py::object& points) {
  return vectors(real_array(points, "points"), "points", 1);
}

std::vector<double> parameters_of(const std::vector<glm::dvec3>& points, const py::object& parametrisation,
                                  splinecore::Closing closing, const char* name) {
  if (py::isinstance<py::str>(parametrisation)) {
    const auto kind = chosen<Parametrisation>(parametrisation, name, {{"uniform", Parametrisation::uniform},
                                                                       {"centripetal", Parametrisation::centripetal},
                                                                       {"chordal", Parametrisation::chordal}});
    return splinecore::parameters_of(points, kind, closing);
  }
  std::vector<double> given = numbers(parametrisation, name);
  if (given.empty()) throw InvalidShape(std::string(name) + " has 0 values");
  return splinecore::hermite_parameters(std::move(given), points.size() + (closing == Closing::closed ? 1 : 0), name);
}

}  // namespace bindings
