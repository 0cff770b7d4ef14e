#include <numbers>
#include <tuple>

#include "reference.hpp"
#include "splinecore/base/order.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

std::vector<glm::dvec3> derivatives_at(const NurbsCurve& curve, double u, int order, Side side = Side::right) {
  std::vector<glm::dvec3> values(order + 1);
  derivatives(curve, {&u, 1}, order, {&values[0].x, 3 * values.size()}, {.side = side});
  return values;
}

TEST(CurveDerivatives, OfPolynomialCurvesAgreeWithTheDerivedRecursion) {
  Random random(30);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const NurbsCurve curve = random_curve(random, kind);
    for (const double u : random_parameters(random, curve.domain(), 3)) {
      const auto values = derivatives_at(curve, u, 4);
      for (int k = 0; k <= 4; ++k) {
        const double size = sum_of_sizes(curve.knot_vector(), k, u) * size_of(curve);
        const Point expected = homogeneous_derivative(curve, k, u);
        EXPECT_LE(largest(values[k] - glm::dvec3(expected)), 1e-13 * size) << text_of(kind) << " order " << k;
      }
    }
  }
}

// The product rule of A = W C: A^(k) is the sum of C(k, i) W^(i) C^(k-i).
TEST(CurveDerivatives, OfRationalCurvesObeyTheProductRule) {
  Random random(31);
  for (const Kind& kind : all_kinds(Weights::positive)) {
    const NurbsCurve curve = random_curve(random, kind);
    if (curve.points().size() == 1) continue;  // The derivatives of a point are rounding.
    const double u = real(random, curve.domain().start, curve.domain().end);
    const auto values = derivatives_at(curve, u, 3);
    const int binomials[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    for (int k = 0; k <= 3; ++k) {
      glm::dvec3 sum(0.0);
      double size = 0.0;
      for (int i = 0; i <= k; ++i) {
        const glm::dvec3 term =
            binomials[k][i] * static_cast<double>(homogeneous_derivative(curve, i, u).w) * values[k - i];
        sum += term;
        size += largest(term);
      }
      const glm::dvec3 expected(homogeneous_derivative(curve, k, u));
      EXPECT_LE(largest(sum - expected), 1e-11 * (size + largest(expected))) << text_of(kind) << " order " << k;
    }
  }
}

// x = 1 / (1 + t), whose derivative k is (-1)^k k! / (1 + t)^(k + 1).
TEST(CurveDerivatives, OfAHyperbolaFollowTheClosedFormUpToTheHighestOrder) {
  const NurbsCurve curve =
      NurbsCurve::from_homogeneous(KnotVector::bezier(1), std::vector<glm::dvec4>{{1, 0, 0, 1}, {1, 0, 0, 2}});
  for (const double t : {0.0, 0.25, 1.0}) {
    const auto values = derivatives_at(curve, t, kMaxOrder);
    double expected = 1.0 / (1.0 + t);
    for (int k = 0; k <= kMaxOrder; ++k) {
      EXPECT_NEAR(values[k].x / expected, 1.0, 1e-12) << "t " << t << " order " << k;
      expected *= -(k + 1) / (1.0 + t);
    }
  }
}

TEST(CurveDerivatives, OfACircleTurnByARightAngleAndPointToTheCenter) {
  const double w = std::numbers::sqrt2 / 2;
  const NurbsCurve quarter = NurbsCurve::make(KnotVector::bezier(2), {{1, 0, 0, 1}, {1, 1, 0, w}, {0, 1, 0, 1}});
  for (double t = 0.0; t <= 1.0; t += 1.0 / 32) {
    const auto values = derivatives_at(quarter, t, 2);
    const auto& [point, first, second] = std::tie(values[0], values[1], values[2]);
    EXPECT_NEAR(point.x * first.x + point.y * first.y, 0.0, 1e-14);
    // Curvature 1: |C' x C''| = |C'|^3.
    const double speed = std::hypot(first.x, first.y);
    EXPECT_NEAR((first.x * second.y - first.y * second.x) / (speed * speed * speed), 1.0, 1e-13) << t;
  }
}

TEST(CurveDerivatives, AgreeWithDividedDifferencesOfTheCurve) {
  Random random(32);
  for (int round = 0; round < 200; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const auto& knots = curve.knot_vector();
    const Interval span = knots.span_interval(integer(random, 0, static_cast<int>(knots.spans().size()) - 1));
    const double u = span.middle();
    const double h = 1e-5 * span.length();
    const auto values = derivatives_at(curve, u, 3);
    const glm::dvec3 difference = (point_at(curve, u + h) - point_at(curve, u - h)) / (2 * h);
    const double cubic = largest(values[3]) * h * h + 1e-14 * size_of(curve) / h;
    EXPECT_LE(largest(difference - values[1]), 10 * cubic + 1e-8 * largest(values[1]));
  }
}

TEST(CurveDerivatives, AtAnEndDependOnTheFirstPointsOnly) {
  Random random(33);
  for (int degree = 2; degree <= 9; ++degree) {
    std::vector<glm::dvec4> points = random_points(random, degree + 1, Weights::positive);
    const NurbsCurve curve = NurbsCurve::make(KnotVector::bezier(degree), points);
    for (std::size_t i = 3; i < points.size(); ++i) points[i] = random_points(random, 1, Weights::positive)[0];
    EXPECT_EQ(derivatives_at(curve, 0, 2), derivatives_at(curve.with_points(points), 0, 2)) << degree;
    const double ratio = points[1].w / points[0].w;
    const glm::dvec3 tangent = degree * ratio * (glm::dvec3(points[1]) - glm::dvec3(points[0]));
    EXPECT_LE(largest(derivatives_at(curve, 0, 1)[1] - tangent), 1e-12 * largest(tangent)) << degree;
  }
}

TEST(CurveDerivatives, JumpAtAKnotExactlyFromTheOrderItsMultiplicityAllows) {
  Random random(34);
  for (int degree = 2; degree <= 9; ++degree) {
    for (int times = 1; times <= degree; ++times) {
      std::vector<double> knots(degree + 1, 0.0);
      knots.insert(knots.end(), times, 1.0);
      knots.insert(knots.end(), degree + 1, 2.5);
      const NurbsCurve curve =
          NurbsCurve::make(degree, knots, random_points(random, degree + 1 + times, Weights::positive));
      const auto left = derivatives_at(curve, 1, degree, Side::left);
      const auto right = derivatives_at(curve, 1, degree, Side::right);
      const int smooth = degree - times;
      for (int k = 0; k <= smooth; ++k) {
        EXPECT_LE(largest(left[k] - right[k]), 1e-9 * (largest(left[k]) + size_of(curve)))
            << degree << " " << times << " " << k;
      }
      EXPECT_GT(largest(left[smooth + 1] - right[smooth + 1]), 1e-3) << degree << " " << times;
    }
  }
}

TEST(CurveDerivatives, RefuseAnOrderOutsideTheirRange) {
  const NurbsCurve line = NurbsCurve::make(KnotVector::bezier(1), {{0, 0, 0, 1}, {1, 0, 0, 1}});
  EXPECT_EQ(refusal([&] { derivatives_at(line, 0.5, 65); }), "order = 65 is outside [0, 64]");
  double out[3];
  const double u = 0.5;
  EXPECT_EQ(refusal([&] { derivatives(line, {&u, 1}, -1, out); }), "order = -1 is outside [0, 64]");
}

TEST(CurveDerivatives, AtInfinityAreRefusedOrMarked) {
  const NurbsCurve parabolas = NurbsCurve::make(KnotVector::bezier(2), {{-1, 0, 0, 1}, {0, 1, 0, -1}, {1, 0, 0, 1}});
  EXPECT_THROW(derivatives_at(parabolas, 0.5, 1), PointAtInfinity);
  double out[6];
  const double u = 0.5;
  derivatives(parabolas, {&u, 1}, 1, out, {.at_infinity = AtInfinity::nan});
  for (const double value : out) EXPECT_TRUE(std::isnan(value));
}

}  // namespace
}  // namespace splinecore
