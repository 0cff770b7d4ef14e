#include "splinecore/curve/casteljau.hpp"

#include "splinecore/base/points.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

BezierCurve random_bezier(Random& random, Weights weights) {
  return BezierCurve::make(random_points(random, integer(random, 2, 10), weights));
}

TEST(Casteljau, HasRowsOfOnePointLessEachAndEndsInTheCurve) {
  Random random(500);
  for (int round = 0; round < 300; ++round) {
    const BezierCurve curve = random_bezier(random, Weights::any);
    const double u = real(random, 0, 1);
    const Triangle rows = casteljau_triangle(curve, u);
    ASSERT_EQ(rows.size(), curve.points().size());
    for (std::size_t j = 0; j < rows.size(); ++j) EXPECT_EQ(rows[j].size(), rows.size() - j);
    EXPECT_LE(largest(rows.back()[0] - homogeneous_at(curve.nurbs(), u)), 1e-14 * size_of(curve.nurbs()));
  }
}

TEST(Casteljau, BothAlgorithmsHaveTheSamePointsAndWeights) {
  Random random(501);
  for (int round = 0; round < 300; ++round) {
    const BezierCurve curve = random_bezier(random, Weights::positive);
    const double u = real(random, 0, 1);
    const Triangle homogeneous_rows = casteljau_triangle(curve, u);
    const RationalTriangle rational = rational_casteljau_triangle(curve, u);
    ASSERT_FALSE(rational.breakdown.has_value());
    ASSERT_EQ(rational.rows.size(), homogeneous_rows.size());
    for (std::size_t j = 0; j < homogeneous_rows.size(); ++j) {
      for (std::size_t i = 0; i < homogeneous_rows[j].size(); ++i) {
        EXPECT_LE(largest(rational.rows[j][i] - as_given(homogeneous_rows[j][i])), 1e-13 * 10);
      }
    }
  }
}

// w_i^(1) = (1 - t) 1 + t (-1) is zero at t = 1/2.
TEST(Casteljau, RationalAlgorithmSaysWhereWeightsCancel) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 1, 0, -1}, {2, 0, 0, 1}});
  const RationalTriangle broken = rational_casteljau_triangle(curve, 0.5);
  ASSERT_TRUE(broken.breakdown.has_value());
  EXPECT_EQ(broken.breakdown->row, 1);
  EXPECT_EQ(broken.breakdown->index, 0);
  EXPECT_EQ(broken.breakdown->reason, "the weights 0.5 and -0.5 cancel in row 1, point 0");
  EXPECT_EQ(broken.rows.size(), 1u);
  EXPECT_EQ(casteljau_triangle(curve, 0.5).size(), 3u);
  EXPECT_FALSE(rational_casteljau_triangle(curve, 0.25).breakdown.has_value());
}

TEST(Casteljau, RationalAlgorithmSaysWhichControlPointIsADirection) {
  const BezierCurve curve = BezierCurve::make({{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  const RationalTriangle broken = rational_casteljau_triangle(curve, 0.3);
  ASSERT_TRUE(broken.breakdown.has_value());
  EXPECT_EQ(broken.breakdown->row, 0);
  EXPECT_EQ(broken.breakdown->index, 1);
  EXPECT_EQ(broken.breakdown->reason, "weights[1] = 0: control point 1 is a direction");
  EXPECT_TRUE(broken.rows.empty());
  const glm::dvec4 h = casteljau_triangle(curve, 0.3).back()[0];
  EXPECT_NEAR(std::hypot(h.x, h.y), h.w, 1e-16);
}

TEST(Casteljau, RefusesProductsThatOverflow) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 1e36, 0, 1e300}});
  EXPECT_EQ(refusal([&] { casteljau_triangle(curve, 0.5); }),
            "points[1].y = 1e+36 times weights[1] = 1e+300 is too large for a number");
  const RationalTriangle rows = rational_casteljau_triangle(curve, 0.5);
  ASSERT_FALSE(rows.breakdown.has_value());
  EXPECT_NEAR(rows.rows.back()[0].y / 1e36, 1.0, 1e-15);
}

TEST(Casteljau, RationalAlgorithmSaysWhichPointOverflows) {
  const BezierCurve near = BezierCurve::make({{1e290, 0, 0, 1}, {-1e290, 0, 0, -1 + 0x1p-48}});
  EXPECT_FALSE(rational_casteljau_triangle(near, 0.5).breakdown.has_value());
  const BezierCurve farther = BezierCurve::make({{1.7e308, 0, 0, 1}, {-1.7e308, 0, 0, -1 + 0x1p-48}});
  const RationalTriangle overflown = rational_casteljau_triangle(farther, 0.5);
  ASSERT_TRUE(overflown.breakdown.has_value());
  EXPECT_EQ(overflown.breakdown->reason, "point 0 of row 1 is too large for a number");
  EXPECT_EQ(overflown.rows.size(), 1u);
}

TEST(Casteljau, ExtrapolatesOutside) {
  const BezierCurve parabola = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}});
  for (const double u : {-0.5, 1.5}) {
    const glm::dvec4 expected(2 * u, 4 * u * (1 - u), 0, 1);
    EXPECT_EQ(casteljau_triangle(parabola, u).back()[0], expected) << u;
    EXPECT_EQ(rational_casteljau_triangle(parabola, u).rows.back()[0], expected) << u;
  }
}

TEST(Casteljau, RefusesWhatIsNoNumber) {
  const BezierCurve line = BezierCurve::make({{0, 0, 0, 1}, {1, 1, 0, 1}});
  for (const double u : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_THROW(casteljau_triangle(line, u), InvalidShape);
    EXPECT_THROW(rational_casteljau_triangle(line, u), InvalidShape);
  }
}

}  // namespace
}  // namespace splinecore
