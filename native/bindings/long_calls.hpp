#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "splinecore/base/pause.hpp"

namespace bindings {

namespace py = pybind11;

/// A long call was ended by its caller.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled by the caller") {}
};

inline bool is_true(const py::object& answer) {
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw py::error_already_set();
  return truth != 0;
}

/// @throws py::type_error if cancel is neither None nor callable.
inline void require_callable(const py::object& cancel) {
  if (!cancel.is_none() && PyCallable_Check(cancel.ptr()) == 0) {
    throw py::type_error("cancel = " + std::string(py::repr(cancel)) + " is not callable");
  }
}

/// Heeds Ctrl-C and `cancel`, a callable that returns true to end the call. With the interpreter's lock.
inline void heed(const py::object& cancel) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!cancel.is_none() && is_true(cancel())) throw Cancelled();
}

/// The result of work that needs no interpreter, done without its lock; it heeds Ctrl-C and `cancel` where it is long.
/// @throws py::type_error if cancel is neither None nor callable.
template <class Work>
auto unlocked(Work work, const py::object& cancel = py::none()) {
  require_callable(cancel);
  const splinecore::Pause pause = [&cancel] {
    const py::gil_scoped_acquire locked;
    heed(cancel);
  };
  const py::gil_scoped_release without_lock;
  const splinecore::Pausing pausing(pause);
  return work();
}

/// Calls work(begin, end) on consecutive parts of [0, total) as unlocked() does, and heeds Ctrl-C between them.
template <class Work>
void in_parts(std::size_t total, std::size_t part, Work work) {
  for (std::size_t begin = 0; begin < total; begin += part) {
    unlocked([&] { work(begin, std::min(total, begin + part)); });
    heed(py::none());
  }
}

}  // namespace bindings
