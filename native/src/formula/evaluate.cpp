#include "splinecore/formula/evaluate.hpp"

#include <algorithm>
#include <cmath>

#include "places.hpp"
#include "program.hpp"

namespace splinecore {

namespace {

/// So many parameters go through a step at once; one row of the stack holds as many.
constexpr std::size_t kBlock = 256;

/// Leaves the values of parameters begin … begin + count in the first row of the stack.
void run(const Program& program, Places values, std::size_t begin, std::size_t count, double* stack) {
  double* end = stack;
  for (const Step& step : program.steps) {
    switch (operand_count(step.operation)) {
      case 0:
        if (step.operation == Operation::number) {
          std::fill_n(end, count, step.number);
        } else {
          std::copy_n(values[step.variable].data() + begin, count, end);
        }
        end += kBlock;
        break;
      case 1: {
        double* a = end - kBlock;
        for (std::size_t i = 0; i < count; ++i) a[i] = apply(step, a[i]);
        break;
      }
      default: {
        end -= kBlock;
        double* a = end - kBlock;
        for (std::size_t i = 0; i < count; ++i) a[i] = apply(step.operation, a[i], end[i]);
      }
    }
  }
}

}  // namespace

void require_places(const Formula& formula, Places values, std::size_t count) {
  if (values.size() != formula.variables().size()) {
    throw InvalidShape("the formula " + quoted(formula.text()) + " has " + std::to_string(formula.variables().size()) +
                       " variables, " + std::to_string(values.size()) + " values are given");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].size() == count) continue;
    throw InvalidShape(formula.variables()[i] + " has " + std::to_string(values[i].size()) + " values for " +
                       std::to_string(count) + " results");
  }
}

std::string place_text(const Formula& formula, Places values, std::size_t row) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i == 0 ? "" : ", ") + formula.variables()[i] + " = " + text_of(values[i][row]);
  }
  return text;
}

void evaluate(const Formula& formula, Places values, std::span<double> out, AtUndefined at_undefined) {
  require_places(formula, values, out.size());
  const Program& program = formula.program();
  std::vector<double> stack(program.depth * kBlock);
  for (std::size_t begin = 0; begin < out.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, out.size() - begin);
    run(program, values, begin, count, stack.data());
    for (std::size_t i = 0; i < count; ++i) {
      if (!std::isfinite(stack[i])) {
        if (at_undefined == AtUndefined::raise) {
          throw InvalidShape("the formula " + quoted(formula.text()) + " has no finite value at " +
                             place_text(formula, values, begin + i));
        }
        stack[i] = std::nan("");
      }
      out[begin + i] = stack[i];
    }
  }
}

void evaluate(const Formula& formula, std::span<const double> parameters, std::span<double> out,
              AtUndefined at_undefined) {
  evaluate(formula, Places(&parameters, 1), out, at_undefined);
}

}  // namespace splinecore
