#pragma once

#include <optional>
#include <string_view>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

enum class Operation {
  number, variable,
  negate, constant_power,
  sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh,
  exp, log, log2, log10, sqrt, cbrt, abs, sign, floor,
  add, subtract, multiply, divide, power, atan2, min, max,
};

/// What is put in place of the operands on top of the stack.
struct Step {
  Operation operation;
  /// The number, or the exponent of a constant power.
  double number = 0.0;
  int variable = 0;
};

/// An expression in postfix order, and the highest stack that it needs.
struct Program {
  std::vector<Step> steps;
  int depth = 0;
};

int operand_count(Operation operation) noexcept;

/// The function that a formula calls by this name.
std::optional<Operation> function_named(std::string_view name) noexcept;

/// pi or e.
std::optional<double> number_named(std::string_view name) noexcept;

/// The result of a step; NaN where there is no finite one.
double apply(const Step& step, double a) noexcept;
double apply(Operation operation, double a, double b) noexcept;

/// Puts steps together; what does not depend on a variable is computed at once.
class ProgramBuilder {
 public:
  void push(const Step& operand);
  void apply(Operation operation);
  Program take() { return std::move(program_); }

 private:
  Program program_;
  int height_ = 0;
};

}  // namespace splinecore
#pragma GCC visibility pop
