#include "values.hpp"

#include <vector>

namespace bindings {

namespace {

[[noreturn]] void* refuse_to_make(std::size_t) {
  throw py::type_error("the value was not made by its constructor");
}

/// pybind11 ends the process where the root of its classes is called, as pickle does on protocols 0 and 1: no C++ type
/// belongs to it. With one, of which nothing is ever made, the call reaches the root's __init__, a TypeError.
void settle_root(PyTypeObject* root) {
  auto& types = const_cast<std::vector<py::detail::type_info*>&>(py::detail::all_type_info(root));
  if (!types.empty()) return;
  auto* nothing = new py::detail::type_info{};  // for as long as the root, which is for ever
  nothing->type = root;
  nothing->cpptype = &typeid(void);
  nothing->operator_new = &refuse_to_make;
  types.push_back(nothing);
}

/// (how to make it, with what, its state), for any protocol.
py::tuple reduced(const py::object& self) {
  const py::type kind = py::type::of(self);
  if (!py::hasattr(kind, "__setstate__")) {
    throw py::type_error("cannot pickle '" + std::string(py::str(kind.attr("__name__"))) +
                         "' object: keep what it was made from");
  }
  return py::make_tuple(py::module_::import("copyreg").attr("__newobj__"), py::make_tuple(kind),
                        self.attr("__getstate__")());
}

}  // namespace

void seal(const py::object& cls) {
  auto* type = reinterpret_cast<PyTypeObject*>(cls.ptr());
  settle_root(type->tp_base);
  // Of objects that __new__ gave and no constructor filled.
  py::detail::get_type_info(type)->operator_new = &refuse_to_make;
  // By these attributes pybind11 would hand over objects of another copy of the module, perhaps of another version.
  for (const char* door : {PYBIND11_MODULE_LOCAL_ID, "_pybind11_conduit_v1_"}) {
    if (py::hasattr(cls, door)) py::delattr(cls, door);
  }
  const auto add = [&cls](const char* name, auto method) {
    cls.attr(name) = py::cpp_function(method, py::name(name), py::is_method(cls));
  };
  add("__copy__", [](const py::object& self) { return self; });
  add("__deepcopy__", [](const py::object& self, const py::object&) { return self; });
  add("__reduce__", &reduced);
  type->tp_flags &= ~Py_TPFLAGS_BASETYPE;
  PyType_Modified(type);
}

py::tuple state_of_size(const py::object& state, std::size_t size) {
  if (py::isinstance<py::tuple>(state) && py::len(state) == size) return state;
  throw py::type_error("the state must be a tuple of " + std::to_string(size));
}

}  // namespace bindings
