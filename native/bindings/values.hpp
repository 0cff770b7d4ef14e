#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "splinecore/base/errors.hpp"
#include "splinecore/exchange/json.hpp"

namespace bindings {

namespace py = pybind11;

/// The C++ value that a Python object holds, if it is one of the variant's kinds.
template <class... Kinds>
bool unwrap(const py::handle& object, std::optional<std::variant<Kinds...>>& value) {
  const auto try_kind = [&](auto* kind) {
    using Kind = std::remove_pointer_t<decltype(kind)>;
    if (!py::isinstance<Kind>(object)) return false;
    value.emplace(py::cast<const Kind&>(object));
    return true;
  };
  return (try_kind(static_cast<Kinds*>(nullptr)) || ...);
}

template <class... Kinds>
py::object wrap(const std::variant<Kinds...>& value) {
  return std::visit([](const auto& shape) { return py::cast(shape); }, value);
}

/// Only objects that a constructor of this very module made are taken for a Shape.
///
/// Refused are those that Shape.__new__ gave and no constructor filled, and those of another copy of
/// the module, which may be of another version: pybind11 would hand them over by these attributes.
template <class Shape>
void seal(py::class_<Shape>& cls) {
  auto* type = py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(cls.ptr()));
  type->operator_new = [](std::size_t) -> void* { throw py::type_error("the value was not made by its constructor"); };
  for (const char* door : {PYBIND11_MODULE_LOCAL_ID, "_pybind11_conduit_v1_"}) {
    if (py::hasattr(cls, door)) py::delattr(cls, door);
  }
}

/// Comparison, hash, pickle, copy and text of an immutable value.
template <class Shape>
void bind_value(py::class_<Shape>& cls) {
  using splinecore::Value;
  seal(cls);
  cls.def("__eq__", [](const Shape& self, const Shape& other) { return self == other; }, py::is_operator());
  cls.def("__hash__", [](const Shape& self) {
    // Zeros of both signs are equal, so they must have one hash.
    std::string text = splinecore::to_json(Value(self));
    for (std::size_t at = text.find("-0.0"); at != std::string::npos; at = text.find("-0.0", at + 1)) {
      const bool whole = at + 4 == text.size() || text[at + 4] == ',' || text[at + 4] == ']';
      if (whole) text.erase(at, 1);
    }
    return std::hash<std::string>()(text);
  });
  cls.def("__copy__", [](const Shape& self) { return self; });
  cls.def("__deepcopy__", [](const Shape& self, const py::object&) { return self; });
  cls.def(py::pickle([](const Shape& self) { return splinecore::to_json(Value(self)); },
                     [](const std::string& text) {
                       return std::get<Shape>(std::get<Value>(splinecore::from_json(text)));
                     }));
  cls.def("dumps", [](const Shape& self) { return splinecore::to_json(Value(self)); },
          "JSON text that loads() reads back equal in every bit.");
}

}  // namespace bindings
