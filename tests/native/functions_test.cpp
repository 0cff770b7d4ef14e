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

// Lecture row S14: the triangle on knots 0 … 5 for degrees 0 to 2.
TEST(FunctionTriangle, OnZeroToFiveHasTheLecturesNumbers) {
  const KnotVector knots = KnotVector::make(2, {0, 1, 2, 3, 4, 5});
  const std::vector<TriangleRow> rows = function_triangle(knots, 2.5);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].first, 2);
  EXPECT_EQ(rows[0].values, (std::vector<double>{1}));
  EXPECT_EQ(rows[1].first, 1);
  EXPECT_EQ(rows[1].values, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(rows[2].first, 0);
  EXPECT_EQ(rows[2].values, (std::vector<double>{0.125, 0.75, 0.125}));
  EXPECT_EQ(rows[2].rising, (std::vector<double>{0, 0.75, 0.25}));
  EXPECT_EQ(rows[2].falling, (std::vector<double>{0.25, 0.75, 0}));
}

TEST(FunctionTriangle, ExistsWhereTheDomainIsEmpty) {
  const KnotVector knots = KnotVector::make(2, {0, 1, 2, 3});
  const std::vector<TriangleRow> rows = function_triangle(knots, 0.5);
  EXPECT_EQ(rows[1].first, 0);
  EXPECT_EQ(rows[1].values, (std::vector<double>{0.5}));
  EXPECT_EQ(rows[2].values, (std::vector<double>{0.125}));
  EXPECT_EQ(function_triangle(knots, 2.5)[1].values, (std::vector<double>{0.5}));
  EXPECT_EQ(function_triangle(knots, 2.5)[1].first, 1);
  EXPECT_EQ(refusal([&] { function_triangle(knots, 3); }), "u = 3 is outside [0, 3)");
  EXPECT_NE(refusal([&] { function_triangle(knots, 0.0 / 0.0); }).find("nan is not finite"), std::string::npos);
}

TEST(FunctionTriangle, EndsInTheFunctionsOfTheDegree) {
  Random random(350);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    std::vector<double> at = random_parameters(random, knots.domain(), 3);
    at.push_back(knots.domain().end);
    for (const double u : at) {
      const TriangleRow last = function_triangle(knots, u).back();
      double sum = 0;
      for (std::size_t j = 0; j < last.values.size(); ++j) {
        sum += last.values[j];
        const int i = (last.first + static_cast<int>(j)) % knots.count();
        if (!knots.periodic()) { EXPECT_NEAR(last.values[j], function_value(knots, i, u), 1e-13) << text_of(kind); }
      }
      EXPECT_NEAR(sum, 1, 1e-13) << text_of(kind);
    }
  }
}

TEST(FunctionDerivatives, OnZeroToThreeAreTheLecturesPiecesDifferentiated) {
  const KnotVector knots = KnotVector::make(2, {0, 1, 2, 3});
  const auto at = [&](double u) {
    std::vector<double> out(5);
    function_derivatives(knots, 0, u, out);
    return out;
  };
  EXPECT_EQ(at(0.5), (std::vector<double>{0.125, 0.5, 1, 0, 0}));
  EXPECT_EQ(at(1.25), (std::vector<double>{0.6875, 0.5, -2, 0, 0}));
  EXPECT_EQ(at(2), (std::vector<double>{0.5, -1, 1, 0, 0}));
  EXPECT_EQ(at(3), std::vector<double>(5));
  EXPECT_EQ(at(-1), std::vector<double>(5));
}

TEST(FunctionDerivatives, AgreeWithTheSamples) {
  Random random(351);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    const int order = std::min(kind.degree, 3);
    const double u = random_parameters(random, knots.domain(), 1)[0];
    const Samples sample = Samples::make(knots, {&u, 1}, order);
    std::vector<double> expected(knots.count() * (order + 1));
    for (int k = 0; k <= order; ++k) {
      for (int j = 0; j <= kind.degree; ++j) {
        expected[(sample.first(0) + j) % knots.count() * (order + 1) + k] += sample.weights(0, k)[j];
      }
    }
    std::vector<double> out(order + 1);
    for (int i = 0; i < knots.count(); ++i) {
      function_derivatives(knots, i, u, out);
      for (int k = 0; k <= order; ++k) {
        const double right = expected[i * (order + 1) + k];
        EXPECT_NEAR(out[k], right, 1e-10 * std::pow(1000, k)) << text_of(kind);
      }
    }
  }
  std::vector<double> out(66);
  EXPECT_EQ(refusal([&] { function_derivatives(KnotVector::bezier(2), 0, 0.5, out); }), "order = 65 is outside [0, 64]");
  EXPECT_EQ(refusal([&] { function_derivatives(KnotVector::bezier(2), 3, 0.5, out); }), "i = 3 is outside [0, 2]");
}

}  // namespace
}  // namespace splinecore
