#include "splinecore/measure/curve_frame.hpp"

#include <glm/geometric.hpp>
#include <limits>

#include "splinecore/conic/ellipse.hpp"
#include "splinecore/curve/transform.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

double curvature_at(const NurbsCurve& curve, double u, Side side = Side::right) {
  double value = 0.0;
  curvature(curve, {&u, 1}, {&value, 1}, side);
  return value;
}

double torsion_at(const NurbsCurve& curve, double u, Side side = Side::right) {
  double value = 0.0;
  torsion(curve, {&u, 1}, {&value, 1}, side);
  return value;
}

MovingFrame frame_at(const NurbsCurve& curve, double u, Side side = Side::right) {
  MovingFrame frame;
  frenet_frames(curve, {&u, 1}, {&frame, 1}, side);
  return frame;
}

/// Polynomials in t on [0, 1] of degree 4 at most, from the coefficients of each coordinate.
NurbsCurve polynomial(const std::array<std::array<double, 5>, 3>& coefficients) {
  std::vector<glm::dvec4> points(5, glm::dvec4(0, 0, 0, 1));
  const double binomials[5][5] = {{1, 0, 0, 0, 0}, {1, .25, 0, 0, 0}, {1, .5, 1.0 / 6, 0, 0}, {1, .75, .5, .25, 0},
                                  {1, 1, 1, 1, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 5; ++i) {
      for (int k = 0; k <= i; ++k) points[i][axis] += binomials[i][k] * coefficients[axis][k];
    }
  }
  return NurbsCurve::make(KnotVector::bezier(4), points);
}

}  // namespace

TEST(CurveFrame, ACircleHasTheCurvatureOfItsRadiusAndNoTorsion) {
  for (const EllipseForm form : {EllipseForm::square, EllipseForm::halves, EllipseForm::single}) {
    const NurbsCurve curve = circle({1, 2, 3}, 0.25, {1, -1, 2}, form);
    Random random(1);
    for (const double u : random_parameters(random, curve.domain(), 50)) {
      EXPECT_NEAR(curvature_at(curve, u), 4.0, 4e-13);
      EXPECT_NEAR(torsion_at(curve, u), 0.0, 1e-12);
      const MovingFrame frame = frame_at(curve, u);
      EXPECT_LE(largest(frame.binormal - glm::normalize(glm::dvec3(1, -1, 2))), 1e-14);
      EXPECT_LE(largest(point_at(curve, u) + 0.25 * frame.normal - glm::dvec3(1, 2, 3)), 1e-14);
    }
  }
}

TEST(CurveFrame, TheTwistedCubicHasItsClosedForm) {
  const NurbsCurve curve = polynomial({{{0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}}});
  for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const double t2 = t * t;
    const double across = 1.0 + 9.0 * t2 + 9.0 * t2 * t2;
    EXPECT_NEAR(curvature_at(curve, t), 2.0 * std::sqrt(across / std::pow(1.0 + 4.0 * t2 + 9.0 * t2 * t2, 3)), 1e-14);
    EXPECT_NEAR(torsion_at(curve, t), 3.0 / across, 1e-13);
  }
}

TEST(CurveFrame, AtAnInflectionTheTorsionIsItsLimit) {
  // y = t³, z = t⁴: the torsion at 0 is 4 · 3! / ... = 4 z₄ / (2 y₃) = 2.
  const NurbsCurve curve = polynomial({{{0, 1, 0, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}}});
  EXPECT_EQ(curvature_at(curve, 0.0), 0.0);
  EXPECT_NEAR(torsion_at(curve, 0.0), 2.0, 1e-11);
  EXPECT_NEAR(torsion_at(curve, 1e-3), 2.0, 1e-4);
  EXPECT_LE(largest(frame_at(curve, 0.0).binormal - glm::dvec3(0, 0, 1)), 1e-11);
}

TEST(CurveFrame, AtCuspsTheCurvatureIsItsLimit) {
  const double inf = std::numeric_limits<double>::infinity();
  // (t², t³) is sharp, (t², t⁴) runs as a parabola, (t², t² + t⁵) does not bend at all.
  EXPECT_EQ(curvature_at(polynomial({{{0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {}}}), 0.0), inf);
  EXPECT_NEAR(curvature_at(polynomial({{{0, 0, 1, 0, 0}, {0, 0, 0, 0, 1}, {}}}), 0.0), 2.0, 1e-13);
  EXPECT_EQ(curvature_at(polynomial({{{0, 0, 1, 0, 0}, {0, 0, 1, 0, 0}, {}}}), 0.0), 0.0);
  const MovingFrame frame = frame_at(polynomial({{{0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {}}}), 0.0);
  EXPECT_LE(largest(frame.tangent - glm::dvec3(1, 0, 0)), 1e-14);
  EXPECT_LE(largest(frame.normal - glm::dvec3(0, 1, 0)), 1e-14);
}

TEST(CurveFrame, ALineIsStraightAndAPointHasNothing) {
  const NurbsCurve line = polynomial({{{0, 1, 0, 0, 0}, {0, 2, 0, 0, 0}, {}}});
  EXPECT_LE(curvature_at(line, 0.3), 1e-15);
  EXPECT_TRUE(std::isnan(torsion_at(line, 0.3)));
  EXPECT_NEAR(frame_at(line, 0.3).tangent.x, std::sqrt(0.2), 1e-15);
  EXPECT_TRUE(std::isnan(frame_at(line, 0.3).normal.x));
  const NurbsCurve point = polynomial({{{1, 0, 0, 0, 0}, {2, 0, 0, 0, 0}, {}}});
  EXPECT_TRUE(std::isnan(curvature_at(point, 0.3)));
  EXPECT_TRUE(std::isnan(frame_at(point, 0.3).tangent.x));
}

TEST(CurveFrame, FramesAreOrthonormalAndTurnWithTheCurve) {
  Random random(2);
  glm::dmat4 turn(1.0);  // a quarter turn about x, scaled by 3
  turn[1] = {0, 0, 3, 0};
  turn[2] = {0, -3, 0, 0};
  turn[0] = {3, 0, 0, 0};
  turn[3] = {7, 8, 9, 1};
  for (int i = 0; i < 100; ++i) {
    const NurbsCurve curve = random_curve(random, {integer(random, 3, 6), 2, Ends::clamped, Weights::positive});
    const double u = real(random, curve.domain().start, curve.domain().end);
    const MovingFrame frame = frame_at(curve, u);
    EXPECT_LE(largest(glm::cross(frame.tangent, frame.normal) - frame.binormal), 1e-14);
    EXPECT_NEAR(glm::length(frame.normal), 1.0, 1e-14);
    const NurbsCurve moved = transformed(curve, turn);
    const double size = std::abs(curvature_at(curve, u)) + 1e-3;
    EXPECT_NEAR(3.0 * curvature_at(moved, u), curvature_at(curve, u), 1e-8 * size);
    EXPECT_NEAR(3.0 * torsion_at(moved, u), torsion_at(curve, u), 1e-6 * (1.0 + std::abs(torsion_at(curve, u))));
    const MovingFrame there = frame_at(moved, u);
    EXPECT_LE(largest(there.tangent - glm::dvec3(turn * glm::dvec4(frame.tangent, 0)) / 3.0), 1e-9);
  }
}

/// The curve with its weights and knots divided by powers of two.
static NurbsCurve divided(const NurbsCurve& curve, int weights, int parameters) {
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& p : points) p.w = std::scalbn(p.w, -weights);
  const auto given = curve.knot_vector().knots();
  std::vector<double> knots(given.begin(), given.end());
  for (double& u : knots) u = std::scalbn(u, -parameters);
  return NurbsCurve::make(curve.degree(), std::move(knots), std::move(points));
}

TEST(CurveFrame, DoesNotDependOnTheScaleOfParametersAndWeights) {
  Random random(3);
  const NurbsCurve curve = random_curve(random, {5, 2, Ends::clamped, Weights::positive});
  for (const auto& [parameters, weights] : {std::pair{700, 0}, std::pair{-700, 0}, std::pair{0, 900},
                                            std::pair{0, -900}, std::pair{500, 500}}) {
    const NurbsCurve other = divided(curve, weights, parameters);
    const double u = 0.3 * curve.domain().start + 0.7 * curve.domain().end;
    const double there = std::scalbn(u, -parameters);
    EXPECT_NEAR(curvature_at(other, there) / curvature_at(curve, u), 1.0, 1e-12) << parameters << " " << weights;
    EXPECT_NEAR(torsion_at(other, there) / torsion_at(curve, u), 1.0, 1e-9) << parameters << " " << weights;
    EXPECT_LE(largest(frame_at(other, there).normal - frame_at(curve, u).normal), 1e-12);
  }
}

TEST(CurveFrame, RefusesACurvatureThatIsNoNumber) {
  const NurbsCurve tiny = NurbsCurve::make(
      KnotVector::bezier(2), {{0, 0, 0, 1}, {1e-310, 0, 0, 1}, {1e-310, 1e-310, 0, 1}});
  EXPECT_EQ(refusal([&] { curvature_at(tiny, 0.0); }), "the curvature is too large for a number");
}

TEST(CurveFrame, SidesOfAKnotAreToldApart) {
  const NurbsCurve curve =
      NurbsCurve::make(2, {0, 0, 0, 1, 2, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 2, 0, 1}, {5, 4, 0, 1}});
  EXPECT_GT(std::abs(curvature_at(curve, 1.0) - curvature_at(curve, 1.0, Side::left)), 0.1);
}

}  // namespace splinecore
