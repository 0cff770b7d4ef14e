#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "classes.hpp"
#include "hashes.hpp"
#include "long_calls.hpp"
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

/// Closes a class: only objects that a constructor of this very module made are taken for its values, nothing can be
/// derived from it, a copy is the value itself, and what has no state to pickle says so.
void seal(const py::object& cls);

/// The members of a pickled state. @throws py::type_error unless it is a tuple of so many.
py::tuple state_of_size(const py::object& state, std::size_t size);

/// Comparison, hash, pickle and text of an immutable value.
template <class Shape>
void bind_value(Class<Shape>& cls) {
  using splinecore::Value;
  seal(cls);
  const auto text_of = [](const Shape& self) { return unlocked([&] { return splinecore::to_json(Value(self)); }); };
  cls.def("__eq__", [](const Shape& self, const Shape& other) { return self == other; }, py::is_operator());
  cls.def("__hash__", [](const Shape& self) { return hash_of(self); });
  cls.def(py::pickle(text_of, [](const std::string& text) {
    const auto document = unlocked([&] { return splinecore::from_json(text); });
    const auto* value = std::get_if<Value>(&document);
    const auto* shape = value == nullptr ? nullptr : std::get_if<Shape>(value);
    if (shape == nullptr) throw splinecore::InvalidShape("the state is of another kind");
    return *shape;
  }));
  cls.def("dumps", text_of);
}

}  // namespace bindings
