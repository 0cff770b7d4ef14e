#include "splinecore/formula/taylor.hpp"

#include <algorithm>
#include <cmath>

#include "places.hpp"
#include "series.hpp"

namespace splinecore {

struct Taylor::Stack {
  std::vector<Series> rows;
};

Taylor::Taylor(const Formula& formula, int order) : formula_(formula), coefficients_() {
  require_order(order);
  coefficients_.resize(order + 1);
  stack_ = std::make_unique<Stack>();
  stack_->rows.resize(formula.program().depth);
}

Taylor::~Taylor() = default;
Taylor::Taylor(Taylor&&) noexcept = default;

std::span<const double> Taylor::along(std::span<const double> origin, std::span<const double> direction) {
  const int order = static_cast<int>(coefficients_.size()) - 1;
  Series* end = stack_->rows.data();
  for (const Step& step : formula_.program().steps) {
    const int operands = operand_count(step.operation);
    if (operands == 0) {
      const bool is_number = step.operation == Operation::number;
      *end = Series{order};
      (*end)[0] = is_number ? step.number : origin[step.variable];
      if (!is_number && order > 0) (*end)[1] = direction[step.variable];
      ++end;
    } else if (operands == 1) {
      end[-1] = apply(step, end[-1]);
    } else {
      --end;
      end[-1] = apply(step.operation, end[-1], *end);
    }
  }
  std::copy_n(end[-1].coefficients.begin(), coefficients_.size(), coefficients_.begin());
  return coefficients_;
}

namespace {

double defined_or_nan(double value, const Formula& formula, Places values, std::size_t row, const std::string& what,
                      AtUndefined at_undefined) {
  if (std::isfinite(value)) return value;
  if (at_undefined == AtUndefined::raise) {
    throw InvalidShape("the formula " + quoted(formula.text()) + " has no finite " + what + " at " +
                       place_text(formula, values, row));
  }
  return std::nan("");
}

std::string derivative_name(int k) { return k == 0 ? "value" : "derivative of order " + std::to_string(k); }

}  // namespace

void derivatives(const Formula& formula, std::span<const double> parameters, int order, std::span<double> out,
                 AtUndefined at_undefined) {
  require_order(order);
  const Places values(&parameters, 1);
  require_places(formula, values, parameters.size());
  Taylor taylor(formula, order);
  const double one = 1.0;
  double* row = out.data();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto coefficients = taylor.along({&parameters[i], 1}, {&one, 1});
    double factorial = 1.0;
    for (int k = 0; k <= order; ++k) {
      if (k > 0) factorial *= k;
      *row++ = defined_or_nan(factorial * coefficients[k], formula, values, i, derivative_name(k), at_undefined);
    }
  }
}

void gradients(const Formula& formula, Places values, std::span<double> out, AtUndefined at_undefined) {
  const std::size_t variables = formula.variables().size();
  require_places(formula, values, out.size() / variables);
  Taylor taylor(formula, 1);
  std::vector<double> origin(variables);
  std::vector<double> direction(variables, 0.0);
  for (std::size_t row = 0; row < out.size() / variables; ++row) {
    for (std::size_t i = 0; i < variables; ++i) origin[i] = values[i][row];
    for (std::size_t i = 0; i < variables; ++i) {
      direction[i] = 1.0;
      const double slope = taylor.along(origin, direction)[1];
      direction[i] = 0.0;
      out[row * variables + i] = defined_or_nan(slope, formula, values, row, "derivative by " + formula.variables()[i],
                                                at_undefined);
    }
  }
}

}  // namespace splinecore
