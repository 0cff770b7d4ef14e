#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/basis/knot_vector.hpp"

// Arrays in, arrays out: what every binding needs to be strict about its arguments.
namespace bindings {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

/// Any array-like of real numbers as contiguous, aligned float64.
/// @throws py::type_error for strings, complex numbers, objects, None; InvalidShape for ragged lists.
Doubles real_array(const py::handle& value, const char* name);

/// Any array-like as an array of what it holds. @throws InvalidShape for ragged lists.
py::array array_of(const py::handle& value, const char* name);

/// An integer that fits an int. @throws py::type_error for anything else, InvalidShape if too large.
int integer(const py::handle& value, const char* name);

/// A real number. @throws py::type_error for anything else, InvalidShape if it is not finite.
double real(const py::handle& value, const char* name);

/// A real number, or none for None.
std::optional<double> optional_real(const py::handle& value, const char* name);

/// The argument u, a parameter of the domain. @throws InvalidShape if it lies outside.
double parameter(const py::handle& value, const splinecore::KnotVector& knots);

bool boolean(const py::handle& value, const char* name);

/// True or False, or none for None.
std::optional<bool> optional_boolean(const py::handle& value, const char* name);

/// "(3, 4)"
std::string shape_text(const py::array& array);

/// Where element `flat` of an array lies: "[1, 2]", or nothing for a single number.
std::string place_text(const py::array& array, py::ssize_t flat);

/// "int": for messages.
std::string type_name(const py::handle& value);

/// A value in one line of 60 characters at most: for messages.
std::string short_text(const py::handle& value);

bool is_aligned(const py::array& array);

/// @throws InvalidShape unless the first dimensions are these.
void require_net(const py::array& array, const char* name, const Shape& net);

/// An argument with one part for u and one for v. @throws py::type_error if it is no pair.
std::pair<py::object, py::object> pair_argument(const py::object& value, const char* name,
                                                const char* of = "one for u, one for v");

/// Points of two or three columns and their weights (or None: all 1), as (x, y, z, w).
/// @param dimensions  1 for a row of points, 2 for a net
std::vector<glm::dvec4> weighted_points(const Doubles& points, const py::object& weights, int dimensions);

/// Rows of four numbers (wx, wy, wz, w), as they are.
std::vector<glm::dvec4> rows_of_four(const Doubles& points, const char* name, int dimensions);

/// Vectors of two or three columns.
std::vector<glm::dvec3> vectors(const Doubles& values, const char* name, int dimensions);

/// One vector of two or three numbers. @throws InvalidShape if one is not finite.
glm::dvec3 vector_of(const py::object& value, const char* name);

std::vector<double> numbers(const py::object& value, const char* name);

/// The same; none at all for None.
std::vector<double> optional_numbers(const py::object& value, const char* name);

/// So many numbers. @throws InvalidShape if there are more or fewer.
template <std::size_t Count>
std::array<double, Count> numbers_in(const py::object& value, const char* name) {
  const std::vector<double> given = numbers(value, name);
  if (given.size() != Count) {
    throw splinecore::InvalidShape(std::string(name) + " has " + std::to_string(given.size()) + " numbers, not " +
                                   std::to_string(Count));
  }
  std::array<double, Count> found;
  std::ranges::copy(given, found.begin());
  return found;
}

/// Values that do not change while `out` is written.
Doubles apart_from(const Doubles& values, const py::object& out);

/// @throws InvalidShape naming the first parameter outside the domain, by its place in the array.
void require_inside(const splinecore::KnotVector& knots, const Doubles& parameters, splinecore::Side side,
                    const char* name);

/// A new array of so many numbers. The constructor of py::array_t that takes a count asks NumPy how large
/// they are: of an older pybind11 and NumPy 2 all of them would lie in one place.
template <class Number>
py::array_t<Number> new_numbers(std::size_t count) {
  return py::array_t<Number>(Shape{static_cast<py::ssize_t>(count)});
}

template <class Number, std::size_t Extent>
py::array_t<std::remove_const_t<Number>> new_numbers(std::span<Number, Extent> numbers) {
  auto array = new_numbers<std::remove_const_t<Number>>(numbers.size());
  std::ranges::copy(numbers, array.mutable_data());
  return array;
}

py::tuple pair_of(const splinecore::Interval& interval);

splinecore::Side side_of(const py::handle& value, const char* name);
splinecore::AtInfinity at_infinity_of(const py::handle& value);

/// How many threads, 0 for as many as are worth it. @throws InvalidShape if it is below 0 or more than 1024.
int threads_of(const py::object& value);

}  // namespace bindings
