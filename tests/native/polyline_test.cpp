#include "splinecore/tessellate/polyline.hpp"

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

bool all_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

glm::dvec3 point_of(const Polyline& line, std::size_t i) {
  return {line.points[3 * i], line.points[3 * i + 1], line.points[3 * i + 2]};
}

TEST(Polylines, HaveTheAskedStepsInEverySpanAndLieOnTheCurve) {
  const NurbsCurve curve =
      NurbsCurve::make(2, {0, 0, 0, 1, 3, 3, 3}, {{0, 0, 0, 1}, {1, 2, 0, 1}, {3, 1, 1, 1}, {4, 0, 0, 1}});
  const auto lines = polylines(curve, 4);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  ASSERT_EQ(lines[0].points.size(), 27u);
  const double parameters[] = {0, 0.25, 0.5, 0.75, 1, 1.5, 2, 2.5, 3};
  for (int i = 0; i < 9; ++i) EXPECT_EQ(point_of(lines[0], i), point_at(curve, parameters[i])) << i;
}

TEST(Polylines, OfAPeriodicCurveWhoseProductsAllOverflowAreItsPoints) {
  Random random(51);
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 6; ++i) points.emplace_back(1e36 * real(random, 1, 2), 1e36 * real(random, -2, -1), 0.0, 1e300);
  const NurbsCurve curve = NurbsCurve::make(3, {0, 1, 2, 3, 4, 5, 6}, points, true);
  for (glm::dvec4& point : points) point.w = 1.0;
  const NurbsCurve alike = NurbsCurve::make(3, {0, 1, 2, 3, 4, 5, 6}, points, true);
  ASSERT_EQ(polylines(curve, 3).size(), 1u);
  ASSERT_EQ(polylines(curve, 3)[0].points.size(), polylines(alike, 3)[0].points.size());
  for (std::size_t i = 0; i < polylines(alike, 3)[0].points.size(); ++i) {
    EXPECT_NEAR(polylines(curve, 3)[0].points[i], polylines(alike, 3)[0].points[i], 1e22);
  }
}

TEST(Polylines, OfAPeriodicCurveAreClosedWithoutARepeatedPoint) {
  Random random(50);
  const NurbsCurve curve =
      NurbsCurve::make(KnotVector::periodic_uniform(3, 5), random_points(random, 5, Weights::positive));
  const auto lines = polylines(curve, 3);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  ASSERT_EQ(lines[0].points.size(), 45u);
  EXPECT_EQ(point_of(lines[0], 0), point_at(curve, 0));
  EXPECT_EQ(point_of(lines[0], 14), point_at(curve, 14 / 3.0));
}

TEST(Polylines, OfAPlainCurveThatReturnsToItsStartAreClosed) {
  const NurbsCurve triangle =
      NurbsCurve::make(KnotVector::clamped(1, 4), {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}});
  const auto lines = polylines(triangle, 1);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(Polylines, EndBeforeInfinityAndNeverCrossIt) {
  for (const double w1 : {-1.0, -1.5, -3.0}) {
    const NurbsCurve conic = NurbsCurve::make(KnotVector::bezier(2), {{-1, 0, 0, 1}, {0, 1, 0, w1}, {1, 0, 0, 1}});
    const auto lines = polylines(conic, 64);
    ASSERT_EQ(lines.size(), w1 == -1.0 ? 2u : 3u) << w1;
    for (const Polyline& line : lines) EXPECT_TRUE(all_finite(line.points));
    // The outer arcs lie on their own sides of the middle.
    for (std::size_t i = 0; i < lines.front().points.size(); i += 3) EXPECT_LT(lines.front().points[i], 0.0);
    for (std::size_t i = 0; i < lines.back().points.size(); i += 3) EXPECT_GT(lines.back().points[i], 0.0);
  }
}

TEST(Polylines, AreFiniteWhereverTheRootOfTheWeightFalls) {
  Random random(51);
  for (int round = 0; round < 300; ++round) {
    const double start = real(random, -2, 2);
    const double end = start + real(random, 0.1, 3);
    const NurbsCurve conic =
        NurbsCurve::make(2, {start, start, start, end, end, end}, {{-1, 0, 0, 1}, {0, 1, 0, -1}, {1, 0, 0, 1}});
    const auto lines = polylines(conic, 2 * integer(random, 1, 20));
    EXPECT_LE(lines.size(), 2u);
    for (const Polyline& line : lines) EXPECT_TRUE(all_finite(line.points));
  }
}

TEST(Polylines, OfRandomCurvesAreFinite) {
  Random random(52);
  for (int round = 0; round < 500; ++round) {
    const NurbsCurve curve = random_curve(random);
    for (const Polyline& line : polylines(curve, integer(random, 1, 8))) {
      EXPECT_GE(line.points.size(), 6u);
      EXPECT_TRUE(all_finite(line.points));
    }
  }
}

TEST(Polylines, OfAHyperbolaStayBetweenItsEndsAtInfinity) {
  const NurbsCurve hyperbola = NurbsCurve::make(KnotVector::bezier(2), {{0, 1, 0, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}});
  const auto lines = polylines(hyperbola, 4);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  ASSERT_EQ(lines[0].points.size(), 9u);
  // x = t / (2 (1 - t)) and y = (1 - t) / (2 t), so 4 x y = 1.
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(4 * point_of(lines[0], i).x * point_of(lines[0], i).y, 1.0, 1e-15);
}

TEST(Polylines, OfAPeriodicCurveWithItsSeamAtInfinityAreOpen) {
  // Degree 3 on uniform knots: the weight at the seam is (w0 + 4 w1 + w2) / 6, here a double root.
  const NurbsCurve curve = NurbsCurve::make(
      KnotVector::periodic_uniform(3, 5), {{1, 0, 0, 1}, {0, 1, 0, -0.5}, {-1, 0, 0, 1}, {0, -1, 0, 1}, {0, 0, 1, 1}});
  const auto lines = polylines(curve, 4);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_EQ(lines[0].points.size(), 3u * 19);
  for (const double x : lines[0].points) EXPECT_LT(std::abs(x), 1e3);
}

TEST(Polylines, EndBeforeAnEndThatIsAtInfinityUpToRounding) {
  // The weight at the start is 0 in exact arithmetic: (1 - a) w0 + a w1 with a = 1/3.
  const NurbsCurve curve = NurbsCurve::make(2, {-0.2, 0, 0.1, 0.3, 1, 1.2, 1.5},
                                            {{1, 0, 0, 0.1}, {0, 1, 0, -0.2}, {-1, 0, 0, -0.2}, {0, -1, 0, -0.2}});
  for (const Polyline& line : polylines(curve, 4)) {
    for (const double x : line.points) EXPECT_LT(std::abs(x), 1e6);
  }
}

TEST(Polylines, OfPiecesWithAGapAreSeparate) {
  const NurbsCurve curve =
      NurbsCurve::make(1, {0, 0, 1, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {5, 0, 0, 1}, {6, 0, 0, 1}});
  const auto lines = polylines(curve, 1);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].points, (std::vector<double>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(lines[1].points, (std::vector<double>{5, 0, 0, 6, 0, 0}));
}

TEST(Polylines, RefuseAnAbsurdResolution) {
  const NurbsCurve line = NurbsCurve::make(KnotVector::bezier(1), {{0, 0, 0, 1}, {1, 0, 0, 1}});
  EXPECT_EQ(refusal([&] { polylines(line, 0); }), "resolution = 0 is outside [1, 4096]");
  EXPECT_EQ(refusal([&] { polylines(line, 4097); }), "resolution = 4097 is outside [1, 4096]");
  const KnotVector knots = KnotVector::uniform(1, 1100);
  const NurbsCurve long_line = NurbsCurve::make(knots, std::vector<glm::dvec4>(1100, glm::dvec4(1.0)));
  EXPECT_EQ(refusal([&] { polylines(long_line, 4096); }),
            "the polyline would have more than 2^22 points: lower the resolution");
}

}  // namespace
}  // namespace splinecore
