#include "arguments.hpp"

#include <cmath>

#include "arrays.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::Border;
using splinecore::InvalidShape;

std::optional<double> tolerance_of(const py::object& value, const char* name) {
  const std::optional<double> tolerance = optional_real(value, name);
  if (!tolerance || *tolerance >= 0.0) return tolerance;
  throw InvalidShape(name + (" = " + splinecore::text_of(*tolerance)) + " is below 0");
}

splinecore::Interval interval_of(const py::object& value, const char* name) {
  const std::vector<double> ends = numbers(value, name);
  if (ends.size() == 2) return {ends[0], ends[1]};
  throw InvalidShape(std::string(name) + " has " + std::to_string(ends.size()) + " values, (start, end) is expected");
}

glm::dmat4 matrix_of(const py::object& value) {
  const Doubles array = real_array(value, "matrix");
  const bool is_known = array.ndim() == 2 && ((array.shape(0) == 3 && (array.shape(1) == 3 || array.shape(1) == 4)) ||
                                              (array.shape(0) == 4 && array.shape(1) == 4));
  if (!is_known) throw InvalidShape("matrix has shape " + shape_text(array) + ", (3, 3), (3, 4) or (4, 4) is expected");
  for (py::ssize_t k = 0; k < array.size(); ++k) {
    if (std::isfinite(array.data()[k])) continue;
    throw InvalidShape("matrix" + splinecore::index_text(k, array.shape(1)) + " = " +
                       splinecore::text_of(array.data()[k]) + " is not finite");
  }
  glm::dmat4 matrix(1.0);
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    for (py::ssize_t j = 0; j < array.shape(1); ++j) matrix[static_cast<int>(j)][static_cast<int>(i)] = array.at(i, j);
  }
  return matrix;
}

Axis axis_of(const py::object& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "u") return Axis::u;
    if (text == "v") return Axis::v;
  }
  throw InvalidShape("axis = " + std::string(py::repr(value)) + " is neither 'u' nor 'v'");
}

Border border_of(const py::object& value, const char* name) {
  const std::pair<const char*, Border> known[] = {{"u_start", Border::u_start}, {"u_end", Border::u_end},
                                                  {"v_start", Border::v_start}, {"v_end", Border::v_end}};
  for (const auto& [text, border] : known) {
    if (py::isinstance<py::str>(value) && value.cast<std::string>() == text) return border;
  }
  throw InvalidShape(std::string(name) + " = " + std::string(py::repr(value)) + " is not 'u_start', 'u_end', 'v_start' or 'v_end'");
}

}  // namespace bindings
