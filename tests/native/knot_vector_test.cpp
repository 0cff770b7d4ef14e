#include "splinecore/basis/knot_vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

#include "reference.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string refused(int degree, std::vector<double> knots, bool periodic = false) {
  return refusal([&] { KnotVector::make(degree, knots, periodic); });
}

TEST(KnotVectorMake, NamesTheFirstKnotThatIsNotFinite) {
  EXPECT_EQ(refused(1, {0, 0, kNan, kInfinity}), "knots[2] = nan is not finite");
  EXPECT_EQ(refused(1, {0, -kInfinity, 1, 1}), "knots[1] = -inf is not finite");
  EXPECT_EQ(refused(1, {0, 1, kInfinity}, true), "knots[2] = inf is not finite");
}

/// By the definition, knot by knot.
bool is_knot_vector(int degree, const std::vector<double>& knots) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]) || (i > 0 && knots[i] < knots[i - 1])) return false;
    if (std::ranges::count(knots, knots[i]) > degree + 1) return false;
  }
  return true;
}

TEST(KnotVectorMake, RefusesWhatIsWrongAtAnyPlaceAndNothingElse) {
  for (const int degree : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, kMaxDegree}) {
    for (const int ends : {1, degree, degree + 1}) {
      for (const int inner : {0, 1, 2, 7, 40}) {
        std::vector<double> good(ends, 0.0);
        for (int i = 1; i <= inner; ++i) good.insert(good.end(), i % 5 == 0 ? 2 : 1, i);
        good.insert(good.end(), ends, inner + 1);
        if (static_cast<int>(good.size()) < degree + 2) continue;
        for (std::size_t i = 0; i < good.size(); i += good.size() > 100 ? 7 : 1) {
          for (const double value : {kNan, kInfinity, -kInfinity, -1.0, 0.5, 3.0, good[i] + 1.0}) {
            std::vector<double> knots = good;
            knots[i] = value;
            const bool is_right = is_knot_vector(degree, knots);
            EXPECT_EQ(refused(degree, knots) == "not refused", is_right) << degree << ", " << value << " at " << i;
          }
        }
      }
    }
  }
}

TEST(KnotVectorMake, NamesTheFirstKnotThatDecreases) {
  EXPECT_EQ(refused(2, {0, 0, 0, 0.5, 0.25, 1, 1, 1}), "knots[4] = 0.25 is below knots[3] = 0.5");
  EXPECT_EQ(refused(3, {0, 2, 1}, true), "knots[2] = 1 is below knots[1] = 2");
}

TEST(KnotVectorMake, AllowsMultiplicityDegreePlusOneAndNamesTheKnotThatPassesIt) {
  EXPECT_EQ(KnotVector::make(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}).spans().size(), 2u);
  EXPECT_EQ(refused(2, {0, 0, 0, 1, 1, 1, 1, 2, 2, 2}), "knots[6] = 1 has multiplicity above degree + 1 = 3");
  EXPECT_EQ(refused(0, {0, 0, 1}), "knots[1] = 0 has multiplicity above degree + 1 = 1");
}

TEST(KnotVectorMake, CountsTheSeamOfAPeriodOnce) {
  EXPECT_EQ(multiplicity(KnotVector::make(2, {0, 0, 1, 3, 3}, true), 0), 3);
  EXPECT_EQ(multiplicity(KnotVector::make(2, {0, 0, 1, 3, 3}, true), 3), 3);
  EXPECT_EQ(refused(2, {0, 0, 0, 1, 3, 3}, true),
            "knots[0] = 0 has multiplicity above degree + 1 = 3 together with the end of the period");
  EXPECT_EQ(refused(2, {1, 1, 1}, true), "knots[2] = 1 equals knots[0]: the period has no length");
}

TEST(KnotVectorMake, RefusesAbsurdDegreesAndSizes) {
  EXPECT_EQ(refused(-1, {0, 1}), "degree = -1 is outside [0, 255]");
  EXPECT_EQ(refused(256, std::vector<double>(600, 0.0)), "degree = 256 is outside [0, 255]");
  EXPECT_EQ(refusal([] { KnotVector::bezier(std::numeric_limits<int>::max()); }),
            "degree = 2147483647 is outside [0, 255]");
  EXPECT_NE(refused(3, {0, 0, 1, 1}).find("knots has 4 values, at least 5"), std::string::npos);
  EXPECT_NE(refused(3, {0}, true).find("knots has 1 values, at least 2"), std::string::npos);
  for (const auto make : {KnotVector::clamped, KnotVector::uniform, KnotVector::periodic_uniform}) {
    EXPECT_EQ(refusal([&] { make(3, std::numeric_limits<int>::max()); }),
              "count = 2147483647 is outside [1, 268435456]");
    EXPECT_EQ(refusal([&] { make(3, -5); }), "count = -5 is outside [1, 268435456]");
    EXPECT_EQ(refusal([&] { make(300, 5); }), "degree = 300 is outside [0, 255]");
  }
  EXPECT_EQ(refusal([] { KnotVector::clamped(3, 3); }), "count = 3 is below degree + 1 = 4");
}

TEST(KnotVectorMake, RefusesKnotsWhoseDistanceOverflows) {
  EXPECT_EQ(refused(1, {-1e308, -1e308, 1e308, 1e308}),
            "knots from -1e+308 to 1e+308 overflow: their distance is not a finite number");
}

TEST(KnotVector, ThatLeavesNoDomainExistsAndSaysSoWhenAskedForIt) {
  const KnotVector lecture = KnotVector::make(2, {0, 1, 2, 3});
  EXPECT_EQ(lecture.count(), 1);
  EXPECT_FALSE(lecture.has_domain());
  EXPECT_EQ(refusal([&] { static_cast<void>(lecture.domain()); }),
            "knots leave no domain: for degree 2 the knots u_2 and u_1 must differ");
}

TEST(KnotVector, DomainOfAPlainVectorRunsFromKnotDegreeToKnotCount) {
  EXPECT_EQ(KnotVector::uniform(3, 6).domain(), (Interval{3, 6}));
  EXPECT_EQ(KnotVector::clamped(3, 6).domain(), (Interval{0, 3}));
  EXPECT_EQ(KnotVector::bezier(7).domain(), (Interval{0, 1}));
  EXPECT_EQ(KnotVector::clamped(2, 5), KnotVector::make(2, {0, 0, 0, 1, 2, 3, 3, 3}));
}

TEST(KnotVector, PeriodUnrollsByAddingItself) {
  const KnotVector knots = KnotVector::make(3, {0, 1, 3}, true);
  const std::vector<double> expected{-5, -3, -2, 0, 1, 3, 4, 6, 7};
  EXPECT_TRUE(std::ranges::equal(knots.unrolled(), expected));
  EXPECT_EQ(knots.count(), 2);
  EXPECT_EQ(knots.unrolled_count(), 5);
  EXPECT_EQ(knots.domain(), (Interval{0, 3}));
  EXPECT_EQ(KnotVector::periodic_uniform(3, 4).domain(), (Interval{0, 4}));
}

TEST(KnotVectorAdmit, ClampsFourUlpAndRefusesMore) {
  const KnotVector knots = KnotVector::make(1, {1, 1, 2, 2});
  const double ulp = std::numeric_limits<double>::epsilon();
  EXPECT_EQ(knots.admit(2 + 8 * ulp, Side::right), 2.0);
  EXPECT_EQ(knots.admit(1 - 8 * ulp, Side::right), 1.0);
  EXPECT_EQ(refusal([&] { knots.admit(2 + 10 * ulp, Side::right, 7, "v"); }),
            "v[7] = 2.000000000000002 is outside the domain [1, 2]");
  EXPECT_EQ(refusal([&] { knots.admit(kNan, Side::right, 3); }), "u[3] = nan is outside the domain [1, 2]");
}

TEST(KnotVectorAdmit, TakesAPeriodicParameterModuloThePeriod) {
  const KnotVector knots = KnotVector::make(1, {-1, 0, 2}, true);
  EXPECT_EQ(knots.admit(2.5, Side::right), -0.5);
  EXPECT_EQ(knots.admit(-1.5, Side::right), 1.5);
  EXPECT_EQ(knots.admit(3e15 + 1, Side::right), 1.0);
  EXPECT_EQ(knots.admit(5, Side::right), -1.0);
  EXPECT_EQ(knots.admit(5, Side::left), 2.0);
  EXPECT_EQ(refusal([&] { knots.admit(kInfinity, Side::right); }), "u = inf is outside the domain [-1, 2]");
}

TEST(KnotVectorAdmit, GivesAParameterOfTheDomainForTheLargestDoubles) {
  for (const KnotVector& knots :
       {KnotVector::make(1, {-1e308, 0, 5e307}, true), KnotVector::make(1, {-1, 0, 2}, true)}) {
    for (const double u : {1.7e308, -1.7e308}) {
      const double admitted = knots.admit(u, Side::right);
      EXPECT_GE(admitted, knots.domain().start) << u;
      EXPECT_LE(admitted, knots.domain().end) << u;
    }
  }
}

TEST(KnotVectorSpanOf, PutsAKnotIntoTheSpanOnTheSideAskedFor) {
  const KnotVector knots = KnotVector::make(2, {0, 0, 0, 1, 1, 3, 3, 3});
  const auto span = [&](double u, Side side) { return knots.span_of(u, side); };
  EXPECT_EQ(knots.spans().size(), 2u);
  EXPECT_EQ(knots.span_interval(0), (Interval{0, 1}));
  EXPECT_EQ(knots.span_interval(1), (Interval{1, 3}));
  EXPECT_EQ(span(1, Side::right), 1);
  EXPECT_EQ(span(1, Side::left), 0);
  EXPECT_EQ(span(0, Side::left), 0);
  EXPECT_EQ(span(3, Side::right), 1);
}

TEST(KnotVectorBezierMatrix, HasRowsOfAConvexCombination) {
  Random random(1);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
    for (std::size_t span = 0; span < knots.spans().size(); ++span) {
      const auto matrix = knots.bezier_matrix(static_cast<int>(span));
      ASSERT_EQ(matrix.size(), static_cast<std::size_t>(kind.degree) + 1);
      for (std::size_t row = 0; row < matrix.size(); ++row) {
        const auto weights = matrix[row];
        ASSERT_EQ(weights.size(), matrix.size());
        EXPECT_TRUE(std::ranges::all_of(weights, [](double w) { return w >= 0.0 && w <= 1.0; })) << text_of(kind);
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-14) << text_of(kind);
      }
    }
  }
}

// Lecture row S13: the matrix 1/6 [1 4 1 0; 0 4 2 0; 0 2 4 0; 0 1 4 1].
TEST(KnotVectorBezierMatrix, OfTheUniformCubicIsTheOneOfTheLectures) {
  const KnotVector knots = KnotVector::uniform(3, 9);
  const auto matrix = knots.bezier_matrix(2);
  const double expected[] = {1, 4, 1, 0, 0, 4, 2, 0, 0, 2, 4, 0, 0, 1, 4, 1};
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(6 * matrix[i / 4][i % 4], expected[i], 1e-15) << i;
}

TEST(KnotVectorBezierMatrix, IsOneForAllThatAskAtOnce) {
  for (const auto& [degree, count] : {std::pair{3, 5000}, std::pair{40, 60}, std::pair{255, 257}}) {
    const KnotVector knots = KnotVector::uniform(degree, count);
    const int spans = static_cast<int>(knots.spans().size());
    std::array<std::vector<const double*>, 4> seen;
    std::vector<std::thread> threads;
    for (auto& mine : seen) {
      threads.emplace_back([&] {
        for (int i = 0; i < spans; ++i) mine.push_back(knots.bezier_matrix(i)[0].data());
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const auto& mine : seen) EXPECT_EQ(mine, seen[0]);
    for (const int i : {0, spans / 2, spans - 1}) {
      const auto matrix = knots.bezier_matrix(i);
      for (int j = 0; j <= degree; ++j) {
        const auto row = matrix[j];
        EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), 1.0, 1e-12);
      }
    }
  }
}

TEST(KnotVectorBezierMatrix, OfABezierSpanIsTheIdentity) {
  for (const int degree : {0, 1, 3, 254, 255}) {
    const KnotVector knots = KnotVector::bezier(degree);
    const auto matrix = knots.bezier_matrix(0);
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; j <= degree; ++j) ASSERT_EQ(matrix[i][j], i == j ? 1.0 : 0.0);
    }
  }
}

TEST(KnotVectorMultiplicity, CountsKnotsAndNothingElse) {
  const KnotVector plain = KnotVector::make(2, {0, 0, 1, 2, 2, 2, 3, 3});
  const KnotVector period = KnotVector::make(3, {0, 0, 1, 2, 2}, true);
  EXPECT_EQ(multiplicity(plain, 2.0), 3);
  EXPECT_EQ(multiplicity(plain, -0.0), 2);
  for (const double u : {-1.0, 1.5, 4.0, std::nan("")}) EXPECT_EQ(multiplicity(plain, u), 0) << u;
  EXPECT_EQ(multiplicity(period, 0.0), 3);
  EXPECT_EQ(multiplicity(period, 2.0), 3);
}

TEST(KnotVectorEquality, ComparesDegreePeriodicityAndEveryKnot) {
  const KnotVector knots = KnotVector::make(1, {0, 0, 1, 1});
  EXPECT_EQ(knots, KnotVector::bezier(1));
  EXPECT_FALSE(knots == KnotVector::make(2, {0, 0, 1, 1}));
  EXPECT_FALSE(knots == KnotVector::make(1, {0, 0, 1, std::nextafter(1.0, 2.0)}));
  EXPECT_FALSE(KnotVector::make(1, {0, 1, 2}, true) == KnotVector::make(1, {0, 1, 2}));
}

}  // namespace
}  // namespace splinecore
