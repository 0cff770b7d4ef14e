#include "long_calls.hpp"

#include <string>

namespace bindings {

namespace {

bool is_true(const py::object& answer) {
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw py::error_already_set();
  return truth != 0;
}

splinecore::Pause pause_for(const py::object& cancel) {
  require_callable(cancel);
  return [&cancel] {
    const py::gil_scoped_acquire locked;
    heed(cancel);
  };
}

}  // namespace

void require_callable(const py::object& cancel) {
  if (!cancel.is_none() && PyCallable_Check(cancel.ptr()) == 0) {
    throw py::type_error("cancel = " + std::string(py::repr(cancel)) + " is not callable");
  }
}

void heed(const py::object& cancel) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!cancel.is_none() && is_true(cancel())) throw Cancelled();
}

Unlocked::Unlocked(const py::object& cancel) : pause_(pause_for(cancel)), pausing_(pause_) {}

Unlocked::~Unlocked() = default;

}  // namespace bindings
