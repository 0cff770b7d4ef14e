#pragma once

#include <pybind11/pybind11.h>

namespace bindings {

/// Makes every function of the module, its classes and its submodules say in a sentence what is wrong with a call
/// that has too few, too many or unknown arguments, or a value of another class, in place of pybind11's list of types.
void explain_wrong_calls(pybind11::module_& module);

}  // namespace bindings
