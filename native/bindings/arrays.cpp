#include "arrays.hpp"

#include <algorithm>

#include "splinecore/base/points.hpp"

namespace bindings {

using splinecore::InvalidShape;

namespace {

std::string type_name(const py::handle& value) { return py::str(py::type::of(value).attr("__name__")); }

py::array read_only(py::array array) {
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

void require_dimensions(const Doubles& array, const char* name, int dimensions, const char* columns) {
  if (array.ndim() == dimensions + 1) return;
  const char* shape = dimensions == 1 ? "(n, " : "(nu, nv, ";
  throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", " + shape + columns + ") is expected");
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

Doubles real_array(const py::handle& value, const char* name) {
  if (value.is_none()) throw py::type_error(std::string(name) + " is missing: an array is expected, not None");
  py::array array;
  try {
    array = py::module_::import("numpy").attr("asarray")(value);
  } catch (py::error_already_set& error) {
    throw InvalidShape(std::string(name) + " is not an array: " + std::string(py::str(error.value())));
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw py::type_error(std::string(name) + " has dtype " + std::string(py::str(array.dtype())) +
                         ", real numbers are expected");
  }
  return Doubles(array);
}

int integer(const py::handle& value, const char* name) {
  const bool is_index = PyIndex_Check(value.ptr()) != 0 && !PyBool_Check(value.ptr());
  if (!is_index) {
    throw py::type_error(std::string(name) + " must be an integer, not " + type_name(value));
  }
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) throw py::error_already_set();
  int overflow = 0;
  const long wide = PyLong_AsLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0 || wide > 2147483647L || wide < -2147483647L) {
    throw InvalidShape(std::string(name) + " = " + std::string(py::str(number)) + " is far too large");
  }
  return static_cast<int>(wide);
}

double real(const py::handle& value, const char* name) {
  const Doubles array = real_array(value, name);
  if (array.ndim() != 0 && array.size() != 1) {
    throw py::type_error(std::string(name) + " must be one number, not an array of shape " + shape_text(array));
  }
  return *array.data();
}

bool boolean(const py::handle& value, const char* name) {
  const bool numpy_bool = type_name(value) == "bool_" || type_name(value) == "bool";
  if (!numpy_bool) throw py::type_error(std::string(name) + " must be True or False, not " + type_name(value));
  return py::bool_(py::reinterpret_borrow<py::object>(value));
}

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

std::vector<glm::dvec4> weighted_points(const Doubles& points, const py::object& weights, int dimensions) {
  const std::vector<glm::dvec3> places = vectors(points, "points", dimensions);
  std::vector<glm::dvec4> rows;
  rows.reserve(places.size());
  for (const glm::dvec3& p : places) rows.emplace_back(p, 1.0);
  if (weights.is_none()) return rows;
  const Doubles given = real_array(weights, "weights");
  if (given.ndim() != dimensions || !std::equal(given.shape(), given.shape() + dimensions, points.shape())) {
    throw InvalidShape("weights has shape " + shape_text(given) + " for points of shape " + shape_text(points));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = given.data()[i];
  return rows;
}

std::vector<glm::dvec4> rows_of_four(const Doubles& points, const char* name, int dimensions) {
  require_dimensions(points, name, dimensions, "4");
  if (points.shape(dimensions) != 4) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(points) + ", rows of 4 are expected");
  }
  std::vector<glm::dvec4> rows(points.size() / 4);
  std::copy_n(points.data(), points.size(), &rows.data()->x);
  return rows;
}

std::vector<glm::dvec3> vectors(const Doubles& values, const char* name, int dimensions) {
  require_dimensions(values, name, dimensions, "2 or 3");
  const py::ssize_t columns = values.shape(dimensions);
  if (columns != 2 && columns != 3) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(values) + ", rows of 2 or 3 are expected");
  }
  std::vector<glm::dvec3> rows;
  rows.reserve(values.size() / columns);
  for (const double* row = values.data(); row != values.data() + values.size(); row += columns) {
    rows.emplace_back(row[0], row[1], columns == 3 ? row[2] : 0.0);
  }
  return rows;
}

std::vector<double> numbers(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  const Doubles array = real_array(value, name);
  if (array.ndim() != 1) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", (n,) is expected");
  }
  return {array.data(), array.data() + array.size()};
}

py::array view_of_points(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner) {
  return columns_view(points.data(), shape, sizeof(glm::dvec4), owner);
}

py::array view_of_weights(std::span<const glm::dvec4> points, const Shape& shape, const py::object& owner) {
  return strided_view(&points.data()->w, shape, sizeof(glm::dvec4), owner);
}

py::array view_of_vectors(std::span<const glm::dvec3> vectors, const Shape& shape, const py::object& owner) {
  return columns_view(vectors.data(), shape, sizeof(glm::dvec3), owner);
}

py::array view_of_numbers(std::span<const double> numbers, const py::object& owner) {
  return strided_view(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, sizeof(double), owner);
}

py::array homogeneous_array(std::span<const glm::dvec4> given, const Shape& shape) {
  Shape rows = shape;
  rows.push_back(4);
  py::array_t<double> array(rows);
  const std::vector<glm::dvec4> points = splinecore::homogeneous(given);
  if (!points.empty()) std::copy_n(&points.data()->x, 4 * points.size(), array.mutable_data());
  return read_only(array);
}

py::tuple pair_of(const splinecore::Interval& interval) { return py::make_tuple(interval.start, interval.end); }

splinecore::Side side_of(const py::handle& value, const char* name) {
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "right") return splinecore::Side::right;
    if (text == "left") return splinecore::Side::left;
  }
  throw InvalidShape(std::string(name) + " = " + std::string(py::repr(value)) + " is neither 'left' nor 'right'");
}

splinecore::AtInfinity at_infinity_of(const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "raise") return splinecore::AtInfinity::raise;
    if (text == "nan") return splinecore::AtInfinity::nan;
  }
  throw InvalidShape("at_infinity = " + std::string(py::repr(value)) + " is neither 'raise' nor 'nan'");
}

Output::Output(const Shape& shape, const py::object& out, const py::object& dtype) {
  py::dtype wanted = py::dtype::of<double>();
  if (!dtype.is_none()) {
    wanted = py::dtype::from_args(dtype);
    single_ = wanted.equal(py::dtype::of<float>());
    if (!single_ && !wanted.equal(py::dtype::of<double>())) {
      throw py::type_error("dtype must be float64 or float32, not " + std::string(py::str(wanted)));
    }
  }
  if (out.is_none()) {
    array_ = single_ ? py::array(py::array_t<float>(shape)) : py::array(py::array_t<double>(shape));
    data_ = array_.mutable_data();
    return;
  }
  if (!py::isinstance<py::array>(out)) throw py::type_error("out must be a numpy array, not " + type_name(out));
  array_ = py::reinterpret_borrow<py::array>(out);
  single_ = array_.dtype().equal(py::dtype::of<float>());
  if (!single_ && !array_.dtype().equal(py::dtype::of<double>())) {
    throw py::type_error("out has dtype " + std::string(py::str(array_.dtype())) + ", float64 or float32 is expected");
  }
  if (!dtype.is_none() && !array_.dtype().equal(wanted)) {
    throw py::type_error("out has dtype " + std::string(py::str(array_.dtype())) + ", but dtype is " +
                         std::string(py::str(wanted)));
  }
  if (!std::equal(shape.begin(), shape.end(), array_.shape(), array_.shape() + array_.ndim())) {
    throw InvalidShape("out has shape " + shape_text(array_) + ", the result has " +
                       std::string(py::str(py::tuple(py::cast(shape)))));
  }
  if (!(array_.flags() & py::array::c_style)) throw InvalidShape("out is not C-contiguous");
  if (!array_.writeable()) throw InvalidShape("out is read-only");
  data_ = array_.mutable_data();
}

std::span<double> Output::doubles(std::size_t first, std::size_t count) const {
  return {static_cast<double*>(data_) + first, count};
}

std::span<float> Output::floats(std::size_t first, std::size_t count) const {
  return {static_cast<float*>(data_) + first, count};
}

}  // namespace bindings
