#include "program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace splinecore {

namespace {

using Name = std::pair<std::string_view, Operation>;

constexpr std::array kFunctions{
    Name{"sin", Operation::sin},     Name{"cos", Operation::cos},     Name{"tan", Operation::tan},
    Name{"asin", Operation::asin},   Name{"acos", Operation::acos},   Name{"atan", Operation::atan},
    Name{"sinh", Operation::sinh},   Name{"cosh", Operation::cosh},   Name{"tanh", Operation::tanh},
    Name{"asinh", Operation::asinh}, Name{"acosh", Operation::acosh}, Name{"atanh", Operation::atanh},
    Name{"exp", Operation::exp},     Name{"log", Operation::log},     Name{"ln", Operation::log},
    Name{"log2", Operation::log2},   Name{"log10", Operation::log10}, Name{"sqrt", Operation::sqrt},
    Name{"cbrt", Operation::cbrt},   Name{"abs", Operation::abs},     Name{"sign", Operation::sign},
    Name{"floor", Operation::floor}, Name{"atan2", Operation::atan2}, Name{"min", Operation::min},
    Name{"max", Operation::max},
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double finite_or_nan(double value) noexcept { return std::isfinite(value) ? value : kNan; }

double raw(const Step& step, double a) noexcept {
  switch (step.operation) {
    case Operation::negate: return -a;
    case Operation::constant_power: return std::pow(a, step.number);
    case Operation::sin: return std::sin(a);
    case Operation::cos: return std::cos(a);
    case Operation::tan: return std::tan(a);
    case Operation::asin: return std::asin(a);
    case Operation::acos: return std::acos(a);
    case Operation::atan: return std::atan(a);
    case Operation::sinh: return std::sinh(a);
    case Operation::cosh: return std::cosh(a);
    case Operation::tanh: return std::tanh(a);
    case Operation::asinh: return std::asinh(a);
    case Operation::acosh: return std::acosh(a);
    case Operation::atanh: return std::atanh(a);
    case Operation::exp: return std::exp(a);
    case Operation::log: return std::log(a);
    case Operation::log2: return std::log2(a);
    case Operation::log10: return std::log10(a);
    case Operation::sqrt: return std::sqrt(a);
    case Operation::cbrt: return std::cbrt(a);
    case Operation::abs: return std::abs(a);
    case Operation::sign: return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0;
    case Operation::floor: return std::floor(a);
    default: return kNan;
  }
}

double raw(Operation operation, double a, double b) noexcept {
  switch (operation) {
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::divide: return a / b;
    case Operation::power: return std::pow(a, b);
    case Operation::atan2: return std::atan2(a, b);
    case Operation::min: return std::min(a, b);
    case Operation::max: return std::max(a, b);
    default: return kNan;
  }
}

}  // namespace

int operand_count(Operation operation) noexcept {
  if (operation <= Operation::variable) return 0;
  return operation < Operation::add ? 1 : 2;
}

std::optional<Operation> function_named(std::string_view name) noexcept {
  const auto found = std::ranges::find(kFunctions, name, &Name::first);
  return found == kFunctions.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> number_named(std::string_view name) noexcept {
  if (name == "pi") return std::numbers::pi;
  if (name == "e") return std::numbers::e;
  return std::nullopt;
}

// pow(NaN, 0) is 1, and comparisons hide a NaN: what has no value is passed on first.
double apply(const Step& step, double a) noexcept {
  return std::isfinite(a) ? finite_or_nan(raw(step, a)) : kNan;
}

double apply(Operation operation, double a, double b) noexcept {
  return std::isfinite(a) && std::isfinite(b) ? finite_or_nan(raw(operation, a, b)) : kNan;
}

void ProgramBuilder::push(const Step& operand) {
  program_.steps.push_back(operand);
  program_.depth = std::max(program_.depth, ++height_);
}

void ProgramBuilder::apply(Operation operation) {
  std::vector<Step>& steps = program_.steps;
  const auto is_number = [&](std::size_t place) { return steps[steps.size() - place].operation == Operation::number; };
  if (operand_count(operation) == 1) {
    if (is_number(1)) {
      steps.back().number = splinecore::apply({operation}, steps.back().number);
    } else {
      steps.push_back({operation});
    }
    return;
  }
  --height_;
  if (is_number(1) && is_number(2)) {
    const double b = steps.back().number;
    steps.pop_back();
    steps.back().number = splinecore::apply(operation, steps.back().number, b);
  } else if (operation == Operation::power && is_number(1)) {
    steps.back().operation = Operation::constant_power;
  } else {
    steps.push_back({operation});
  }
}

}  // namespace splinecore
