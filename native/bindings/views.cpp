#include "views.hpp"

#include <algorithm>

#include "splinecore/base/points.hpp"

namespace bindings {

namespace {

py::array read_only(py::array array) {
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

Shape strides_of(const Shape& shape, py::ssize_t item) {
  Shape strides(shape.size(), item);
  for (std::size_t i = shape.size() - 1; i-- > 0;) strides[i] = strides[i + 1] * shape[i + 1];
  return strides;
}

/// A view of single numbers that lie `step` bytes apart.
py::array strided_view(const void* data, Shape shape, py::ssize_t step, const py::object& owner) {
  return read_only(py::array(py::dtype::of<double>(), shape, strides_of(shape, step), data, owner));
}

/// A view of three columns of rows that lie `step` bytes apart.
py::array columns_view(const void* data, Shape shape, py::ssize_t step, const py::object& owner) {
  Shape strides = strides_of(shape, step);
  shape.push_back(3);
  strides.push_back(sizeof(double));
  return read_only(py::array(py::dtype::of<double>(), shape, strides, data, owner));
}

}  // namespace

py::array view_of_points(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner) {
  return columns_view(points.data(), shape, sizeof(glm::dvec4), owner);
}

py::array view_of_weights(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner) {
  return strided_view(&points.data()->w, shape, sizeof(glm::dvec4), owner);
}

py::array view_of_vectors(std::span<const glm::dvec3> vectors, const Shape& shape, const py::object& owner) {
  return columns_view(vectors.data(), shape, sizeof(glm::dvec3), owner);
}

py::array homogeneous_array(std::span<const glm::dvec4> given, const Shape& shape) {
  Shape rows = shape;
  rows.push_back(4);
  py::array_t<double> array(rows);
  const std::size_t row_length = shape.size() == 2 ? static_cast<std::size_t>(shape[1]) : 0;
  const std::vector<glm::dvec4> points = splinecore::finite_homogeneous(given, row_length);
  if (!points.empty()) std::copy_n(&points.data()->x, 4 * points.size(), array.mutable_data());
  return read_only(array);
}

}  // namespace bindings
