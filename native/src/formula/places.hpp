#pragma once

#include <span>
#include <string>

#include "splinecore/formula/formula.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// For each variable its values, one a row.
using Places = std::span<const std::span<const double>>;

/// @throws InvalidShape unless there are so many values of each variable.
void require_places(const Formula& formula, Places values, std::size_t count);

/// "u = 0.5, v = 1"
std::string place_text(const Formula& formula, Places values, std::size_t row);

}  // namespace splinecore
#pragma GCC visibility pop
