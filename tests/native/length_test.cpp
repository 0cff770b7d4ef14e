#include "splinecore/measure/length.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "splinecore/basis/bernstein.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

NurbsCurve bezier(std::vector<glm::dvec4> points) {
  const int degree = static_cast<int>(points.size()) - 1;
  return NurbsCurve::make(KnotVector::bezier(degree), std::move(points));
}

/// The length of (t², t³) from t = 0.
double semicubical(double t) { return (std::pow(4.0 + 9.0 * t * t, 1.5) - 8.0) / 27.0; }

}  // namespace

TEST(Length, OfACircleInEveryFormAndSize) {
  for (const EllipseForm form :
       {EllipseForm::square, EllipseForm::triangle, EllipseForm::halves, EllipseForm::single}) {
    for (const double radius : {1.0, 1e-150, 1e150}) {
      const auto [value, error] = length(circle({0, 0, 0}, radius, {1, 2, 3}, form));
      EXPECT_NEAR(value / (2.0 * kPi * radius), 1.0, 1e-14);
      EXPECT_LE(error / radius, 1e-12);
    }
  }
  EXPECT_NEAR(length(circle({1e8, 1e8, 0}, 1.0, {0, 0, 1})).value, 2.0 * kPi, 1e-7);
}

TEST(Length, OfPartsOfACircleIsTheirAngle) {
  const NurbsCurve arc = ellipse_arc({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0.3, 4.5);
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const double a = real(random, 0.0, arc.domain().end);
    const double b = real(random, a, arc.domain().end);
    const glm::dvec3 p = point_at(arc, a);
    const glm::dvec3 q = point_at(arc, b);
    double angle = std::atan2(q.y, q.x) - std::atan2(p.y, p.x);
    if (angle < 0.0) angle += 2.0 * kPi;
    EXPECT_NEAR(length(arc, {a, b}).value, 2.0 * angle, 1e-14);
  }
  EXPECT_EQ(length(arc, {1.5, 1.5}).value, 0.0);
}

TEST(Length, OfAParabola) {
  const NurbsCurve curve = bezier({{0, 0, 0, 1}, {0.5, 0, 0, 1}, {1, 1, 0, 1}});
  EXPECT_NEAR(length(curve).value, std::sqrt(5.0) / 2.0 + std::asinh(2.0) / 4.0, 2e-16);
}

TEST(Length, GoesThroughCuspsInsideASpan) {
  for (const double end : {1.0, 1.3, 0.1, 1e-3}) {
    // t from -1 to `end`, in Bernstein's form by blossoms.
    const auto point = [&](double a, double b, double c) {
      return glm::dvec4((a * b + b * c + c * a) / 3.0, a * b * c, 0.0, 1.0);
    };
    const NurbsCurve curve = bezier({point(-1, -1, -1), point(-1, -1, end), point(-1, end, end), point(end, end, end)});
    EXPECT_NEAR(length(curve).value / (semicubical(1.0) + semicubical(end)), 1.0, 1e-13);
  }
}

TEST(Length, OfPartsAddsUpAndIsThatOfARefinedCurve) {
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const Interval domain = curve.domain();
    const double middle = real(random, domain.start, domain.end);
    const double whole = length(curve).value;
    const double parts = length(curve, {domain.start, middle}).value + length(curve, {middle, domain.end}).value;
    EXPECT_NEAR(parts / whole, 1.0, 4e-13);
    EXPECT_NEAR(length(reversed(curve)).value / whole, 1.0, 4e-13);
    if (multiplicity(curve.knot_vector(), middle) == 0) {
      EXPECT_NEAR(length(insert_knot(curve, middle)).value / whole, 1.0, 4e-13);
    }
  }
}

TEST(Length, LiesBetweenTheChordAndThePolygon) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const NurbsCurve curve = bezier(random_points(random, integer(random, 2, 9), Weights::positive));
    double polygon = 0.0;
    for (std::size_t k = 1; k < curve.points().size(); ++k) {
      polygon += glm::length(glm::dvec3(curve.points()[k]) - glm::dvec3(curve.points()[k - 1]));
    }
    const double found = length(curve).value;
    EXPECT_LE(found, polygon * (1.0 + 1e-13));
    EXPECT_GE(found, glm::length(point_at(curve, 1.0) - point_at(curve, 0.0)) * (1.0 - 1e-13));
  }
}

/// Products of two polynomials of degree 128 and more need binomials above row 255.
TEST(Length, OfALineIsThatOfItsEndsAtAnyDegree) {
  for (const int degree : {1, 127, 128, 129, 160, 161, 200, 254, kMaxDegree}) {
    std::vector<glm::dvec4> points;
    for (int i = 0; i <= degree; ++i) points.emplace_back(3.0 * i / degree, 4.0 * i / degree, 0.0, 1.0);
    EXPECT_NEAR(length(bezier(std::move(points))).value, 5.0, 1e-12) << degree;
  }
}

TEST(Length, OfAPointIsNone) { EXPECT_EQ(length(bezier({{1, 2, 3, 1}, {1, 2, 3, 2}, {1, 2, 3, 1}})).value, 0.0); }

TEST(Length, RefusesInfinityAndWrongParameters) {
  const NurbsCurve hyperbola = bezier({{1, 0, 0, 1}, {0, 1, 0, -1.5}, {-1, 0, 0, 1}});
  EXPECT_THROW(length(hyperbola), PointAtInfinity);
  EXPECT_THROW(length(bezier({{1, 0, 0, 1}, {0, 1, 0, 0}})), PointAtInfinity);
  EXPECT_GT(length(hyperbola, {0.0, 0.2}).value, 0.0);
  EXPECT_EQ(refusal([&] { length(hyperbola, {0.2, 0.1}); }), "start = 0.2 is above end = 0.1");
  EXPECT_EQ(refusal([&] { length(hyperbola, {-0.5, 0.1}); }), "start = -0.5 is outside the domain [0, 1]");
  EXPECT_EQ(refusal([&] { length(hyperbola, {0.0, 0.1}, 0.0); }), "tolerance = 0 is not a positive number");
}

}  // namespace splinecore
