#include "splinecore/curve/bezier_degree.hpp"

#include <glm/geometric.hpp>

#include "splinecore/curve/flatten.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

double largest_distance(const BezierCurve& a, const BezierCurve& b, int steps) {
  double distance = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    distance = worse(distance, glm::distance(point_at(a.nurbs(), t), point_at(b.nurbs(), t)));
  }
  return distance;
}

TEST(Elevated, HasTheLecturesPoints) {
  const BezierCurve curve = elevated(BezierCurve::make({{0, 0, 0, 1}, {3, 6, 0, 1}, {9, 0, 3, 1}}));
  const std::vector<glm::dvec4> expected{{0, 0, 0, 1}, {2, 4, 0, 1}, {5, 4, 1, 1}, {9, 0, 3, 1}};
  ASSERT_EQ(curve.degree(), 3);
  for (int i = 0; i < 4; ++i) EXPECT_LE(largest(curve.points()[i] - expected[i]), 1e-15);
}

TEST(Elevated, KeepsTheCurveOnAThousandRationalCurves) {
  Random random(340);
  for (int round = 0; round < 1000; ++round) {
    const Weights weights = static_cast<Weights>(round % 3);
    const BezierCurve curve = BezierCurve::make(random_points(random, integer(random, 2, 10), weights));
    const int times = integer(random, 1, 5);
    const BezierCurve higher = elevated(curve, times);
    EXPECT_EQ(higher.degree(), curve.degree() + times);
    EXPECT_EQ(higher.nurbs().rational(), curve.nurbs().rational());
    EXPECT_EQ(higher.points().front(), curve.points().front());
    EXPECT_EQ(higher.points().back(), curve.points().back());
    for (const double t : random_parameters(random, {0, 1}, 5)) {
      const glm::dvec4 difference = homogeneous_at(higher.nurbs(), t) - homogeneous_at(curve.nurbs(), t);
      EXPECT_LE(largest(difference), 1e-12 * size_of(curve.nurbs()));
    }
  }
}

TEST(Elevated, RefusesTimesAndDegreesOutOfRange) {
  const BezierCurve line = BezierCurve::make({{0, 0, 0, 1}, {1, 0, 0, 1}});
  EXPECT_EQ(elevated(line, 0), line);
  EXPECT_EQ(refusal([&] { elevated(line, -1); }), "times = -1 is outside [0, 254]");
  EXPECT_EQ(refusal([&] { elevated(line, 255); }), "times = 255 is outside [0, 254]");
  EXPECT_EQ(elevated(line, 254).degree(), 255);
}

TEST(Reduced, UndoesElevation) {
  Random random(341);
  for (int round = 0; round < 500; ++round) {
    const Weights weights = round % 2 == 0 ? Weights::one : Weights::positive;
    const int degree = integer(random, 1, 15);
    const int times = integer(random, 1, 5);
    const BezierCurve curve = BezierCurve::make(random_points(random, degree + 1, weights));
    const auto [again, error] = reduced(elevated(curve, times), times);
    EXPECT_LE(error, 1e-10);
    for (int i = 0; i <= degree; ++i) {
      EXPECT_LE(largest(again.points()[i] - curve.points()[i]), 1e-10 * size_of(curve.nurbs())) << degree << " " << times;
    }
  }
}

TEST(Reduced, ByOneHasExactlyTheErrorThatItSays) {
  Random random(342);
  for (int degree = 2; degree <= 12; ++degree) {
    const BezierCurve curve = BezierCurve::make(random_points(random, degree + 1, Weights::one));
    const auto [lower, error] = reduced(curve);
    EXPECT_EQ(lower.degree(), degree - 1);
    EXPECT_NEAR(largest_distance(curve, lower, 20000), error, 1e-6 * error) << degree;
    EXPECT_EQ(lower.points().front(), curve.points().front());
    EXPECT_EQ(lower.points().back(), curve.points().back());
  }
}

// x^2 between its ends: the chord is 1/4 too high in the middle.
TEST(Reduced, OfAParabolaIsItsChord) {
  const auto [chord, error] = reduced(BezierCurve::make({{0, 0, 0, 1}, {0.5, 0, 0, 1}, {1, 1, 0, 1}}));
  EXPECT_EQ(chord.points()[1], glm::dvec4(1, 1, 0, 1));
  EXPECT_NEAR(error, 0.25, 1e-16);
}

TEST(Reduced, StaysWithinItsBoundAlsoInManyStepsAndWithWeights) {
  Random random(343);
  for (int round = 0; round < 300; ++round) {
    const int degree = integer(random, 3, 10);
    std::vector<glm::dvec4> points;
    for (int i = 0; i <= degree; ++i) {
      points.emplace_back(i, std::sin(i), random_vector(random, 0.5).z, 1 + 0.1 * std::cos(i * i));
    }
    const BezierCurve curve = BezierCurve::make(points);
    const auto [lower, error] = reduced(curve, integer(random, 1, degree - 2));
    EXPECT_LE(largest_distance(curve, lower, 200), error * (1 + 1e-9) + 1e-12) << degree;
  }
}

TEST(Reduced, OfTheHighestDegreeIsFinite) {
  Random random(344);
  const BezierCurve curve = BezierCurve::make(random_points(random, 256, Weights::one));
  const auto [lower, error] = reduced(curve);
  EXPECT_LE(largest_distance(curve, lower, 50), error + 1e-10);
  EXPECT_LE(error, 10.0);
}

TEST(Reduced, KeepsToTheTolerance) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {0.5, 0, 0, 1}, {1, 1, 0, 1}});
  EXPECT_EQ(reduced(curve, 1, 0.3).value.degree(), 1);
  try {
    reduced(curve, 1, 0.2);
    FAIL();
  } catch (const ToleranceNotReached& error) {
    EXPECT_NEAR(error.error(), 0.25, 1e-15);
    EXPECT_EQ(std::string(error.what()).substr(0, 62), "the degree cannot be reduced within 0.2: the error would be 0.");
  }
  EXPECT_EQ(refusal([&] { reduced(curve, 2); }), "times = 2 is outside [1, 1]");
  EXPECT_EQ(refusal([&] { reduced(curve, 1, -1); }), "tolerance = -1 is not 0 or more");
  EXPECT_EQ(refusal([&] { reduced(reduced(curve).value); }), "degree = 1 cannot be reduced");
  EXPECT_EQ(refusal([&] { reduced(BezierCurve::make({{0, 0, 0, 1}, {1, 0, 0, 0}, {1, 1, 0, 1}})); }),
            "weights[1] = 0: the degree is reduced only where all weights have one sign");
}

double distance_to_line(const glm::dvec3& point, const Flattened& line) {
  double nearest = 1e300;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const glm::dvec3 way = line.points[i] - line.points[i - 1];
    const double share = glm::dot(point - line.points[i - 1], way) / std::max(glm::dot(way, way), 1e-300);
    nearest = std::min(nearest, glm::distance(point, line.points[i - 1] + std::clamp(share, 0.0, 1.0) * way));
  }
  return nearest;
}

TEST(Flattened, StaysWithinTheToleranceOfRationalCurvesToo) {
  Random random(345);
  for (int round = 0; round < 200; ++round) {
    const Weights weights = round % 2 == 0 ? Weights::one : Weights::positive;
    const BezierCurve curve = BezierCurve::make(random_points(random, integer(random, 2, 7), weights));
    const double tolerance = std::exp2(-integer(random, 0, 9));
    const Flattened line = flattened(curve, tolerance);
    EXPECT_EQ(line.parameters.front(), 0.0);
    EXPECT_EQ(line.parameters.back(), 1.0);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      EXPECT_LE(largest(point_at(curve.nurbs(), line.parameters[i]) - line.points[i]), 1e-13 * size_of(curve.nurbs()));
    }
    for (const double t : random_parameters(random, {0, 1}, 50)) {
      EXPECT_LE(distance_to_line(point_at(curve.nurbs(), t), line), tolerance * (1 + 1e-9));
    }
  }
}

TEST(Flattened, OfALineIsItsEnds) {
  const BezierCurve line = BezierCurve::make({{0, 0, 0, 1}, {1, 1, 0, 3}, {2, 2, 0, 1}});
  EXPECT_EQ(flattened(line, 1e-12).points.size(), 2u);
}

TEST(Flattened, OfASemicircleWithAPointAtInfinityIsRound) {
  const BezierCurve arc = BezierCurve::make({{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  const Flattened line = flattened(arc, 1e-3);
  EXPECT_GT(line.points.size(), 16u);
  EXPECT_LT(line.points.size(), 130u);
  for (const glm::dvec3& point : line.points) EXPECT_NEAR(glm::length(point), 1.0, 1e-15);
}

TEST(Flattened, RefusesInfinityAndTolerancesThatAreTooSmall) {
  const auto refused = [](std::vector<glm::dvec4> points, double tolerance) {
    return refusal([&] { flattened(BezierCurve::make(points), tolerance); });
  };
  const std::vector<glm::dvec4> arc{{1, 0, 0, 1}, {1, 1, 0, 0.5}, {0, 1, 0, 1}};
  EXPECT_EQ(refused(arc, 0), "tolerance = 0 is not a positive, finite number");
  EXPECT_EQ(refused(arc, 1e-30), "tolerance = 1e-30 is too small: 262144 points do not reach it");
  EXPECT_EQ(refused(arc, 1.0 / 0.0), "tolerance = inf is not a positive, finite number");
  EXPECT_THROW(flattened(BezierCurve::make({{1, 0, 0, 1}, {0, 1, 0, -1}, {-1, 0, 0, 1}}), 0.1), PointAtInfinity);
  EXPECT_THROW(flattened(BezierCurve::make({{1, 0, 0, 0}, {0, 1, 0, 1}}), 0.1), PointAtInfinity);
  EXPECT_THROW(flattened(BezierCurve::make({{0, 1, 0, 1}, {1, 0, 0, 0}}), 0.1), PointAtInfinity);
}

}  // namespace
}  // namespace splinecore
