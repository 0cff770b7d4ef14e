#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <stdexcept>

namespace bindings {

namespace py = pybind11;

/// A long call was ended by its caller.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled by the caller") {}
};

/// Calls work(begin, end) on consecutive parts of [0, total) without the interpreter's lock. Between
/// parts Ctrl-C and `cancel`, a callable that returns true to end the call, are heeded.
template <class Work>
void in_parts(std::size_t total, std::size_t part, const py::object& cancel, Work work) {
  for (std::size_t begin = 0; begin < total; begin += part) {
    {
      const py::gil_scoped_release unlocked;
      work(begin, std::min(total, begin + part));
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!cancel.is_none() && py::cast<bool>(cancel())) throw Cancelled();
  }
}

}  // namespace bindings
