#include "output.hpp"

#include <algorithm>

namespace bindings {

using splinecore::InvalidShape;

namespace {

py::dtype dtype_of(const py::object& value) {
  try {
    return py::dtype::from_args(value);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_Exception)) throw;
    throw py::type_error("dtype = " + short_text(value) + " is not float64 or float32");
  }
}

}  // namespace

Output::Output(const Shape& shape, const py::object& out) : Output(shape, out, py::none(), "float64") {
  if (single_) throw py::type_error("out has dtype float32, float64 is expected");
}

Output::Output(const Shape& shape, const py::object& out, const py::object& dtype)
    : Output(shape, out, dtype, "float64 or float32") {}

Output::Output(const Shape& shape, const py::object& out, const py::object& dtype, const char* possible) {
  py::dtype wanted = py::dtype::of<double>();
  if (!dtype.is_none()) {
    wanted = dtype_of(dtype);
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
    throw py::type_error("out has dtype " + std::string(py::str(array_.dtype())) + ", " + possible + " is expected");
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
  if (!is_aligned(array_)) throw InvalidShape("out is not aligned in memory");
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
