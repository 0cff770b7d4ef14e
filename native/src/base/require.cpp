#include "require.hpp"

#include <cmath>

#include "splinecore/base/errors.hpp"

namespace splinecore {

void require_coordinates(const double* xyz, const std::string& argument, std::size_t index, std::size_t row_length) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(xyz[axis])) continue;
    throw InvalidShape(argument + index_text(index, row_length) + "." + "xyz"[axis] + " = " +
                       text_of(xyz[axis]) + " is not finite");
  }
}

void require_finite(std::span<const double> values, const std::string& argument) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw InvalidShape(argument + index_text(i) + " = " + text_of(values[i]) + " is not finite");
  }
}

void require_finite(std::span<const glm::dvec3> vectors, const std::string& argument,
                    std::size_t row_length) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    require_coordinates(&vectors[i].x, argument, i, row_length);
  }
}

}  // namespace splinecore
