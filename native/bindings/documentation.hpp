#pragma once

#include <pybind11/pybind11.h>

#include <span>

namespace bindings {

/// What the stubs say of a name below the module, as "NurbsCurve.evaluate".
struct Documented {
  const char* name;
  const char* text;
};

/// All of them, ordered by name; made from the stubs.
std::span<const Documented> documentation();

/// Gives functions, methods, properties and classes what the stubs say of them, and signatures that inspect reads.
void document(pybind11::module_& module);

}  // namespace bindings
