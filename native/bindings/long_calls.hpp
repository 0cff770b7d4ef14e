#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "splinecore/base/pause.hpp"

namespace bindings {

namespace py = pybind11;

/// A long call was ended by its caller.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled by the caller") {}
};

/// @throws py::type_error if cancel is neither None nor callable.
void require_callable(const py::object& cancel);

/// Heeds Ctrl-C and `cancel`, a callable that returns true to end the call. With the interpreter's lock.
void heed(const py::object& cancel);

/// As long as it lives, its thread works without the interpreter's lock, and long work heeds Ctrl-C and `cancel`.
class Unlocked {
 public:
  /// @throws py::type_error if cancel is neither None nor callable.
  explicit Unlocked(const py::object& cancel);
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  splinecore::Pause pause_;
  py::gil_scoped_release without_lock_;
  splinecore::Pausing pausing_;
};

/// The result of work that needs no interpreter, done without its lock; it heeds Ctrl-C and `cancel` where it is long.
/// @throws py::type_error if cancel is neither None nor callable.
template <class Work>
auto unlocked(Work work, const py::object& cancel = py::none()) {
  const Unlocked here(cancel);
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
