#pragma once

#include "arrays.hpp"

namespace bindings {

/// Where a result goes: a new array, or the caller's `out`, in float64 or float32.
class Output {
 public:
  /// @throws py::type_error or InvalidShape if out is not a writable, aligned C-contiguous array of the
  ///         shape, or its type and dtype disagree.
  Output(const Shape& shape, const py::object& out, const py::object& dtype);

  /// In float64 alone.
  Output(const Shape& shape, const py::object& out);

  bool single() const noexcept { return single_; }
  const py::array& array() const noexcept { return array_; }
  std::span<double> doubles(std::size_t first, std::size_t count) const;
  std::span<float> floats(std::size_t first, std::size_t count) const;

 private:
  Output(const Shape& shape, const py::object& out, const py::object& dtype, const char* possible);

  py::array array_;
  bool single_ = false;
  void* data_ = nullptr;
};

}  // namespace bindings
