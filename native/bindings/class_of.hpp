#pragma once

#include <pybind11/pybind11.h>

namespace bindings {

/// A class that was bound before, to be given more methods.
template <class Value>
pybind11::class_<Value> class_of(const pybind11::module_& module, const char* name) {
  return pybind11::reinterpret_borrow<pybind11::class_<Value>>(module.attr(name));
}

}  // namespace bindings
