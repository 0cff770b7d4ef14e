#include "splinecore/basis/samples.hpp"

#include "reference.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/functions.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(Samples, HoldTheValuesOfTheFunctionsThatAreNotZero) {
  Random random(7);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    const std::vector<double> parameters = random_parameters(random, knots.domain(), 10);
    const Samples samples = Samples::make(knots, parameters);
    for (std::size_t s = 0; s < samples.size(); ++s) {
      std::vector<double> sums(knots.count());
      for (int j = 0; j <= kind.degree; ++j) sums[(samples.first(s) + j) % knots.count()] += samples.weights(s)[j];
      for (int i = 0; i < knots.count(); ++i) {
        EXPECT_NEAR(sums[i], function_value(knots, i, parameters[s]), 1e-14) << text_of(kind);
      }
    }
  }
}

TEST(Samples, WeightsOfEveryDerivativeAgreeWithTheDerivedRecursion) {
  Random random(8);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    const std::vector<Real> t = all_knots(knots);
    const int order = std::min(kind.degree + 1, 4);
    const std::vector<double> parameters = random_parameters(random, knots.domain(), 3);
    const Samples samples = Samples::make(knots, parameters, order);
    for (std::size_t s = 0; s < samples.size(); ++s) {
      for (int k = 0; k <= order; ++k) {
        const auto weights = samples.weights(s, k);
        const double size = std::abs(*std::ranges::max_element(weights, {}, [](double w) { return std::abs(w); }));
        for (int j = 0; j <= kind.degree; ++j) {
          const Real expected = derivative(t, samples.first(s) + j, kind.degree, k, parameters[s]);
          EXPECT_NEAR(weights[j], static_cast<double>(expected), 1e-12 * size) << text_of(kind) << " order " << k;
        }
      }
    }
  }
}

TEST(Samples, WeightsOfADerivativeSumToZero) {
  Random random(9);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    const double u = knots.domain().middle();
    const Samples samples = Samples::make(knots, {&u, 1}, 3);
    for (int k = 1; k <= 3; ++k) {
      double sum = 0.0;
      double size = 0.0;
      for (const double weight : samples.weights(0, k)) {
        sum += weight;
        size += std::abs(weight);
      }
      EXPECT_NEAR(sum, 0.0, 1e-13 * size) << text_of(kind) << " order " << k;
    }
  }
}

TEST(Samples, DifferentiateMonomialsWrittenInBernsteinForm) {
  // t^m has the Bernstein coefficients C(i, m) / C(n, m).
  for (const int degree : {1, 2, 3, 5, 9}) {
    for (const double t : {0.0, 0.25, 0.7, 1.0}) {
      const Samples samples = Samples::make(KnotVector::bezier(degree), {&t, 1}, degree + 1);
      for (int k = 0; k <= degree + 1; ++k) {
        for (int m = 0; m <= degree; ++m) {
          double sum = 0.0;
          for (int i = m; i <= degree; ++i) sum += samples.weights(0, k)[i] * binomial(i, m) / binomial(degree, m);
          double expected = m < k ? 0.0 : std::pow(t, m - k);
          for (int factor = 0; factor < k; ++factor) expected *= m - factor;
          const double size = std::tgamma(degree + 1.0) * std::exp2(k);
          EXPECT_NEAR(sum, expected, 1e-15 * size) << degree << " " << k << " " << m << " " << t;
        }
      }
    }
  }
}

TEST(Samples, KeepTheDigitsOfDerivativesInAVeryShortSpan) {
  const double tiny = 1e-7;
  const KnotVector knots = KnotVector::make(3, {0, 0, 0, 0, 1, 1 + tiny, 2, 2, 2, 2});
  const std::vector<Real> t = all_knots(knots);
  const double u = 1 + 0.3 * tiny;
  const Samples samples = Samples::make(knots, {&u, 1}, 2);
  for (int k = 1; k <= 2; ++k) {
    for (int j = 0; j <= 3; ++j) {
      const Real expected = derivative(t, samples.first(0) + j, 3, k, u);
      EXPECT_NEAR(samples.weights(0, k)[j], static_cast<double>(expected), 1e-14) << "order " << k << " " << j;
    }
  }
}

TEST(Samples, TakeOneSideForAllOrOneForEach) {
  const KnotVector knots = KnotVector::make(1, {0, 0, 1, 1, 2, 2});
  const std::vector<double> parameters{1, 1, 1};
  const std::vector<Side> sides{Side::left, Side::right, Side::left};
  const Samples each = Samples::make(knots, parameters, 0, sides);
  EXPECT_EQ(each.first(0), 0);
  EXPECT_EQ(each.first(1), 2);
  EXPECT_EQ(each.first(2), 0);
  EXPECT_EQ(each.side(1), Side::right);
  const Samples all = Samples::make(knots, parameters, 0, Side::left);
  EXPECT_EQ(all.first(1), 0);
}

TEST(Samples, MoveAPeriodicParameterIntoTheDomain) {
  const KnotVector knots = KnotVector::periodic_uniform(2, 3);
  const double u = -4.25;
  EXPECT_EQ(Samples::make(knots, {&u, 1}).parameter(0), 1.75);
}

TEST(Samples, NameTheParameterOutsideTheDomain) {
  const std::vector<double> parameters{0, 1, 1.5};
  EXPECT_EQ(refusal([&] { Samples::make(KnotVector::bezier(2), parameters, 0, Side::right, "v"); }),
            "v[2] = 1.5 is outside the domain [0, 1]");
}

}  // namespace
}  // namespace splinecore
