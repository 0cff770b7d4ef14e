#include "splinecore/curve/multiply.hpp"

#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(Multiplied, GivesTheProductOfBezierWeights) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 3, 2}, {4, 5, 6, 0}, {7, 8, 9, -3}});
  const BezierCurve result = multiplied(curve, 1.0, 3.0);
  ASSERT_EQ(result.points().size(), 5U);
  const double expected[] = {1.0, 0.25 * 3.0 + 0.75 * 2.0, 0.5 * 6.0, 0.25 * -3.0, -9.0};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(result.points()[i].w, expected[i], 1e-14) << i;
}

TEST(Multiplied, IsTheSameCurveForThousandRationalCurves) {
  Random random(515);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const double start = std::exp2(real(random, -2, 2));
    const double end = std::exp2(real(random, -2, 2));
    const NurbsCurve result = multiplied(curve, start, end);
    EXPECT_FALSE(result.periodic());
    EXPECT_EQ(result.degree(), curve.degree() + 1);
    EXPECT_EQ(result.domain().start, curve.domain().start);
    EXPECT_EQ(result.domain().end, curve.domain().end);
    for (const double u : random_parameters(random, curve.domain(), 5)) {
      EXPECT_LE(largest(point_at(curve, u) - point_at(result, u)), 1e-12 * 10) << round << " " << u;
    }
  }
}

TEST(Multiplied, GivesWeightsToAPolynomialCurve) {
  const BezierCurve result = multiplied(BezierCurve::make({{0, 0, 0, 1}, {2, 0, 0, 1}}), 1.0, 3.0);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(result.points()[i].w, 1.0 + i);
  EXPECT_EQ(point_at(result.nurbs(), 0.5).x, 1.0);
}

TEST(Multiplied, TakesNumbersAboveZeroOnly) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 3, 2}});
  EXPECT_THROW(multiplied(curve, 0.0, 1.0), InvalidShape);
  EXPECT_THROW(multiplied(curve, 1.0, -1.0), InvalidShape);
  EXPECT_THROW(multiplied(curve, 1e-320, 1.0), InvalidShape);
  EXPECT_THROW(multiplied(curve, 1.0, std::numeric_limits<double>::infinity()), InvalidShape);
}

}  // namespace
}  // namespace splinecore
