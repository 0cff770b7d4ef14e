#include "splinecore/formula/formula.hpp"

#include <cmath>
#include <set>

#include "base/printable.hpp"
#include "parser.hpp"
#include "program.hpp"

namespace splinecore {

namespace {

/// @throws InvalidShape unless the name can be given a meaning, and has none yet.
void require_free(const std::string& name, const std::string& argument, std::set<std::string>& taken) {
  const auto refuse = [&](const std::string& why) { throw InvalidShape(argument + " = " + quoted(name) + why); };
  if (!is_name(name)) refuse(" is no name: a letter, then letters, digits and _ are expected");
  if (function_named(name)) refuse(" is the name of a function");
  if (number_named(name)) refuse(" is the name of a number");
  if (!taken.insert(name).second) refuse(" is taken twice");
}

}  // namespace

FormulaError::FormulaError(const std::string& what, std::size_t position)
    : InvalidShape(what + " at character " + std::to_string(position)), reason_(what), position_(position) {}

Formula Formula::make(std::string text, std::vector<std::string> variables, Constants constants) {
  if (variables.empty()) throw InvalidShape("variables is empty: a formula needs one or more");
  std::set<std::string> taken;
  for (std::size_t i = 0; i < variables.size(); ++i) require_free(variables[i], "variables" + index_text(i), taken);
  for (const auto& [name, value] : constants) {
    require_free(name, "a name in constants", taken);
    if (std::isfinite(value)) continue;
    throw InvalidShape("constants[" + quoted(name) + "] = " + text_of(value) + " is not finite");
  }
  auto program = std::make_shared<const Program>(parse(text, variables, constants));
  return Formula(std::make_shared<const State>(
      State{std::move(text), std::move(variables), std::move(constants), std::move(program)}));
}

bool operator==(const Formula& a, const Formula& b) noexcept {
  return a.state_ == b.state_ ||
         (a.text() == b.text() && a.variables() == b.variables() && a.constants() == b.constants());
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 60;
  return "'" + printable(text, kShown) + "'";
}

}  // namespace splinecore
