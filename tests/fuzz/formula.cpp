#include "splinecore/formula/formula.hpp"

#include "finding.hpp"
#include "splinecore/build/curve_from_formulas.hpp"
#include "splinecore/formula/evaluate.hpp"
#include "splinecore/formula/polynomial.hpp"
#include "splinecore/formula/taylor.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

constexpr std::array kPlaces{0.0, 1.0, -0.75, 1e-9, 1e200, -3e38};

void check_evaluation(const Formula& formula) {
  const std::vector<std::span<const double>> values(formula.variables().size(), kPlaces);
  std::array<double, kPlaces.size()> marked;
  evaluate(formula, values, marked, AtUndefined::nan);
  attempt([&] {
    std::array<double, kPlaces.size()> raised;
    evaluate(formula, values, raised);
    demand_finite<double>(raised, "the value");
    demand(raised == marked, "a value depends on what is done where there is none");
  });
  std::vector<double> slopes(kPlaces.size() * values.size());
  attempt([&] {
    gradients(formula, values, slopes);
    demand_finite<double>(slopes, "the gradient");
  });
  gradients(formula, values, slopes, AtUndefined::nan);
}

void check_one_variable(const Formula& formula, int order) {
  std::vector<double> out(kPlaces.size() * static_cast<std::size_t>(order + 1));
  attempt([&] {
    derivatives(formula, kPlaces, order, out);
    demand_finite<double>(out, "the derivative");
  });
  derivatives(formula, kPlaces, order, out, AtUndefined::nan);
  attempt([&] {
    const auto coefficients = polynomial(formula, 24);
    if (coefficients) demand(coefficients->size() <= 25, "a polynomial goes over its highest degree");
  });
  const Interval domain{-1.0, 2.0};
  attempt([&] { scaled_bernstein(formula, std::span(&domain, 1), 40); });
  attempt([&] {
    const std::vector<Formula> coordinates{formula, formula};
    const auto curve = curve_from_formulas(coordinates, domain, 0.01);
    demand(curve.error >= 0.0 && curve.error <= 0.01, "a curve of formulas misses its tolerance");
  });
}

}  // namespace

void formula(Input data) {
  Bytes bytes(data);
  const int head = bytes.byte();
  attempt([&] {
    const std::vector<std::string> names{"t", "u", "v"};
    const std::vector<std::string> variables(names.begin(), names.begin() + 1 + head % 3);
    const Formula made = Formula::make(std::string(bytes.rest()), variables, {{"a", 0.25}, {"huge", 1e300}});
    demand(made == Formula::make(made.text(), variables, made.constants()), "a formula is not equal to itself");
    check_evaluation(made);
    if (variables.size() == 1) check_one_variable(made, head / 3 % 9);
    if (variables.size() == 2) {
      const std::array<Interval, 2> domains{Interval{0.0, 1.0}, Interval{-2.0, 5.0}};
      attempt([&] { scaled_bernstein(made, domains, 12); });
    }
  });
}

}  // namespace splinecore::fuzz
