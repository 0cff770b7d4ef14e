#include "splinecore/conic/conic_arc.hpp"

#include "splinecore/conic/implicit_form.hpp"
#include "splinecore/curve/moebius.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

BezierCurve quadratic(double w0, double w1, double w2, glm::dvec3 middle = {0, 1, 0}) {
  return BezierCurve::make({{-1, 0, 0, w0}, {middle, w1}, {1, 0, 0, w2}});
}

ConicArcClass class_by(double w1) { return conic_class(conic_arc({-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, w1)); }

TEST(ConicArc, HasTheClassOfItsMiddleWeight) {
  EXPECT_EQ(class_by(2), ConicArcClass::hyperbola_arc);
  EXPECT_EQ(class_by(1), ConicArcClass::parabola_arc);
  EXPECT_EQ(class_by(0.5), ConicArcClass::shorter_ellipse_arc);
  EXPECT_EQ(class_by(0), ConicArcClass::segment);
  EXPECT_EQ(class_by(-0.5), ConicArcClass::longer_ellipse_arc);
  EXPECT_EQ(class_by(-1), ConicArcClass::two_parabola_arcs);
  EXPECT_EQ(class_by(-2), ConicArcClass::three_hyperbola_arcs);
}

TEST(ConicArc, ClassChangesExactlyAtOne) {
  EXPECT_EQ(class_by(1.0 + 1e-14), ConicArcClass::hyperbola_arc);
  EXPECT_EQ(class_by(1.0 - 1e-14), ConicArcClass::shorter_ellipse_arc);
  EXPECT_EQ(class_by(-1.0 - 1e-14), ConicArcClass::three_hyperbola_arcs);
  EXPECT_EQ(class_by(-1.0 + 1e-14), ConicArcClass::longer_ellipse_arc);
}

TEST(ConicArc, ClassDependsOnTheInvariantOnly) {
  Random random(530);
  for (int round = 0; round < 1000; ++round) {
    const double w1 = integer(random, -30, 30) / 10.0;
    if (w1 == 0.0) continue;
    const double factor = (integer(random, 0, 1) == 0 ? 1 : -1) * std::exp2(real(random, -20, 20));
    const BezierCurve curve = moebius(quadratic(factor, factor * w1, factor), std::exp2(real(random, -9, 9)));
    EXPECT_EQ(conic_class(curve), class_by(w1)) << w1;
  }
}

TEST(ConicArc, WithPointsAtInfinityHasItsClass) {
  EXPECT_EQ(conic_class(quadratic(1, 0, 1)), ConicArcClass::half_ellipse);
  EXPECT_EQ(conic_class(BezierCurve::make({{1, 0, 0, 0}, {0, 0, 0, 1}, {0, 1, 0, 0}})), ConicArcClass::hyperbola_arc);
  EXPECT_EQ(conic_class(quadratic(0, 1, 1)), ConicArcClass::hyperbola_arc);
  EXPECT_EQ(conic_class(quadratic(0, -1, 1)), ConicArcClass::two_hyperbola_arcs);
  EXPECT_EQ(conic_class(quadratic(0, 0, 1)), ConicArcClass::parabola_arc);
  EXPECT_EQ(conic_class(quadratic(1, 0, 0)), ConicArcClass::parabola_arc);
  EXPECT_EQ(conic_class(quadratic(1, 0, -1)), ConicArcClass::two_hyperbola_arcs);
  EXPECT_EQ(conic_class(quadratic(1, 5, -1)), ConicArcClass::two_hyperbola_arcs);
  EXPECT_EQ(conic_class(quadratic(-1, -2, -1)), ConicArcClass::hyperbola_arc);
}

TEST(ConicArc, ClassIsTheSameAtAnySize) {
  for (const double size : {1e-200, 1e-9, 1e9, 1e200}) {
    EXPECT_EQ(conic_class(conic_arc({-size, 0, 0}, {0, size, 0}, {size, 0, 0}, 2)), ConicArcClass::hyperbola_arc);
    EXPECT_EQ(conic_class(BezierCurve::make({{1, 0, 0, 1}, {0, size, 0, 0}, {-1, 0, 0, 1}})), ConicArcClass::half_ellipse);
  }
}

TEST(ConicArc, OfPointsOnALineIsALine) {
  EXPECT_EQ(conic_class(quadratic(0, 1, 0)), ConicArcClass::line_through_infinity);
  EXPECT_EQ(conic_class(quadratic(1, 2, 1, {0, 0, 0})), ConicArcClass::segment);
  EXPECT_EQ(conic_class(quadratic(1, -2, 1, {0.5, 0, 0})), ConicArcClass::line_through_infinity);
  EXPECT_EQ(conic_class(quadratic(1, 0, 1, {3, 0, 0})), ConicArcClass::segment);
  EXPECT_EQ(conic_class(quadratic(0, 1, 1, {3, 0, 0})), ConicArcClass::line_through_infinity);
  const auto same = [](double w1) { return conic_class(conic_arc({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, w1)); };
  EXPECT_EQ(same(1), ConicArcClass::point);
  EXPECT_EQ(same(0), ConicArcClass::point);
  // Collinear up to rounding: 0.1, 0.2 and 0.3 are no exact numbers.
  EXPECT_EQ(conic_class(BezierCurve::make({{0.1, 0.3, 1.1, 1}, {0.2, 0.6, 1.2, 1}, {0.3, 0.9, 1.3, 1}})),
            ConicArcClass::segment);
}

TEST(ConicArc, WithTheCosineOfHalfItsAngleIsACircle) {
  for (const double half : {0.1, 0.5, 1.0, 1.4, 2.0, 2.8}) {
    const glm::dvec3 end(std::cos(half), std::sin(half), 0);
    const BezierCurve arc = conic_arc({end.x, -end.y, 0}, {1.0 / end.x, 0, 0}, end, std::cos(half));
    for (int i = 0; i <= 100; ++i) {
      const glm::dvec3 p = point_at(arc.nurbs(), i / 100.0);
      EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-14) << half;
    }
    EXPECT_EQ(implicit_conic(arc).type(), ConicType::circle);
  }
}

TEST(ConicArc, RefusesWhatIsNone) {
  EXPECT_NE(refusal([] { conic_arc({0, 0, 0}, {1, 1, 0}, {2, std::nan(""), 0}, 1); }).find("p2.y = nan"), std::string::npos);
  EXPECT_EQ(refusal([] { conic_arc({0, 0, 0}, {1, 1, 0}, {2, 0, 0}, INFINITY); }), "w1 = inf is not finite");
  EXPECT_EQ(refusal([] { conic_class(BezierCurve::make({{0, 0, 0, 1}, {1, 0, 0, 1}})); }),
            "degree = 1: a conic is a curve of degree 2");
}

}  // namespace
}  // namespace splinecore
