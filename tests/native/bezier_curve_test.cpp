#include "splinecore/curve/bezier_curve.hpp"

#include "reference.hpp"
#include "splinecore/base/points.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(BezierCurve, OfAnyDegreeUpTo60AgreesWithDeCasteljauInLongDouble) {
  Random random(70);
  for (int degree = 1; degree <= 60; ++degree) {
    for (const Weights weights : {Weights::one, Weights::positive, Weights::any}) {
      const BezierCurve curve = BezierCurve::make(random_points(random, degree + 1, weights));
      for (const double t : random_parameters(random, {0, 1}, 5)) {
        const glm::dvec4 expected(de_casteljau(long_homogeneous(curve.points()), t).left.back());
        EXPECT_LE(largest(homogeneous_at(curve.nurbs(), t) - expected), 1e-13 * size_of(curve.nurbs())) << degree;
      }
    }
  }
}

TEST(BezierCurve, WithPositivePointsHasSmallRelativeErrorAtDegree60) {
  Random random(71);
  std::vector<glm::dvec4> points;
  for (int i = 0; i <= 60; ++i)
    points.emplace_back(std::exp(real(random, -20, 20)), std::exp(real(random, -20, 20)), 1, 1);
  const BezierCurve curve = BezierCurve::make(points);
  for (const double t : random_parameters(random, {0, 1}, 200)) {
    const glm::dvec4 expected(de_casteljau(long_homogeneous(points), t).left.back());
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(point_at(curve.nurbs(), t)[axis] / expected[axis], 1.0, 1e-13) << t;
  }
}

// Lecture row S6: the rows for [t^3 t^2 t 1] are [-1 3 -3 1; 3 -6 3 0; -3 3 0 0; 1 0 0 0].
TEST(BezierCurve, OfDegreeThreeIsTheMatrixOfTheLectures) {
  const int matrix[4][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
  Random random(72);
  const BezierCurve curve = BezierCurve::make(random_points(random, 4, Weights::one));
  for (const double t : random_parameters(random, {0, 1}, 20)) {
    glm::dvec3 expected(0.0);
    for (int power = 0; power < 4; ++power) {
      for (int i = 0; i < 4; ++i) expected += std::pow(t, 3 - power) * matrix[power][i] * glm::dvec3(curve.points()[i]);
    }
    EXPECT_LE(largest(point_at(curve.nurbs(), t) - expected), 1e-13);
  }
}

TEST(BezierCurveSplit, GivesBothSidesOfDeCasteljausTriangle) {
  Random random(73);
  for (const int degree : {1, 2, 3, 5, 9, 20, 60}) {
    for (const double u : {0.5, 0.1, 0.75}) {
      const BezierCurve curve = BezierCurve::make(random_points(random, degree + 1, Weights::any));
      const Triangle triangle = de_casteljau(long_homogeneous(curve.points()), u);
      const auto [left, right] = split(curve, u);
      for (int i = 0; i <= degree; ++i) {
        const double tolerance = 1e-13 * size_of(curve.nurbs());
        EXPECT_LE(largest(homogeneous(left.points()[i]) - glm::dvec4(triangle.left[i])), tolerance) << degree;
        EXPECT_LE(largest(homogeneous(right.points()[i]) - glm::dvec4(triangle.right[i])), tolerance) << degree;
      }
      EXPECT_EQ(left.points().front(), curve.points().front());
      EXPECT_EQ(right.points().back(), curve.points().back());
    }
  }
}

TEST(BezierCurveSplit, RefusesTheEndsAndWhatIsNoParameter) {
  const BezierCurve line = BezierCurve::make({{0, 0, 0, 1}, {1, 0, 0, 1}});
  EXPECT_EQ(refusal([&] { split(line, 0); }), "u = 0 is not inside the domain (0, 1)");
  EXPECT_EQ(refusal([&] { split(line, 1); }), "u = 1 is not inside the domain (0, 1)");
  EXPECT_NE(refusal([&] { split(line, 0.0 / 0.0); }), "not refused");
}

TEST(BezierCurveReversed, IsTheSameCurveBackwards) {
  Random random(74);
  for (const int degree : {1, 3, 9, 60}) {
    const BezierCurve curve = BezierCurve::make(random_points(random, degree + 1, Weights::positive));
    EXPECT_EQ(reversed(reversed(curve)), curve);
    for (const double t : {0.0, 0.125, 0.5, 0.75, 1.0}) {
      EXPECT_LE(largest(point_at(curve.nurbs(), t) - point_at(reversed(curve).nurbs(), 1 - t)), 1e-12) << degree;
    }
  }
}

TEST(BezierCurve, OfCollinearPointsIsALine) {
  Random random(75);
  std::vector<glm::dvec4> points;
  const glm::dvec3 direction = random_vector(random);
  for (int i = 0; i <= 9; ++i)
    points.emplace_back(real(random, -1, 1) * direction, random_weight(random, Weights::positive));
  for (const double t : random_parameters(random, {0, 1}, 20)) {
    const glm::dvec3 p = point_at(BezierCurve::make(points).nurbs(), t);
    EXPECT_NEAR(p.x * direction.y - p.y * direction.x, 0.0, 1e-13);
    EXPECT_NEAR(p.y * direction.z - p.z * direction.y, 0.0, 1e-13);
  }
}

TEST(BezierCurveMake, NamesWhatIsWrong) {
  const auto refused = [](std::vector<glm::dvec4> points) { return refusal([&] { BezierCurve::make(points); }); };
  EXPECT_EQ(refused({}), "points has 0 rows, a Bezier curve needs 2 or more");
  EXPECT_EQ(refused({{0, 0, 0, 1}}), "points has 1 rows, a Bezier curve needs 2 or more");
  EXPECT_EQ(refused(std::vector<glm::dvec4>(257, glm::dvec4(1))), "degree = 256 is outside [0, 255]");
  EXPECT_EQ(BezierCurve::make(std::vector<glm::dvec4>(256, glm::dvec4(1))).degree(), 255);
  EXPECT_EQ(refused({{0, 0, 0, 1}, {0.0 / 0.0, 0, 0, 1}}).substr(0, 12), "points[1].x ");
  EXPECT_EQ(refused({{1, 0, 0, 0}, {0, 1, 0, 0}}), "weights are all zero: no point of the shape is finite");
}

}  // namespace
}  // namespace splinecore
