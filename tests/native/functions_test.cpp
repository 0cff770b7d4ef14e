#include "splinecore/basis/functions.hpp"

#include <limits>

#include "reference.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

// The worked numbers of the lectures (row S14) on the knots 0, 1, 2, 3.
TEST(FunctionValue, OfDegreeOneIsTheHatOfTheLectures) {
  const KnotVector knots = KnotVector::make(1, {0, 1, 2, 3});
  for (double u = -1.0; u <= 4.0; u += 1.0 / 64) {
    const double first = u < 0 || u >= 2 ? 0 : u < 1 ? u : 2 - u;
    const double second = u < 1 || u >= 3 ? 0 : u < 2 ? u - 1 : 3 - u;
    EXPECT_EQ(function_value(knots, 0, u), first) << u;
    EXPECT_EQ(function_value(knots, 1, u), second) << u;
  }
}

TEST(FunctionValue, OfDegreeTwoIsTheBellOfTheLecturesThoughTheDomainIsEmpty) {
  const KnotVector knots = KnotVector::make(2, {0, 1, 2, 3});
  ASSERT_FALSE(knots.has_domain());
  for (double u = -1.0; u <= 4.0; u += 1.0 / 64) {
    const double bell = u < 0 || u >= 3 ? 0
                        : u < 1         ? u * u / 2
                        : u < 2         ? -u * u + 3 * u - 1.5
                                        : (3 - u) * (3 - u) / 2;
    EXPECT_NEAR(function_value(knots, 0, u), bell, 1e-15) << u;
  }
}

TEST(FunctionValue, OfDegreeZeroIsTheHalfOpenSpanClosedAtTheEndOfTheDomain) {
  const KnotVector knots = KnotVector::make(0, {0, 1, 2});
  EXPECT_EQ(function_value(knots, 0, 0.0), 1.0);
  EXPECT_EQ(function_value(knots, 0, 1.0), 0.0);
  EXPECT_EQ(function_value(knots, 1, 1.0), 1.0);
  EXPECT_EQ(function_value(knots, 1, 2.0), 1.0);
  EXPECT_EQ(function_value(knots, 1, 2.5), 0.0);
}

TEST(FunctionValue, AgreesWithTheRecursionInLongDouble) {
  Random random(2);
  for (const Kind& kind : all_kinds(Weights::one)) {
    if (kind.ends == Ends::periodic) continue;
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    const std::vector<Real> t = all_knots(knots);
    const Interval line{knots.knots().front() - 1.0, knots.knots().back() + 1.0};
    for (const double u : random_parameters(random, line, 20)) {
      for (int i = 0; i < knots.count(); ++i) {
        const double expected = static_cast<double>(cox_de_boor(t, i, kind.degree, u));
        EXPECT_NEAR(function_value(knots, i, u), expected, 1e-14 * expected)
            << text_of(kind) << " i " << i << " u " << u;
      }
    }
  }
}

TEST(FunctionValue, SumsToOneOnTheDomainItsEndsIncluded) {
  Random random(3);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    std::vector<double> parameters = random_parameters(random, knots.domain(), 20);
    for (std::size_t i = 0; i < knots.spans().size(); ++i) parameters.push_back(knots.span_interval(i).start);
    parameters.push_back(knots.domain().end);
    for (const double u : parameters) {
      double sum = 0.0;
      for (int i = 0; i < knots.count(); ++i) sum += function_value(knots, i, u);
      EXPECT_NEAR(sum, 1.0, 1e-13) << text_of(kind) << " u " << u;
    }
  }
}

TEST(FunctionValue, OfAPeriodicVectorIsTheSumOfItsImages) {
  Random random(4);
  for (const Kind& kind : all_kinds(Weights::one)) {
    if (kind.ends != Ends::periodic) continue;
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    const std::vector<Real> t = all_knots(knots);
    for (const double u : random_parameters(random, knots.domain(), 10)) {
      std::vector<Real> sums(knots.count());
      for (int i = 0; i < knots.count() + kind.degree; ++i)
        sums[i % knots.count()] += cox_de_boor(t, i, kind.degree, u);
      for (int i = 0; i < knots.count(); ++i) {
        EXPECT_NEAR(function_value(knots, i, u), static_cast<double>(sums[i]), 1e-13) << text_of(kind);
      }
    }
  }
}

TEST(FunctionSupport, IsTheSmallestIntervalOutsideWhichTheFunctionIsZero) {
  Random random(5);
  for (const Kind& kind : all_kinds(Weights::one)) {
    if (kind.ends == Ends::periodic) continue;
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    for (int i = 0; i < knots.count(); ++i) {
      const Interval support = function_support(knots, i);
      const double inside = 1e-3 * support.length();
      EXPECT_GT(function_value(knots, i, support.start + inside), 0.0) << text_of(kind);
      EXPECT_GT(function_value(knots, i, support.end - inside), 0.0) << text_of(kind);
      EXPECT_EQ(function_value(knots, i, support.start - inside), 0.0) << text_of(kind);
      EXPECT_EQ(function_value(knots, i, support.end + inside), 0.0) << text_of(kind);
    }
  }
}

TEST(FunctionValue, NamesAnIndexOrParameterThatIsNone) {
  const KnotVector knots = KnotVector::make(2, {0, 1, 2, 3});
  EXPECT_EQ(refusal([&] { function_value(knots, 1, 0.5); }), "i = 1 is outside [0, 0]");
  EXPECT_EQ(refusal([&] { function_value(knots, -1, 0.5); }), "i = -1 is outside [0, 0]");
  EXPECT_EQ(refusal([&] { function_value(knots, 0, std::numeric_limits<double>::quiet_NaN()); }),
            "u = nan is not finite");
  EXPECT_EQ(refusal([&] { function_support(knots, 7); }), "i = 7 is outside [0, 0]");
}

}  // namespace
}  // namespace splinecore
