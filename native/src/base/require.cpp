#include "require.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// Without branches, for that is so nearly always.
bool are_finite(const double* values, std::size_t count) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  std::int64_t wrong = 0;  // as wide as a number, so that several are looked at at once
  for (std::size_t i = 0; i < count; ++i) wrong += std::abs(values[i]) <= kLargest ? 0 : 1;
  return wrong == 0;
}

}  // namespace

void require_coordinates(const double* xyz, const std::string& argument, std::size_t index, std::size_t row_length) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(xyz[axis])) continue;
    throw InvalidShape(argument + index_text(index, row_length) + "." + "xyz"[axis] + " = " +
                       text_of(xyz[axis]) + " is not finite");
  }
}

void require_finite(std::span<const double> values, const std::string& argument) {
  if (are_finite(values.data(), values.size())) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw InvalidShape(argument + index_text(i) + " = " + text_of(values[i]) + " is not finite");
  }
}

void require_finite(std::span<const glm::dvec3> vectors, const std::string& argument,
                    std::size_t row_length) {
  if (vectors.empty() || are_finite(&vectors.front().x, 3 * vectors.size())) return;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    require_coordinates(&vectors[i].x, argument, i, row_length);
  }
}

}  // namespace splinecore
