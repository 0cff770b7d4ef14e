#include <limits>
#include <numbers>

#include "reference.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(EvaluateCurve, AgreesWithTheRecursionInLongDouble) {
  Random random(20);
  for (const Kind& kind : all_kinds()) {
    const NurbsCurve curve = random_curve(random, kind);
    for (const double u : random_parameters(random, curve.domain(), 8)) {
      const glm::dvec4 expected(homogeneous_derivative(curve, 0, u));
      EXPECT_LE(largest(homogeneous_at(curve, u) - expected), 1e-14 * size_of(curve)) << text_of(kind) << " u " << u;
    }
  }
}

TEST(EvaluateCurve, TakesTheLimitOfTheSideAskedForAtEveryKnot) {
  Random random(21);
  for (const Kind& kind : all_kinds()) {
    if (kind.ends == Ends::periodic) continue;
    const NurbsCurve curve = random_curve(random, kind);
    for (std::size_t i = 0; i < curve.knot_vector().spans().size(); ++i) {
      const double u = curve.knot_vector().span_interval(static_cast<int>(i)).start;
      for (const Side side : {Side::left, Side::right}) {
        const glm::dvec4 expected(homogeneous_derivative(curve, 0, u, side));
        EXPECT_LE(largest(homogeneous_at(curve, u, side) - expected), 1e-14 * size_of(curve)) << text_of(kind);
      }
    }
  }
}

TEST(EvaluateCurve, PassesThroughTheEndPointsOfAClampedCurveBitForBit) {
  Random random(22);
  for (const Kind& kind : all_kinds(Weights::one)) {
    if (kind.ends != Ends::clamped) continue;
    const NurbsCurve curve = random_curve(random, kind);
    EXPECT_EQ(point_at(curve, curve.domain().start), glm::dvec3(curve.points().front())) << text_of(kind);
    EXPECT_EQ(point_at(curve, curve.domain().end), glm::dvec3(curve.points().back())) << text_of(kind);
  }
}

TEST(EvaluateCurve, HasBothValuesOfAGap) {
  const NurbsCurve curve =
      NurbsCurve::make(1, {0, 0, 1, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {5, 0, 0, 1}, {6, 0, 0, 1}});
  EXPECT_EQ(point_at(curve, 1, Side::left).x, 1.0);
  EXPECT_EQ(point_at(curve, 1, Side::right).x, 5.0);
}

TEST(EvaluateCurve, StaysInTheHullWhereWeightsHaveOneSign) {
  Random random(23);
  for (int round = 0; round < 300; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const glm::dvec3 direction = random_vector(random);
    const auto height = [&](const glm::dvec3& p) { return p.x * direction.x + p.y * direction.y + p.z * direction.z; };
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec4& p : curve.points()) {
      low = std::min(low, height(p));
      high = std::max(high, height(p));
    }
    for (const double u : random_parameters(random, curve.domain(), 10)) {
      EXPECT_GE(height(point_at(curve, u)), low - 1e-11);
      EXPECT_LE(height(point_at(curve, u)), high + 1e-11);
    }
  }
}

TEST(EvaluateCurve, CommutesWithAnAffineMap) {
  Random random(24);
  for (int round = 0; round < 200; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const glm::dvec3 axes[] = {random_vector(random, 1), random_vector(random, 1), random_vector(random, 1)};
    const glm::dvec3 offset = random_vector(random);
    const auto map = [&](const glm::dvec3& p) { return p.x * axes[0] + p.y * axes[1] + p.z * axes[2] + offset; };
    std::vector<glm::dvec4> mapped;
    for (const glm::dvec4& p : curve.points()) mapped.emplace_back(map(p), p.w);
    const NurbsCurve image = curve.with_points(mapped);
    for (const double u : random_parameters(random, curve.domain(), 10)) {
      EXPECT_LE(largest(point_at(image, u) - map(point_at(curve, u))), 1e-12);
    }
  }
}

TEST(EvaluateCurve, IsUnchangedWhereAllWeightsAreScaled) {
  Random random(25);
  for (const double scale : {-1.0, 3.0, 1e-30, 1e30}) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    std::vector<glm::dvec4> scaled(curve.points().begin(), curve.points().end());
    for (glm::dvec4& p : scaled) p.w *= scale;
    const NurbsCurve same = curve.with_points(scaled);
    for (const double u : random_parameters(random, curve.domain(), 20)) {
      EXPECT_LE(largest(point_at(same, u) - point_at(curve, u)), 1e-13) << scale;
    }
  }
}

TEST(EvaluateCurve, CirclesStayRoundOnNinePointsAndOnAPeriod) {
  const double h = std::numbers::sqrt2 / 2;
  std::vector<glm::dvec4> points{{1, 0, 0, 1},   {1, 1, 0, h},   {0, 1, 0, 1},  {-1, 1, 0, h}, {-1, 0, 0, 1},
                                 {-1, -1, 0, h}, {0, -1, 0, 1}, {1, -1, 0, h}, {1, 0, 0, 1}};
  const NurbsCurve plain = NurbsCurve::make(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, points);
  points.pop_back();
  const NurbsCurve periodic = NurbsCurve::make(2, {0, 1, 1, 2, 2, 3, 3, 4, 4}, points, true);
  for (int i = -200; i <= 200; ++i) {
    const glm::dvec3 p = point_at(periodic, i / 16.0);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 5e-16) << i;
    if (i >= 0 && i <= 64) {
      EXPECT_NEAR(std::hypot(point_at(plain, i / 16.0).x, point_at(plain, i / 16.0).y), 1.0, 5e-16) << i;
    }
  }
  EXPECT_EQ(point_at(periodic, 0.0), point_at(periodic, 4.0));
}

TEST(EvaluateCurve, GivesTheSameBitsInAnyBatchAndRoundsFloatsOnce) {
  Random random(26);
  const NurbsCurve curve = random_curve(random, {5, 7, Ends::unclamped, Weights::positive});
  const std::vector<double> parameters = random_parameters(random, curve.domain(), 100);
  std::vector<double> points(300);
  std::vector<float> floats(300);
  evaluate(curve, parameters, std::span(points));
  evaluate(curve, parameters, std::span(floats));
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 alone = point_at(curve, parameters[i]);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(points[3 * i + axis], alone[axis]);
      EXPECT_EQ(floats[3 * i + axis], static_cast<float>(alone[axis]));
    }
  }
}

TEST(EvaluateCurve, RefusesOrMarksAPointAtInfinity) {
  // W = (1 - t)^2 - 2 t (1 - t) + t^2 = (1 - 2t)^2.
  const NurbsCurve parabolas = NurbsCurve::make(KnotVector::bezier(2), {{-1, 0, 0, 1}, {0, 1, 0, -1}, {1, 0, 0, 1}});
  const std::vector<double> parameters{0.25, 0.5};
  std::vector<double> points(6);
  try {
    evaluate(parabolas, parameters, std::span(points));
    FAIL() << "infinity has no point";
  } catch (const PointAtInfinity& error) {
    EXPECT_STREQ(error.what(), "the curve passes through infinity at u = 0.5");
  }
  evaluate(parabolas, parameters, std::span(points), {.at_infinity = AtInfinity::nan});
  EXPECT_TRUE(std::isfinite(points[0]));
  for (int axis = 3; axis < 6; ++axis) EXPECT_TRUE(std::isnan(points[axis]));
  EXPECT_EQ(homogeneous_at(parabolas, 0.5).w, 0.0);
}

TEST(EvaluateCurve, RefusesAQuotientThatOverflows) {
  // x = 1e300 (1 - t + k t) / (1 - t - k t) with k = 0.999999999999: 2e312 in the middle, beside which it is finite.
  const double k = 0.999999999999;
  const NurbsCurve curve = NurbsCurve::make(KnotVector::bezier(1), {{1e300, 0, 0, 1}, {-1e300, 0, 0, -k}});
  EXPECT_THROW(point_at(curve, 0.5), PointAtInfinity);
  EXPECT_NEAR(point_at(curve, 0.25).x / (1e300 * (3 + k) / (3 - k)), 1.0, 1e-15);
  // Every point is 1e300.
  const NurbsCurve still = NurbsCurve::make(KnotVector::bezier(1), {{1e300, 0, 0, 1}, {1e300, 0, 0, -k}});
  for (const double u : {0.0, 0.25, 0.75, 1.0}) EXPECT_NEAR(point_at(still, u).x / 1e300, 1.0, 1e-15) << u;
}

TEST(EvaluateCurve, FindsFinitePointsWhoseProductsWithWeightsOverflow) {
  const NurbsCurve huge = NurbsCurve::make(KnotVector::bezier(1), {{1e200, 0, 0, 1e200}, {0, 0, 0, 1}});
  EXPECT_EQ(point_at(huge, 0.25).x, 1e200);
  const NurbsCurve tiny = NurbsCurve::make(KnotVector::bezier(1), {{0.1, 0, 0, 5e-324}, {0.3, 0, 0, 5e-324}});
  EXPECT_DOUBLE_EQ(point_at(tiny, 0.5).x, 0.2);
}

TEST(EvaluateCurve, NamesAParameterOutsideTheDomain) {
  const NurbsCurve line = NurbsCurve::make(KnotVector::bezier(1), {{0, 0, 0, 1}, {1, 0, 0, 1}});
  std::vector<double> points(6);
  EXPECT_EQ(refusal([&] { evaluate(line, std::vector{0.5, -0.5}, std::span(points)); }),
            "u[1] = -0.5 is outside the domain [0, 1]");
  EXPECT_EQ(refusal([&] { point_at(line, std::numeric_limits<double>::quiet_NaN()); }),
            "u[0] = nan is outside the domain [0, 1]");
}

}  // namespace
}  // namespace splinecore
