#include "arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "splinecore/base/points.hpp"

namespace bindings {

using splinecore::InvalidShape;

namespace {

void require_dimensions(const Doubles& array, const char* name, int dimensions, const char* columns) {
  if (array.ndim() == dimensions + 1) return;
  const char* shape = dimensions == 1 ? "(n, " : "(nu, nv, ";
  throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", " + shape + columns + ") is expected");
}

[[noreturn]] void refuse_type(const py::handle& value, const char* name, const char* wanted) {
  throw py::type_error(std::string(name) + " = " + short_text(value) + " must be " + wanted + ", not " +
                       type_name(value));
}

bool is_real_number(const py::handle& value) {
  if (PyFloat_Check(value.ptr())) return true;
  if (py::hasattr(value, "dtype")) {
    const std::string kind = py::str(value.attr("dtype").attr("kind"));
    return kind == "f" || kind == "i" || kind == "u";
  }
  if (!PyLong_Check(value.ptr()) || PyBool_Check(value.ptr())) return false;
  int overflow = 0;
  PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  return overflow == 0;
}

/// A list's elements as they were given: numpy makes strings of all numbers beside one.
py::array as_given(const py::handle& value, const py::array& array) {
  if (py::isinstance<py::array>(value)) return array;
  try {
    const py::array given = py::module_::import("numpy").attr("asarray")(value, "object");
    return given.size() == array.size() ? given : array;
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    return array;
  }
}

[[noreturn]] void refuse_element(const char* name, const py::array& array, py::ssize_t flat, const std::string& element) {
  throw py::type_error(std::string(name) + place_text(array, flat) + " = " + element +
                       " is not a real number that fits float64 or int64");
}

/// Numpy takes the numbers behind a mask for those of the array.
void refuse_masked(const py::handle& value, const char* name) {
  if (!py::isinstance<py::array>(value) || !py::hasattr(value, "mask")) return;
  const py::array masked = py::module_::import("numpy").attr("ma").attr("getmaskarray")(value);
  if (!masked.attr("any")().cast<bool>()) return;
  refuse_element(name, masked, masked.attr("argmax")().cast<py::ssize_t>(), "masked");
}

/// Names the first element of an array that is no array of real numbers.
[[noreturn]] void refuse_elements(const py::handle& value, const py::array& converted, const char* name) {
  const py::array array = as_given(value, converted);
  const py::list elements = array.attr("ravel")().attr("tolist")();
  py::ssize_t first = 0;
  for (const py::handle& element : elements) {
    if (!is_real_number(element)) break;
    ++first;
  }
  const auto count = static_cast<py::ssize_t>(elements.size());
  if (count == 0) {
    throw py::type_error(std::string(name) + " has dtype " + std::string(py::str(array.dtype())) +
                         ", real numbers are expected");
  }
  if (first == count) {
    throw py::type_error(std::string(name) + " is an array of objects: give it a dtype of numbers, as with astype(float)");
  }
  refuse_element(name, array, first, short_text(elements[first]));
}

/// How many values a row has; 0 for what is none.
std::size_t length_of(const py::handle& row) {
  const py::ssize_t length = PySequence_Check(row.ptr()) != 0 ? PySequence_Size(row.ptr()) : 0;
  PyErr_Clear();
  return static_cast<std::size_t>(std::max<py::ssize_t>(length, 0));
}

using Place = std::vector<std::size_t>;

std::string text_of(const Place& place) {
  std::string text;
  for (const std::size_t index : place) text += (text.empty() ? "[" : ", ") + std::to_string(index);
  return text + "]";
}

/// Names the first of nested lists that is missing or has another length than those before it, if there is one.
void refuse_uneven(const py::handle& value, const char* name, const Place& place) {
  constexpr std::size_t kDeepest = 3;
  if (place.size() == kDeepest || !(PyList_Check(value.ptr()) || PyTuple_Check(value.ptr()))) return;
  const auto rows = py::reinterpret_borrow<py::sequence>(value);
  Place inside = place;
  inside.push_back(0);
  std::size_t& i = inside.back();
  for (; i < rows.size(); ++i) {
    const py::object row = rows[i];
    if (row.is_none()) throw InvalidShape(name + text_of(inside) + " is missing: it is None");
    const std::size_t wanted = length_of(rows[0]);
    if (length_of(row) == wanted) continue;
    throw InvalidShape(name + text_of(inside) + " = " + short_text(row) + " has " + std::to_string(length_of(row)) +
                       " values, the rows before have " + std::to_string(wanted));
  }
  for (i = 0; i < rows.size(); ++i) refuse_uneven(rows[i], name, inside);
}

/// What numpy has to say about a list that is no array, or better.
[[noreturn]] void refuse_ragged(const py::handle& value, const char* name, const std::string& reason) {
  refuse_uneven(value, name, {});
  throw InvalidShape(std::string(name) + " is not an array: " + reason);
}

}  // namespace

bool is_aligned(const py::array& array) {
  return (array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) != 0;
}

std::string short_text(const py::handle& value) {
  const py::str text = py::str(" ").attr("join")(py::repr(value).attr("split")());
  return py::len(text) <= 60 ? std::string(text) : std::string(py::str(text[py::slice(0, 57, 1)])) + "...";
}

std::string type_name(const py::handle& value) { return py::str(py::type::of(value).attr("__name__")); }

py::array array_of(const py::handle& value, const char* name) {
  const bool is_array = Py_TYPE(value.ptr()) == py::detail::npy_api::get().PyArray_Type_;
  if (is_array) return py::reinterpret_borrow<py::array>(value);
  refuse_masked(value, name);
  std::string reason;
  try {
    return py::module_::import("numpy").attr("asarray")(value);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    reason = py::str(error.value());
  }
  refuse_ragged(value, name, reason);
}

Doubles real_array(const py::handle& value, const char* name) {
  if (value.is_none()) throw py::type_error(std::string(name) + " is missing: an array is expected, not None");
  const py::array array = array_of(value, name);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') refuse_elements(value, array, name);
  const Doubles numbers(array);
  return is_aligned(numbers) ? numbers : Doubles(numbers.attr("copy")());
}

int integer(const py::handle& value, const char* name) {
  const bool is_index = PyIndex_Check(value.ptr()) != 0 && !PyBool_Check(value.ptr());
  if (!is_index) {
    refuse_type(value, name, "an integer");
  }
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) {
    PyErr_Clear();
    refuse_type(value, name, "an integer");
  }
  int overflow = 0;
  const long long wide = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0 || wide > 2147483647 || wide < -2147483647) {
    throw InvalidShape(std::string(name) + " = " + short_text(number) + " is far too large");
  }
  return static_cast<int>(wide);
}

double real(const py::handle& value, const char* name) {
  if (value.is_none()) throw py::type_error(std::string(name) + " is missing: a number is expected, not None");
  const Doubles array = real_array(value, name);
  if (array.ndim() != 0 && array.size() != 1) {
    throw py::type_error(std::string(name) + " must be one number, not an array of shape " + shape_text(array));
  }
  const double number = *array.data();
  if (std::isfinite(number)) return number;
  throw InvalidShape(std::string(name) + " = " + splinecore::text_of(number) + " is not finite");
}

std::optional<double> optional_real(const py::handle& value, const char* name) {
  return value.is_none() ? std::nullopt : std::optional(real(value, name));
}

double parameter(const py::handle& value, const splinecore::KnotVector& knots) {
  const double u = real(value, "u");
  require_inside(knots, Doubles(py::float_(u)), splinecore::Side::right, "u");
  return u;
}

bool boolean(const py::handle& value, const char* name) {
  if (PyBool_Check(value.ptr())) return value.ptr() == Py_True;
  const bool numpy_bool = type_name(value) == "bool_" || type_name(value) == "bool";
  if (!numpy_bool) {
    refuse_type(value, name, "True or False");
  }
  return py::bool_(py::reinterpret_borrow<py::object>(value));
}

std::optional<bool> optional_boolean(const py::handle& value, const char* name) {
  return value.is_none() ? std::nullopt : std::optional(boolean(value, name));
}

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

std::string place_text(const py::array& array, py::ssize_t flat) {
  std::string text;
  for (py::ssize_t axis = array.ndim(); axis-- > 0; flat /= array.shape(axis)) {
    text = std::to_string(flat % array.shape(axis)) + (text.empty() ? "" : ", ") + text;
  }
  return text.empty() ? text : "[" + text + "]";
}

void require_net(const py::array& array, const char* name, const Shape& net) {
  const auto dimensions = static_cast<py::ssize_t>(net.size());
  if (array.ndim() >= dimensions && std::equal(net.begin(), net.end(), array.shape())) return;
  const std::string counts = py::str(py::tuple(py::cast(net)));
  throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + " for points " + counts);
}

std::pair<py::object, py::object> pair_argument(const py::object& value, const char* name, const char* of) {
  const bool is_sequence = PySequence_Check(value.ptr()) != 0 && !py::isinstance<py::str>(value) &&
                           !py::isinstance<py::bytes>(value);
  const py::ssize_t length = is_sequence ? PySequence_Size(value.ptr()) : -1;
  PyErr_Clear();
  if (length != 2) {
    throw py::type_error(std::string(name) + " = " + short_text(value) + " must be a pair: " + of);
  }
  return {value[py::int_(0)], value[py::int_(1)]};
}

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

glm::dvec3 vector_of(const py::object& value, const char* name) {
  const Doubles array = real_array(value, name);
  if (array.ndim() != 1 || (array.shape(0) != 2 && array.shape(0) != 3)) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", (2,) or (3,) is expected");
  }
  const glm::dvec3 vector(array.at(0), array.at(1), array.shape(0) == 3 ? array.at(2) : 0.0);
  for (int k = 0; k < 3; ++k) {
    if (std::isfinite(vector[k])) continue;
    throw InvalidShape(std::string(name) + splinecore::index_text(k) + " = " + splinecore::text_of(vector[k]) +
                       " is not finite");
  }
  return vector;
}

std::vector<double> optional_numbers(const py::object& value, const char* name) {
  return value.is_none() ? std::vector<double>() : numbers(value, name);
}

Doubles apart_from(const Doubles& values, const py::object& out) {
  if (!py::isinstance<py::array>(out)) return values;
  const bool shared = py::module_::import("numpy").attr("may_share_memory")(values, out).cast<bool>();
  return shared ? Doubles(values.attr("copy")()) : values;
}

void require_inside(const splinecore::KnotVector& knots, const Doubles& parameters, splinecore::Side side,
                    const char* name) {
  for (py::ssize_t i = 0; i < parameters.size(); ++i) {
    try {
      knots.admit(parameters.data()[i], side, 0, "");
    } catch (const InvalidShape& error) {
      const std::string rest = std::string(error.what()).substr(splinecore::index_text(0).size());
      throw InvalidShape(name + place_text(parameters, i) + rest);
    }
  }
}

std::vector<double> numbers(const py::object& value, const char* name) {
  const Doubles array = real_array(value, name);
  if (array.ndim() != 1) {
    throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", (n,) is expected");
  }
  return {array.data(), array.data() + array.size()};
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

int threads_of(const py::object& value) {
  constexpr int kMost = 1024;
  const int threads = integer(value, "threads");
  if (threads >= 0 && threads <= kMost) return threads;
  throw InvalidShape("threads = " + std::to_string(threads) + ": 0, which is one for each core where that is worth it, to " +
                     std::to_string(kMost) + " are possible");
}

}  // namespace bindings
