#include "point_arguments.hpp"

#include "splinecore/basis/hermite.hpp"

namespace bindings {

using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::Parameterization;

std::vector<glm::dvec3> points_of(const py::object& points) {
  return vectors(real_array(points, "points"), "points", 1);
}

GivenPoints::GivenPoints(const py::object& value, const char* name, int dimensions) : array_(real_array(value, name)) {
  static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
  if (array_.ndim() == dimensions + 1 && array_.shape(dimensions) == 3) {
    points_ = {reinterpret_cast<const glm::dvec3*>(array_.data()), static_cast<std::size_t>(array_.size() / 3)};
    return;
  }
  copies_ = vectors(array_, name, dimensions);
  points_ = copies_;
}

Parameterization parameterization_of(const py::object& value, const char* name) {
  return chosen<Parameterization>(value, name, {{"centripetal", Parameterization::centripetal},
                                               {"chordal", Parameterization::chordal},
                                               {"uniform", Parameterization::uniform}});
}

std::vector<double> parameters_of(std::span<const glm::dvec3> points, const py::object& parameterization,
                                  splinecore::Closing closing, const char* name) {
  if (py::isinstance<py::str>(parameterization)) {
    return splinecore::parameters_of(points, parameterization_of(parameterization, name), closing);
  }
  std::vector<double> given = numbers(parameterization, name);
  if (given.empty()) throw InvalidShape(std::string(name) + " has 0 values");
  return splinecore::hermite_parameters(std::move(given), points.size() + (closing == Closing::closed ? 1 : 0), name);
}

std::vector<glm::dvec3> derivatives_of(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  const Doubles given = real_array(value, name);
  if (given.size() == 0) return {};
  return vectors(given, name, given.ndim() == 1 ? 0 : 1);
}

std::pair<py::object, py::object> both(const py::object& value, const char* name, const char* of) {
  const bool is_sequence = PySequence_Check(value.ptr()) != 0 && !py::isinstance<py::str>(value);
  return is_sequence ? pair_argument(value, name, of) : std::pair(value, value);
}

}  // namespace bindings
