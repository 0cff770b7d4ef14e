#include "rail_numbers.hpp"

#include <string>

#include "arrays.hpp"
#include "long_calls.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::RailNumber;

std::vector<RailNumber> numbers_along(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  const Doubles pairs = real_array(value, name);
  if (pairs.ndim() != 2 || pairs.shape(1) != 2) throw InvalidShape(std::string(name) + " must have the shape (n, 2): parameters and numbers");
  std::vector<RailNumber> found;
  for (py::ssize_t i = 0; i < pairs.shape(0); ++i) found.push_back({pairs.data()[2 * i], pairs.data()[2 * i + 1]});
  return found;
}

std::vector<RailNumber> radii_of(const py::object& value, const char* name, const splinecore::Interval& domain) {
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
    return {{domain.start, real(value, name)}};
  }
  return numbers_along(value, name);
}

}  // namespace bindings
