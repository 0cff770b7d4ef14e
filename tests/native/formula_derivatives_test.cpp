#include <numbers>

#include "splinecore/base/order.hpp"
#include "splinecore/formula/taylor.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

std::vector<double> derivatives_of(const std::string& text, double t, int order, AtUndefined at = AtUndefined::raise) {
  std::vector<double> out(order + 1);
  derivatives(Formula::make(text, {"t"}), {&t, 1}, order, out, at);
  return out;
}

double factorial(int n) { return std::tgamma(n + 1.0); }

/// Coefficients of the series, on which errors of all orders are alike.
std::vector<double> coefficients_of(const std::string& text, double t, int order) {
  std::vector<double> values = derivatives_of(text, t, order);
  for (int k = 0; k <= order; ++k) values[k] /= factorial(k);
  return values;
}

TEST(FormulaDerivatives, AreThoseOfKnownFunctionsUpToTheHighestOrder) {
  const double t = 0.8;
  const auto expect = [&](const std::string& text, auto exact) {
    const std::vector<double> found = derivatives_of(text, t, kMaxOrder);
    for (int k = 0; k <= kMaxOrder; ++k) {
      const double wanted = exact(k);
      EXPECT_NEAR(found[k], wanted, 1e-12 * (factorial(k) + std::abs(wanted))) << text << " " << k;
    }
  };
  const double quarter = 0.5 * std::numbers::pi;
  expect("sin(2*t)", [&](int k) { return std::exp2(k) * std::sin(2.0 * t + k * quarter); });
  expect("cos(t)", [&](int k) { return std::cos(t + k * quarter); });
  expect("exp(-3*t)", [&](int k) { return std::pow(-3.0, k) * std::exp(-3.0 * t); });
  expect("2^t", [&](int k) { return std::pow(std::numbers::ln2, k) * std::exp2(t); });
  expect("sinh(t)", [&](int k) { return k % 2 == 0 ? std::sinh(t) : std::cosh(t); });
  expect("cosh(t)", [&](int k) { return k % 2 == 0 ? std::cosh(t) : std::sinh(t); });
  expect("1/(1 - t)", [&](int k) { return factorial(k) / std::pow(1.0 - t, k + 1); });
  expect("log(t)", [&](int k) { return k == 0 ? std::log(t) : -factorial(k - 1) / std::pow(-t, k); });
  expect("atan(t)", [&](int k) {
    const double angle = std::atan(t);
    return k == 0 ? angle : factorial(k - 1) * std::pow(std::cos(angle), k) * std::sin(k * (angle + quarter));
  });
  for (const double exponent : {0.5, 2.5, -1.5, 7.0, -3.0}) {
    expect("t^" + text_of(exponent), [&](int k) {
      double factor = 1.0;
      for (int i = 0; i < k; ++i) factor *= exponent - i;
      return factor * std::pow(t, exponent - k);
    });
  }
}

TEST(FormulaDerivatives, OfAFunctionAfterItsInverseAreThoseOfTheParameter) {
  for (const std::string text :
       {"sin(asin(t))", "cos(acos(t))", "tan(atan(t))", "sinh(asinh(t))", "cosh(acosh(t + 1)) - 1", "tanh(atanh(t))",
        "exp(log(t))", "log(exp(t))", "2^log2(t)", "10^log10(t)", "sqrt(t)^2", "cbrt(t)^3", "-cbrt(-t^3)",
        "atan2(sin(t), cos(t))",
        "t^pi^(1/pi)*t/t^(pi^(1/pi))", "abs(-t)", "max(t, -t)", "min(t, 1)",
        "(1 + t)^20.5/(1 + t)^19.5 - 1", "t + floor(t)"}) {
    for (const double t : {0.21, 0.5, 0.77}) {
      const std::vector<double> found = coefficients_of(text, t, 8);
      const double scale = 1e-10;
      EXPECT_NEAR(found[0], t, scale) << text;
      EXPECT_NEAR(found[1], 1.0, scale) << text;
      for (int k = 2; k <= 8; ++k) EXPECT_NEAR(found[k], 0.0, scale * std::pow(10.0, k)) << text << " " << k;
    }
  }
}

TEST(FormulaDerivatives, OfAHighPowerAreItsOwn) {
  const std::vector<double> found = derivatives_of("t^1500", 1.01, 3);
  double wanted = std::pow(1.01, 1500.0);
  for (int k = 0; k <= 3; wanted *= (1500.0 - k) / 1.01, ++k) EXPECT_NEAR(found[k] / wanted, 1.0, 1e-12);
  EXPECT_EQ(derivatives_of("t^1500", 0.0, 64), std::vector<double>(65, 0.0));
}

TEST(FormulaDerivatives, ObeyTheEquationsOfTheirFunctions) {
  Random random(5);
  for (const double t : random_parameters(random, {-1.2, 1.2}, 20)) {
    // y = tan: y'' = 2 y y'; y = tanh: y'' = -2 y y'; y = t^t: y' = y (1 + log t).
    const auto tangent = derivatives_of("tan(t)", t, 2);
    EXPECT_NEAR(tangent[2], 2.0 * tangent[0] * tangent[1], 1e-12 * (1.0 + std::abs(tangent[2])));
    const auto hyperbolic = derivatives_of("tanh(t)", t, 2);
    EXPECT_NEAR(hyperbolic[2], -2.0 * hyperbolic[0] * hyperbolic[1], 1e-14);
    const auto power = derivatives_of("(t + 2)^(t + 2)", t, 1);
    EXPECT_NEAR(power[1], power[0] * (1.0 + std::log(t + 2.0)), 1e-13 * power[0]);
  }
}

TEST(FormulaDerivatives, OfPolynomialsStayExactAtTheirZeros) {
  EXPECT_EQ(derivatives_of("(t - 1)^3", 1.0, 5), (std::vector<double>{0, 0, 0, 6, 0, 0}));
  EXPECT_EQ(derivatives_of("t^4/2 + t", 0.0, 5), (std::vector<double>{0, 1, 0, 0, 12, 0}));
  EXPECT_EQ(derivatives_of("t^0", 0.0, 1), (std::vector<double>{1, 0}));
  EXPECT_EQ(derivatives_of("(t^2 + 1e-9)^2", 0.0, 4)[4], 24.0);
}

TEST(FormulaDerivatives, TheFirstIsWhatEvaluationGives) {
  for (const std::string text : {"sin(t)^3.5 + t^7", "atan2(t, 2)/cbrt(t)", "exp(t)^t", "log10(t) - t^-3"}) {
    const double t = 0.63;
    double value = 0.0;
    evaluate(Formula::make(text, {"t"}), {&t, 1}, {&value, 1});
    EXPECT_EQ(derivatives_of(text, t, 3)[0], value) << text;
  }
}

/// How many derivatives exist at 0, of the first four.
int existing(const std::string& text) {
  const std::vector<double> values = derivatives_of(text, 0.0, 3, AtUndefined::nan);
  const auto missing = std::ranges::find_if(values, [](double value) { return std::isnan(value); });
  return static_cast<int>(missing - values.begin());
}

TEST(FormulaDerivatives, EndAtKinksJumpsAndVerticalEnds) {
  EXPECT_EQ(existing("abs(t)"), 1);
  EXPECT_EQ(existing("abs(t^2)"), 4);
  EXPECT_EQ(existing("abs(t^3)"), 3);
  EXPECT_EQ(existing("max(t, t^2)"), 1);
  EXPECT_EQ(existing("max(t + t^2, t)"), 4);
  EXPECT_EQ(existing("sign(t)"), 1);
  EXPECT_EQ(existing("floor(t)"), 1);
  EXPECT_EQ(existing("floor(t + 0.5)"), 4);
  EXPECT_EQ(existing("sqrt(t)"), 1);
  EXPECT_EQ(existing("t^1.5"), 2);
  EXPECT_EQ(existing("cbrt(t)"), 1);
  EXPECT_EQ(existing("asin(1 - t)"), 1);
  EXPECT_EQ(existing("atan2(t, -1)"), 1);
  EXPECT_EQ(existing("atan2(t, 1)"), 4);
  EXPECT_EQ(existing("1/t"), 0);
  EXPECT_EQ(refusal([] { derivatives_of("abs(t)", 0.0, 2); }),
            "the formula 'abs(t)' has no finite derivative of order 1 at t = 0");
  EXPECT_EQ(refusal([] { derivatives_of("t", 0.0, 65); }), "order = 65 is outside [0, 64]");
}

TEST(FormulaDerivatives, FormTheGradientOfManyVariables) {
  const Formula formula = Formula::make("x^2*sin(y) + x/z", {"x", "y", "z"});
  const double at[]{1.5, 0.4, 2.0};
  const std::span<const double> values[]{{&at[0], 1}, {&at[1], 1}, {&at[2], 1}};
  std::vector<double> found(3);
  gradients(formula, values, found);
  EXPECT_NEAR(found[0], 3.0 * std::sin(0.4) + 0.5, 1e-15);
  EXPECT_NEAR(found[1], 2.25 * std::cos(0.4), 1e-15);
  EXPECT_NEAR(found[2], -0.375, 1e-15);
  Taylor along(formula, 2);
  const double direction[]{1.0, -1.0, 0.0};
  // f_xx / 2 - f_xy + f_yy / 2
  EXPECT_NEAR(along.along(at, direction)[2], std::sin(0.4) - 3.0 * std::cos(0.4) - 1.125 * std::sin(0.4), 1e-14);
}

}  // namespace
}  // namespace splinecore
