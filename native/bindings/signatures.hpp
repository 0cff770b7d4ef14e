#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace bindings {

/// An argument of a function of the module.
struct Parameter {
  std::string name;
  std::string kind;    ///< the class it must be of; empty for any object
  std::string preset;  ///< what it is unless given; empty if it must be given
  bool is_by_name;     ///< only
};

/// A function as its callers see it, without self.
struct Signature {
  std::string name;
  std::vector<Parameter> parameters;
  bool takes_more = false;  ///< any number by place
};

/// From the first line that pybind11 writes into a documentation: "evaluate(self: …, u: object, *, …) -> …".
Signature signature_of(const std::string& name, const std::string& documentation, bool has_self);

/// "(u, times=1, *, side='right')"; with self it comes first.
std::string list_of(const Signature& signature, bool has_self = false);

/// The documentation of a function, which pybind11 has allocated and will free, replaced.
void replace_documentation(PyMethodDef& definition, const std::string& text);

}  // namespace bindings
