#include "require.hpp"

#include <cmath>

#include "kernels/kernels.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

bool are_finite(const double* values, std::size_t count) { return std::isfinite(kernels().largest_size(values, count)); }

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

void require_increasing(std::span<const double> values, const std::string& argument) {
  if (values.empty()) return;
  const bool increase = kernels().are_increasing(values.data(), values.size());
  // What increases to a number from one is all numbers.
  if (increase && std::isfinite(values.back() - values.front())) return;
  require_finite(values, argument);
  for (std::size_t i = 1; i < values.size() && !increase; ++i) {
    if (values[i] > values[i - 1]) continue;
    throw InvalidShape(argument + index_text(i) + " = " + text_of(values[i]) + " does not increase from " +
                       text_of(values[i - 1]));
  }
  throw InvalidShape(argument + " from " + text_of(values.front()) + " to " + text_of(values.back()) +
                     " overflow: their distance is not a finite number");
}

void require_tolerance(double tolerance) {
  if (!(tolerance >= 0.0)) throw InvalidShape("tolerance = " + text_of(tolerance) + " is not 0 or more");
}

void require_positive(double length, const std::string& name) {
  if (std::isfinite(length) && length > 0.0) return;
  throw InvalidShape(name + " = " + text_of(length) + " is not a positive length");
}

}  // namespace splinecore
