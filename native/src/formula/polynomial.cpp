#include "splinecore/formula/polynomial.hpp"

#include <algorithm>
#include <cmath>

#include "program.hpp"

namespace splinecore {

namespace {

/// Homogeneous in (s, t) for each of two variables: the sum of c_ij s_u^(m-i) t_u^i s_v^(n-j) t_v^j.
///
/// What s and t stand for is decided by LinearForms alone: sums and products are the same in all forms.
using Polynomial = ScaledBernstein;

/// The linear forms a s + b t that the number 1 and the variable are.
struct LinearForms {
  double one[2];
  double variable[2];
};

constexpr LinearForms kPowers{{1.0, 0.0}, {0.0, 1.0}};

LinearForms bernstein_frame(const Interval& domain) { return {{1.0, 1.0}, {domain.start, domain.end}}; }

Polynomial number(double value) { return {0, 0, {value}}; }

Polynomial linear(const double (&form)[2], int variable) {
  return {variable == 0 ? 1 : 0, variable == 0 ? 0 : 1, {form[0], form[1]}};
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial out{a.degree_u + b.degree_u, a.degree_v + b.degree_v, {}};
  const int width = out.degree_v + 1;
  out.coefficients.resize((out.degree_u + 1) * width);
  for (int i = 0; i <= a.degree_u; ++i) {
    for (int j = 0; j <= a.degree_v; ++j) {
      const double factor = a.coefficients[i * (a.degree_v + 1) + j];
      for (int k = 0; k <= b.degree_u; ++k) {
        const double* row = b.coefficients.data() + k * (b.degree_v + 1);
        double* to = out.coefficients.data() + (i + k) * width + j;
        for (int l = 0; l <= b.degree_v; ++l) to[l] += factor * row[l];
      }
    }
  }
  return out;
}

bool is_finite(const Polynomial& a) {
  return std::ranges::all_of(a.coefficients, [](double c) { return std::isfinite(c); });
}

bool is_number(const Polynomial& a) { return a.degree_u == 0 && a.degree_v == 0; }

/// Runs a program on polynomials instead of numbers; stops where one of them is none.
class PolynomialMachine {
 public:
  PolynomialMachine(std::vector<LinearForms> frames, int highest_degree)
      : frames_(std::move(frames)), highest_degree_(highest_degree) {}

  std::optional<Polynomial> run(const Program& program) {
    for (const Step& step : program.steps) {
      if (!apply_step(step)) return std::nullopt;
      if (!is_finite(stack_.back())) return std::nullopt;
    }
    return std::move(stack_.back());
  }

 private:
  bool apply_step(const Step& step);
  bool apply_operation(Operation operation, Polynomial& a, const Polynomial& b);
  bool multiply(Polynomial& a, const Polynomial& b) const;
  bool raise(Polynomial& a, double exponent) const;
  Polynomial elevated(Polynomial a, int degree_u, int degree_v) const;

  std::vector<LinearForms> frames_;
  int highest_degree_;
  std::vector<Polynomial> stack_;
};

bool PolynomialMachine::apply_step(const Step& step) {
  switch (step.operation) {
    case Operation::number: stack_.push_back(number(step.number)); return true;
    case Operation::variable: stack_.push_back(linear(frames_[step.variable].variable, step.variable)); return true;
    case Operation::negate: return multiply(stack_.back(), number(-1.0));
    case Operation::constant_power: return raise(stack_.back(), step.number);
    default: break;
  }
  if (operand_count(step.operation) == 1) return false;
  const Polynomial b = std::move(stack_.back());
  stack_.pop_back();
  return apply_operation(step.operation, stack_.back(), b);
}

bool PolynomialMachine::apply_operation(Operation operation, Polynomial& a, const Polynomial& b) {
  if (operation == Operation::multiply) return multiply(a, b);
  if (operation == Operation::divide) {
    if (!is_number(b)) return false;
    for (double& c : a.coefficients) c /= b.coefficients[0];
    return true;
  }
  if (operation != Operation::add && operation != Operation::subtract) return false;
  const int degree_u = std::max(a.degree_u, b.degree_u);
  const int degree_v = std::max(a.degree_v, b.degree_v);
  a = elevated(std::move(a), degree_u, degree_v);
  const Polynomial other = elevated(b, degree_u, degree_v);
  const double sign = operation == Operation::add ? 1.0 : -1.0;
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) a.coefficients[i] += sign * other.coefficients[i];
  return true;
}

bool PolynomialMachine::multiply(Polynomial& a, const Polynomial& b) const {
  if (std::max(a.degree_u + b.degree_u, a.degree_v + b.degree_v) > highest_degree_) return false;
  a = product(a, b);
  return true;
}

bool PolynomialMachine::raise(Polynomial& a, double exponent) const {
  const bool whole = exponent >= 0.0 && std::trunc(exponent) == exponent;
  if (!whole || exponent * std::max(a.degree_u, a.degree_v) > highest_degree_) return false;
  Polynomial power = std::move(a);
  a = number(1.0);
  for (int rest = static_cast<int>(exponent); rest > 0; rest /= 2) {
    if (rest % 2 == 1) a = product(a, power);
    if (rest > 1) power = product(power, power);
  }
  return true;
}

Polynomial PolynomialMachine::elevated(Polynomial a, int degree_u, int degree_v) const {
  while (a.degree_u < degree_u) a = product(a, linear(frames_[0].one, 0));
  while (a.degree_v < degree_v) a = product(a, linear(frames_[1].one, 1));
  return a;
}

}  // namespace

std::optional<std::vector<double>> polynomial(const Formula& formula, int highest_degree) {
  if (formula.variables().size() != 1) {
    throw InvalidShape("the formula " + quoted(formula.text()) + " has " + std::to_string(formula.variables().size()) +
                       " variables: coefficients are those of one");
  }
  auto found = PolynomialMachine({kPowers}, highest_degree).run(formula.program());
  if (!found) return std::nullopt;
  std::vector<double> coefficients = std::move(found->coefficients);
  while (coefficients.size() > 1 && coefficients.back() == 0.0) coefficients.pop_back();
  return coefficients;
}

std::optional<ScaledBernstein> scaled_bernstein(const Formula& formula, std::span<const Interval> domains,
                                                int highest_degree) {
  const std::size_t count = formula.variables().size();
  if (count > 2 || count != domains.size()) {
    throw InvalidShape("the formula " + quoted(formula.text()) + " has " + std::to_string(count) + " variables and " +
                       std::to_string(domains.size()) + " domains: one or two of each are expected");
  }
  std::vector<LinearForms> frames;
  for (const Interval& domain : domains) frames.push_back(bernstein_frame(domain));
  return PolynomialMachine(std::move(frames), highest_degree).run(formula.program());
}

}  // namespace splinecore
