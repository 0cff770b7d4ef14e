#pragma once

#include <span>

#include "splinecore/formula/formula.hpp"

namespace splinecore {

/// How a parameter is treated where a formula has no finite value: refuse the parameter, or mark it with NaN.
///
/// A formula has no value where one of its operations has none: 1 / (1 / t) is undefined at 0.
enum class AtUndefined { raise, nan };

/// The value at each row of variables; values[i] belongs to variable i and has out.size() numbers.
///
/// Does not allocate for each row.
/// @throws InvalidShape if the numbers of spans and variables differ; naming the place where the
///         formula is undefined unless NaN is asked for.
void evaluate(const Formula& formula, std::span<const std::span<const double>> values, std::span<double> out,
              AtUndefined at_undefined = AtUndefined::raise);

/// The same for a formula of one variable.
void evaluate(const Formula& formula, std::span<const double> parameters, std::span<double> out,
              AtUndefined at_undefined = AtUndefined::raise);

}  // namespace splinecore
