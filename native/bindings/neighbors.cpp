#include "neighbors.hpp"

#include <string>

#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"

namespace bindings {

using splinecore::LoftNeighbor;

int continuity_of(const py::object& word, const char* name) {
  return chosen<int>(word, name, {{"G0", 0}, {"G1", 1}, {"G2", 2}, {"G3", 3}});
}

std::optional<LoftNeighbor> neighbor_of(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  const bool is_tuple = py::isinstance<py::tuple>(value) && (py::len(value) == 3 || py::len(value) == 4);
  if (!is_tuple) throw py::type_error(std::string(name) + " must be a tuple (patch, side, 'G0' to 'G3'[, strength])");
  const auto given = py::reinterpret_borrow<py::tuple>(value);
  LoftNeighbor neighbor{any_patch(given[0], name), border_of(given[1], name)};
  neighbor.continuity = continuity_of(given[2], name);
  if (given.size() == 4) neighbor.strength = real(given[3], name);
  return neighbor;
}

}  // namespace bindings
