#include "splinecore/formula/polynomial.hpp"

#include "splinecore/basis/bernstein.hpp"
#include "splinecore/formula/evaluate.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;
using Coefficients = std::vector<double>;

std::optional<Coefficients> coefficients(const std::string& text) {
  return polynomial(Formula::make(text, {"t"}), kMaxDegree);
}

TEST(FormulaPolynomial, FindsTheCoefficientsLowestFirst) {
  EXPECT_EQ(coefficients("t"), (Coefficients{0, 1}));
  EXPECT_EQ(coefficients("t*(t+1)^2"), (Coefficients{0, 1, 2, 1}));
  EXPECT_EQ(coefficients("-(2 - t)*3/4"), (Coefficients{-1.5, 0.75}));
  EXPECT_EQ(coefficients("2^3 + sin(0)"), (Coefficients{8}));
  EXPECT_EQ(coefficients("t^0"), (Coefficients{1}));
  EXPECT_EQ(coefficients("(t+1)^2 - t^2"), (Coefficients{1, 2}));
  EXPECT_EQ(coefficients("t - t"), (Coefficients{0}));
  EXPECT_EQ(coefficients("t^(1+1)"), (Coefficients{0, 0, 1}));
}

TEST(FormulaPolynomial, FindsNothingElsewhere) {
  for (const std::string text : {"1/t", "t^-1", "t^0.5", "sin(t)", "2^t", "t^t", "abs(t)", "t/0", "t^256",
                                 "(t^16)^16", "1e300*t*1e300"}) {
    EXPECT_EQ(coefficients(text), std::nullopt) << text;
  }
  EXPECT_EQ(coefficients("t^255")->size(), 256U);
  EXPECT_EQ(refusal([] { polynomial(Formula::make("u*v", {"u", "v"}), 9); }),
            "the formula 'u*v' has 2 variables: coefficients are those of one");
}

TEST(FormulaPolynomial, InBernsteinFormHasTheValuesOfTheFormula) {
  const Formula formula = Formula::make("(u - 1)^3*v - u*(v^2 + 2)/3", {"u", "v"});
  const Interval domains[]{{-1.0, 2.0}, {3.0, 7.0}};
  const auto found = scaled_bernstein(formula, domains, kMaxDegree);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->degree_u, 3);
  EXPECT_EQ(found->degree_v, 2);
  Random random(9);
  for (int n = 0; n < 50; ++n) {
    const double s = real(random, 0.0, 1.0);
    const double r = real(random, 0.0, 1.0);
    double sum = 0.0;
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; j <= 2; ++j) {
        sum += found->coefficients[i * 3 + j] * std::pow(1 - s, 3 - i) * std::pow(s, i) * std::pow(1 - r, 2 - j) *
               std::pow(r, j);
      }
    }
    const double at[]{-1.0 + 3.0 * s, 3.0 + 4.0 * r};
    const std::span<const double> values[]{{&at[0], 1}, {&at[1], 1}};
    double wanted = 0.0;
    evaluate(formula, values, {&wanted, 1});
    EXPECT_NEAR(sum, wanted, 1e-12);
  }
}

TEST(FormulaPolynomial, InBernsteinFormLosesNothingFarFromZero) {
  const Interval domain{999.0, 1001.0};
  const auto found = scaled_bernstein(Formula::make("(t - 1000)^20", {"t"}), {&domain, 1}, kMaxDegree);
  ASSERT_TRUE(found);
  // (-(1 - s) + s)^20
  for (int i = 0; i <= 20; ++i) EXPECT_EQ(found->coefficients[i], (i % 2 == 0 ? 1 : -1) * binomial(20, i)) << i;
}

}  // namespace
}  // namespace splinecore
