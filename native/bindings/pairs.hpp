#pragma once

#include "classes.hpp"

namespace bindings {

/// A result that unpacks, and is indexed, as (value, error).
template <class Pair>
void bind_pair(Class<Pair>& cls) {
  cls.def("__iter__", [](const Pair& self) { return py::iter(py::make_tuple(self.value, self.error)); });
  cls.def("__len__", [](const Pair&) { return 2; });
  cls.def("__getitem__", [](const Pair& self, const py::object& i) {
    return py::object(py::make_tuple(self.value, self.error)[i]);
  });
}

}  // namespace bindings
