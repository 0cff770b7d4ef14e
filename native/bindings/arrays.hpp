#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/interval.hpp"

// Arrays in, arrays out: what every binding needs to be strict about its arguments.
namespace bindings {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style>;
using Shape = std::vector<py::ssize_t>;

/// Any array-like of real numbers as contiguous float64.
/// @throws py::type_error for strings, complex numbers, objects, None; InvalidShape for ragged lists.
Doubles real_array(const py::handle& value, const char* name);

/// An integer that fits an int. @throws py::type_error for anything else, InvalidShape if too large.
int integer(const py::handle& value, const char* name);

/// A real number. @throws py::type_error for anything else.
double real(const py::handle& value, const char* name);

bool boolean(const py::handle& value, const char* name);

/// "(3, 4)"
std::string shape_text(const py::array& array);

/// Points of two or three columns and their weights (or None: all 1), as (x, y, z, w).
/// @param dimensions  1 for a row of points, 2 for a net
std::vector<glm::dvec4> weighted_points(const Doubles& points, const py::object& weights, int dimensions);

/// Rows of four numbers (wx, wy, wz, w), as they are.
std::vector<glm::dvec4> rows_of_four(const Doubles& points, const char* name, int dimensions);

/// Vectors of two or three columns.
std::vector<glm::dvec3> vectors(const Doubles& values, const char* name, int dimensions);

std::vector<double> numbers(const py::object& value, const char* name);

/// Read-only views into the memory of `owner`, which they keep alive.
py::array view_of_points(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner);
py::array view_of_weights(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner);
py::array view_of_vectors(std::span<const glm::dvec3> vectors, const Shape& shape, const py::object& owner);
py::array view_of_numbers(std::span<const double> numbers, const py::object& owner);

/// A new read-only array of (wx, wy, wz, w).
py::array homogeneous_array(std::span<const glm::dvec4> given, const Shape& shape);

py::tuple pair_of(const splinecore::Interval& interval);

splinecore::Side side_of(const py::handle& value, const char* name);
splinecore::AtInfinity at_infinity_of(const py::handle& value);

/// Where a result goes: a new array, or the caller's `out`, in float64 or float32.
class Output {
 public:
  /// @throws py::type_error or InvalidShape if out is not a writable C-contiguous array of the
  ///         shape, or its type and dtype disagree.
  Output(const Shape& shape, const py::object& out, const py::object& dtype);

  bool single() const noexcept { return single_; }
  const py::array& array() const noexcept { return array_; }
  std::span<double> doubles(std::size_t first, std::size_t count) const;
  std::span<float> floats(std::size_t first, std::size_t count) const;

 private:
  py::array array_;
  bool single_ = false;
  void* data_ = nullptr;
};

}  // namespace bindings
