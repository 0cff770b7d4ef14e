#pragma once

#include "arrays.hpp"

namespace bindings {

/// Read-only views into the memory of `owner`, which they keep alive.
py::array view_of_points(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner);
py::array view_of_weights(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner);
py::array view_of_vectors(std::span<const glm::dvec3> vectors, const Shape& shape, const py::object& owner);

/// The same for numbers that lie one after the other.
template <class Number>
py::array view_of_numbers(std::span<const Number> numbers, const Shape& shape, const py::object& owner) {
  // Strides are given: an older pybind11 would ask a newer NumPy for them in vain.
  py::array view(py::dtype::of<Number>(), shape, py::detail::c_strides(shape, sizeof(Number)), numbers.data(), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

template <class Number>
py::array view_of_numbers(std::span<const Number> numbers, const py::object& owner) {
  return view_of_numbers(numbers, {static_cast<py::ssize_t>(numbers.size())}, owner);
}

/// A new read-only array of (wx, wy, wz, w).
py::array homogeneous_array(std::span<const glm::dvec4> given, const Shape& shape);

}  // namespace bindings
