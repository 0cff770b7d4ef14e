#pragma once

#include <pybind11/pybind11.h>

#include <type_traits>
#include <utility>

namespace bindings {

namespace py = pybind11;

// What pybind11 generates for a function depends on all types that it is defined with. So that functions which take and
// give the same share it, lambdas are given as pointers, and texts of all lengths as pointers, too.

inline const char* plain(const char* text) { return text; }
template <class Extra>
const Extra& plain(const Extra& extra)
  requires(!std::is_array_v<Extra>)
{
  return extra;
}

template <class Function>
auto plain_function(Function function) {
  if constexpr (requires { +function; }) {
    return +function;
  } else {
    return function;
  }
}

/// A class of the module.
template <class Value>
class Class : public py::class_<Value> {
 public:
  using Base = py::class_<Value>;
  using Base::Base;

  template <class... Extra>
  Class(py::handle scope, const char* name, const Extra&... extra) : Base(scope, name, plain(extra)...) {}

  template <class Function, class... Extra>
  Class& def(const char* name, Function function, const Extra&... extra) {
    Base::def(name, plain_function(function), plain(extra)...);
    return *this;
  }

  /// Constructors and pickling.
  template <class Made, class... Extra>
  Class& def(Made&& made, const Extra&... extra)
    requires(!std::is_convertible_v<Made, const char*>)
  {
    Base::def(std::forward<Made>(made), plain(extra)...);
    return *this;
  }

  template <class Function, class... Extra>
  Class& def_static(const char* name, Function function, const Extra&... extra) {
    Base::def_static(name, plain_function(function), plain(extra)...);
    return *this;
  }

  template <class Getter, class... Extra>
  Class& def_property_readonly(const char* name, Getter getter, const Extra&... extra) {
    Base::def_property_readonly(name, plain_function(getter), plain(extra)...);
    return *this;
  }
};

/// A class that was bound before, to be given more methods.
template <class Value>
Class<Value> class_of(const py::module_& module, const char* name) {
  return py::reinterpret_borrow<Class<Value>>(module.attr(name));
}

}  // namespace bindings
