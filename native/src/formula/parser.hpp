#pragma once

#include "program.hpp"
#include "splinecore/formula/formula.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A letter or _, then letters, digits and _, all ASCII.
bool is_name(std::string_view text) noexcept;

/// @throws FormulaError where the text is no formula of these names.
Program parse(std::string_view text, const std::vector<std::string>& variables, const Formula::Constants& constants);

}  // namespace splinecore
#pragma GCC visibility pop
