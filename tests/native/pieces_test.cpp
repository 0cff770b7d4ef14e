#include <numbers>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

NurbsCurve conic(double w1, double start = 0.0, double end = 1.0) {
  const std::vector<double> knots{start, start, start, end, end, end};
  return NurbsCurve::make(2, knots, {{-1, 0, 0, 1}, {0, 1, 0, w1}, {1, 0, 0, 1}});
}

void expect_pieces(const NurbsCurve& curve, const std::vector<Interval>& expected, double tolerance) {
  const std::vector<Interval> found = pieces(curve);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].start, expected[i].start, tolerance) << i;
    EXPECT_NEAR(found[i].end, expected[i].end, tolerance) << i;
  }
}

TEST(Pieces, OfAPolynomialCurveAreItsDomain) {
  EXPECT_EQ(pieces(NurbsCurve::make(KnotVector::uniform(3, 6), std::vector<glm::dvec4>(6, glm::dvec4(1)))),
            (std::vector<Interval>{{3, 6}}));
}

TEST(Pieces, OfAnEllipseArcAreItsDomainHoweverLong) {
  for (const double w1 : {2.0, 1.0, 0.5, 0.0, -0.5, -0.999}) {
    EXPECT_EQ(pieces(conic(w1)), (std::vector<Interval>{{0, 1}})) << w1;
  }
}

// W = (1 - 2t)^2 has a double root.
TEST(Pieces, OfTheTwoParabolaArcsMeetInTheMiddle) {
  expect_pieces(conic(-1), {{0, 0.5}, {0.5, 1}}, 1e-15);
  expect_pieces(conic(-1, 0.1, 0.7), {{0.1, 0.4}, {0.4, 0.7}}, 1e-8);
}

// W = 1 - 2t(1 - t)(1 - w1) vanishes at (1 ± sqrt((w1 + 1) / (w1 - 1))) / 2.
TEST(Pieces, OfThreeHyperbolaArcsEndAtTheRootsOfTheWeight) {
  for (const double w1 : {-1.0001, -1.5, -2.0, -10.0}) {
    const double half = 0.5 * std::sqrt((w1 + 1) / (w1 - 1));
    expect_pieces(conic(w1), {{0, 0.5 - half}, {0.5 - half, 0.5 + half}, {0.5 + half, 1}}, 1e-11);
  }
}

TEST(Pieces, BeginAndEndWithTheDomainWhereTheEndsAreAtInfinity) {
  const NurbsCurve hyperbola = NurbsCurve::make(KnotVector::bezier(2), {{0, 1, 0, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}});
  EXPECT_EQ(pieces(hyperbola), (std::vector<Interval>{{0, 1}}));
}

TEST(Pieces, AreCutAtKnotsOfMultiplicityDegreePlusOne) {
  const std::vector<glm::dvec4> points(6, glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(pieces(NurbsCurve::make(2, {0, 0, 0, 1, 1, 1, 3, 3, 3}, points)), (std::vector<Interval>{{0, 1}, {1, 3}}));
}

TEST(Pieces, LeaveOutSpansThatLieAtInfinity) {
  const NurbsCurve curve =
      NurbsCurve::make(1, {0, 0, 1, 2, 3, 3}, {{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 1}});
  EXPECT_EQ(pieces(curve), (std::vector<Interval>{{0, 1}, {2, 3}}));
}

TEST(Pieces, OfPositiveWeightsAreTheDomainHoweverUnequalTheWeights) {
  const NurbsCurve curve =
      NurbsCurve::make(1, {0, 0, 1, 2, 3, 3}, {{0, 0, 0, 1}, {1, 0, 0, 1e-20}, {2, 0, 0, 1e-20}, {3, 0, 0, 1}});
  EXPECT_EQ(pieces(curve), (std::vector<Interval>{{0, 3}}));
}

TEST(Pieces, FindRootsAmongSmallWeightsBesideLargeOnes) {
  const NurbsCurve curve =
      NurbsCurve::make(1, {0, 0, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1e-20}, {2, 0, 0, -1e-20}});
  expect_pieces(curve, {{0, 1.5}, {1.5, 2}}, 1e-14);
}

TEST(Pieces, OfAPeriodicCurveEndAtTheRootsOfItsPeriod) {
  // Degree 1 through the weights 1, -1, 1, -1: a root in the middle of every span.
  const NurbsCurve curve = NurbsCurve::make(KnotVector::periodic_uniform(1, 4),
                                            {{1, 0, 0, 1}, {0, 1, 0, -1}, {-1, 0, 0, 1}, {0, -1, 0, -1}});
  expect_pieces(curve, {{0, 0.5}, {0.5, 1.5}, {1.5, 2.5}, {2.5, 3.5}, {3.5, 4}}, 1e-14);
}

TEST(Pieces, SeparateWeightsOfOneSign) {
  Random random(40);
  for (int round = 0; round < 500; ++round) {
    const NurbsCurve curve = random_curve(random);
    const std::vector<Interval> found = pieces(curve);
    double end = curve.domain().start;
    for (const Interval& piece : found) {
      EXPECT_GE(piece.start, end);
      EXPECT_GT(piece.end, piece.start);
      end = piece.end;
      int positive = 0;
      int negative = 0;
      for (int k = 1; k < 40; ++k) {
        const double w = homogeneous_at(curve, piece.start + piece.length() * k / 40).w;
        if (std::abs(w) > 1e-12 * size_of(curve)) ++(w > 0 ? positive : negative);
      }
      EXPECT_EQ(std::min(positive, negative), 0) << "from " << piece.start << " to " << piece.end;
    }
    EXPECT_LE(end, curve.domain().end);
  }
}

}  // namespace
}  // namespace splinecore
