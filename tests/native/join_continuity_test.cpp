#include <limits>

#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/curve/transform.hpp"
#include "splinecore/measure/continuity.hpp"
#include "splinecore/tessellate/polyline.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

NurbsCurve bezier(std::vector<glm::dvec4> points) {
  const KnotVector knots = KnotVector::bezier(static_cast<int>(points.size()) - 1);
  return NurbsCurve::make(knots, std::move(points));
}

/// A quarter of a circle about (0, center) from its lowest point, to the right.
NurbsCurve quarter(double radius, double center) {
  const double low = center - radius;
  return bezier({{0, low, 0, 1}, {radius, low, 0, std::sqrt(0.5)}, {radius, center, 0, 1}});
}

/// The x axis from -1 to 0.
NurbsCurve line() { return bezier({{-1, 0, 0, 1}, {0, 0, 0, 1}}); }

TEST(Continuity, OfALineAndACircleDiffersByTheCurvature) {
  for (const double radius : {1e-3, 0.5, 1.0, 40.0}) {
    const Continuity found = continuity_between(line(), quarter(radius, radius));
    EXPECT_LE(found.gap, 1e-15);
    EXPECT_LE(found.angle, 1e-15);
    EXPECT_NEAR(found.curvature_difference, 1 / radius, 1e-12 / radius);
    EXPECT_EQ(found.g, 1);
  }
}

TEST(Continuity, AtKnotsOfRandomCurvesIsTheirsOfTheBasis) {
  Random random(70);
  for (const Kind& kind : all_kinds(Weights::positive)) {
    const NurbsCurve curve = random_curve(random, kind);
    for (const Joint& joint : joints(curve)) {
      if (joint.u == curve.domain().start) continue;
      const int times = multiplicity(curve.knot_vector(), joint.u);
      EXPECT_EQ(joint.continuity.c, curve.degree() - times) << text_of(kind) << ", u = " << joint.u;
    }
  }
}

TEST(Continuity, OfACuspTurnsBack) {
  const NurbsCurve cusp = bezier({{1, -1, 0, 1}, {-1 / 3.0, 1, 0, 1}, {-1 / 3.0, -1, 0, 1}, {1, 1, 0, 1}});
  const Continuity found = continuity_at(cusp, 0.5);
  EXPECT_NEAR(found.angle, std::acos(-1.0), 1e-15);
  EXPECT_EQ(found.curvature_difference, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found.c, 3);
  EXPECT_EQ(found.g, 0);
}

TEST(Continuity, AtInfinityIsRefused) {
  const NurbsCurve parabola = bezier({{1, 0, 0, 1}, {0, 1, 0, -1}, {-1, 0, 0, 1}});
  EXPECT_THROW(continuity_at(parabola, 0.5), PointAtInfinity);
  EXPECT_THROW(continuity_between(bezier({{0, 0, 0, 1}, {1, 0, 0, 0}}), line()), PointAtInfinity);
  EXPECT_TRUE(joints(parabola).empty());
}

TEST(Joined, HasTheSmoothnessThatWasAskedFor) {
  Random random(71);
  for (int round = 0; round < 300; ++round) {
    const NurbsCurve a = random_curve(random, {integer(random, 1, 7), integer(random, 1, 3), Ends::clamped,
                                               Weights::positive});
    const NurbsCurve b = random_curve(random, {integer(random, 1, 7), integer(random, 1, 3), Ends::clamped,
                                               Weights::positive});
    for (const Smoothness wanted : {Smoothness::c0, Smoothness::g1, Smoothness::c1, Smoothness::c2}) {
      const Continuity found = continuity_at(joined(a, b, wanted).value, a.domain().end);
      EXPECT_GE(found.c, wanted == Smoothness::c2 ? 2 : wanted == Smoothness::c1 ? 1 : 0) << round;
      EXPECT_GE(found.g, wanted == Smoothness::c0 ? 0 : wanted == Smoothness::c2 ? 2 : 1) << round;
    }
  }
}

TEST(Joined, BothHalvesOfACurveAreTheCurve) {
  Random random(72);
  for (int degree = 2; degree <= 9; ++degree) {
    const NurbsCurve whole = random_curve(random, {degree, 1, Ends::clamped, Weights::positive});
    const auto [left, right] = split(whole, whole.domain().middle());
    const Approximation<NurbsCurve> again = joined(left, right, Smoothness::g1);
    EXPECT_EQ(again.value.knot_vector(), whole.knot_vector()) << degree;
    EXPECT_LE(again.error, 1e-12 * size_of(whole));
    EXPECT_LE(largest_distance(again.value, whole), 1e-11 * size_of(whole));
  }
}

TEST(Joined, RefusesWhatHasNoEndInSight) {
  const NurbsCurve ring =
      NurbsCurve::make(KnotVector::periodic_uniform(2, 3), std::vector<glm::dvec4>(3, glm::dvec4(1)));
  EXPECT_EQ(refusal([&] { joined(line(), ring, Smoothness::c0); }), "a periodic curve has no end to join");
  EXPECT_EQ(refusal([&] { joined(bezier({{0, 0, 0, 1}, {1, 0, 0, 0}}), line(), Smoothness::c0); }),
            "an end to join lies at infinity");
  EXPECT_EQ(refusal([&] { joined(line(), reversed(line()), Smoothness::g1); }),
            "the curves leave the joint the same way: no direction lies between them");
}

TEST(LargestDistance, IsInfiniteWhereOneCurveAloneRunsToInfinity) {
  const auto conic = [](double weight) { return bezier({{1, 0, 0, 1}, {0, 1, 0, weight}, {-1, 0, 0, 1}}); };
  for (const double weight : {-1.0, -1.5, -20.0}) {
    EXPECT_EQ(largest_distance(conic(0.5), conic(weight)), HUGE_VAL) << weight;
    EXPECT_EQ(largest_distance(conic(weight), conic(-0.5)), HUGE_VAL) << weight;
    EXPECT_LE(largest_distance(conic(weight), insert_knot(conic(weight), 0.3)), 1e-11) << weight;
  }
}

TEST(Polylines, EndAtTheReach) {
  const NurbsCurve hyperbola = bezier({{1, 0, 0, 1}, {0, 1, 0, -1.5}, {-1, 0, 0, 1}});
  for (const double reach : {3.0, 50.0, 1e4}) {
    const auto lines = polylines(hyperbola, 32, reach);
    ASSERT_EQ(lines.size(), 3u) << reach;
    double farthest = 0.0;
    for (const Polyline& line : lines) {
      EXPECT_FALSE(line.closed);
      for (const double x : line.points) farthest = worse(farthest, std::abs(x));
    }
    EXPECT_NEAR(farthest, reach + 1, 1e-3 * reach);
  }
  EXPECT_EQ(refusal([&] { polylines(hyperbola, 32, -1.0); }), "reach = -1 is not a positive length");
  EXPECT_EQ(refusal([&] { polylines(line(), 32, 0.0); }), "reach = 0 is not a positive length");
}

TEST(Polynomials, StayPolynomial) {
  Random random(74);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const NurbsCurve curve = random_curve(random, kind);
    const double u = curve.domain().start + 0.37 * curve.domain().length();
    EXPECT_FALSE(insert_knot(curve, u).rational()) << text_of(kind);
    if (curve.periodic()) continue;
    EXPECT_FALSE(joined(curve, curve, Smoothness::c2).value.rational()) << text_of(kind);
  }
}

}  // namespace
}  // namespace splinecore
