#pragma once

#include "arrays.hpp"
#include "splinecore/formula/formula.hpp"

// Formulas as Python hands them over.
namespace bindings {

/// The characters of a str. @throws py::type_error for anything else.
std::string text_argument(const py::handle& value, const char* name);

/// {name: number}, or none at all for None. @throws py::type_error for anything else.
splinecore::Formula::Constants constants_of(const py::object& value);

/// A sequence of str, which are read with these names, and of Formula, which are taken as they are.
/// @throws py::type_error for anything else; FormulaError that names the one which is no formula.
std::vector<splinecore::Formula> formulas_of(const py::object& value, const std::vector<std::string>& variables,
                                             const py::object& constants);

/// A sequence of str. @throws py::type_error for anything else.
std::vector<std::string> names_of(const py::object& value, const char* name);

}  // namespace bindings
