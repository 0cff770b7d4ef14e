#pragma once

#include <span>
#include <vector>

#include "splinecore/formula/evaluate.hpp"
#include "splinecore/formula/formula.hpp"

namespace splinecore {

/// Expands a formula into powers of s on lines origin + s * direction.
///
/// Truncated power series go through the formula instead of numbers, so the coefficients are as
/// exact as the values (Griewank and Walther, Evaluating Derivatives, chapter 13). Keeps its memory
/// from one expansion to the next.
class Taylor {
 public:
  /// @throws InvalidShape unless 0 <= order <= kMaxOrder.
  Taylor(const Formula& formula, int order);
  ~Taylor();
  Taylor(Taylor&&) noexcept;

  /// order + 1 coefficients, good until the next call; both arguments have a number for each variable.
  /// NaN from the first that does not exist: at a kink, a jump or the vertical end of a root. Where
  /// the argument of a root is zero, what its own truncated series cannot tell counts as missing.
  std::span<const double> along(std::span<const double> origin, std::span<const double> direction);

 private:
  struct Stack;
  Formula formula_;
  std::vector<double> coefficients_;
  std::unique_ptr<Stack> stack_;
};

/// The value and its derivatives up to `order` by the one variable; out.size() == (order + 1) * parameters.size().
/// @throws InvalidShape if the formula has more variables, for the order, or naming the parameter and the
///         derivative that does not exist unless NaN is asked for.
void derivatives(const Formula& formula, std::span<const double> parameters, int order, std::span<double> out,
                 AtUndefined at_undefined = AtUndefined::raise);

/// The first derivatives by each variable, row after row; out.size() == variables * rows.
/// @throws InvalidShape as evaluate() does.
void gradients(const Formula& formula, std::span<const std::span<const double>> values, std::span<double> out,
               AtUndefined at_undefined = AtUndefined::raise);

}  // namespace splinecore
