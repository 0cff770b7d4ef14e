#include "splinecore/curve/finite_arcs.hpp"

#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

NurbsCurve conic(double w1) {
  return NurbsCurve::make(KnotVector::bezier(2), {{-1, 0, 0, 1}, {0, 1, 0, w1}, {1, 0, 0, 1}});
}

/// How far outside the box of the curve's finite points a point lies, in its worst coordinate.
double outside(const NurbsCurve& curve, const glm::dvec3& p) {
  double distance = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec4& q : curve.points()) {
      if (q.w == 0.0) continue;
      low = std::min(low, q[axis]);
      high = std::max(high, q[axis]);
    }
    distance = worse(distance, worse(low - p[axis], p[axis] - high));
  }
  return distance;
}

/// What the header promises of every arc.
void expect_sound(const NurbsCurve& curve, const std::vector<NurbsCurve>& arcs, double length) {
  for (const NurbsCurve& arc : arcs) {
    EXPECT_FALSE(arc.periodic() && arcs.size() > 1);
    for (const glm::dvec4& p : arc.points()) {
      EXPECT_GT(p.w, 0.0);
      EXPECT_LE(outside(curve, glm::dvec3(p)), 2.0 * length * (1.0 + 1e-9));
    }
    for (int i = 0; i <= 16; ++i) {
      const double u = arc.domain().start + (arc.domain().length()) * i / 16;
      const Side side = i == 16 ? Side::left : Side::right;
      const glm::dvec3 point = point_at(arc, std::min(u, arc.domain().end), side);
      EXPECT_LE(outside(curve, point), length * (1.0 + 1e-9));
      const glm::dvec4 expected = homogeneous_at(curve, std::min(u, arc.domain().end), side);
      const double noise = 1e-13 * size_of(curve) * (1.0 + largest(point)) / std::abs(expected.w);
      EXPECT_LE(largest(point - glm::dvec3(expected) / expected.w), noise);
    }
  }
}

TEST(FiniteArcs, OfACurveWithPositiveWeightsAreTheCurveItself) {
  EXPECT_EQ(finite_arcs(conic(0.5), 1e-3), (std::vector<NurbsCurve>{conic(0.5)}));
  const NurbsCurve closed = NurbsCurve::make(KnotVector::periodic_uniform(3, 5),
                                             {{0, 0, 0, 1}, {1, 0, 0, 2}, {1, 1, 0, 1}, {0, 2, 0, 1}, {-1, 1, 0, 1}});
  EXPECT_EQ(finite_arcs(closed, 1.0), (std::vector<NurbsCurve>{closed}));
}

TEST(FiniteArcs, OfNegativeWeightsHavePositiveOnes) {
  const NurbsCurve curve = NurbsCurve::make(KnotVector::bezier(2), {{-1, 0, 0, -1}, {0, 1, 0, -2}, {1, 0, 0, -1}});
  EXPECT_EQ(finite_arcs(curve, 1.0), (std::vector<NurbsCurve>{conic(2)}));
}

TEST(FiniteArcs, AreCutAtGaps) {
  const NurbsCurve curve = NurbsCurve::make(1, {0, 0, 1, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {2, 1, 0, 1}});
  const auto arcs = finite_arcs(curve, 1.0);
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].domain(), (Interval{0, 1}));
  EXPECT_EQ(arcs[1].domain(), (Interval{1, 2}));
}

// One slider through all classes of row S10.
TEST(FiniteArcs, OfAConicAreOneTwoOrThree) {
  const double length = 50.0;
  for (int i = -300; i <= 300; ++i) {
    const double w1 = i / 100.0;
    const auto arcs = finite_arcs(conic(w1), length);
    // Close to -1 the far end of the ellipse and the second branch lie beyond the length.
    const std::size_t expected = w1 < -1.025 ? 3 : w1 < -0.985 ? 2 : 1;
    EXPECT_EQ(arcs.size(), expected) << w1;
    expect_sound(conic(w1), arcs, length);
  }
}

TEST(FiniteArcs, EndWhereTheCurveLeavesTheBox) {
  const auto arcs = finite_arcs(conic(-2), 10.0);
  ASSERT_EQ(arcs.size(), 3u);
  EXPECT_NEAR(outside(conic(-2), point_at(arcs[0], arcs[0].domain().end, Side::left)), 10.0, 2e-8);
  EXPECT_NEAR(outside(conic(-2), point_at(arcs[1], arcs[1].domain().start)), 10.0, 2e-8);
}

TEST(FiniteArcs, OfASemicircleAreOneArc) {
  const NurbsCurve curve = NurbsCurve::make(KnotVector::bezier(2), {{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  const auto arcs = finite_arcs(curve, 2.0);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].domain(), (Interval{0, 1}));
  expect_sound(curve, arcs, 2.0);
}

TEST(FiniteArcs, OfAPeriodicCurveRunAcrossTheSeam) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 6; ++i) points.emplace_back(std::cos(i), std::sin(i), 0, i == 3 ? -4.0 : 1.0);
  const NurbsCurve curve = NurbsCurve::make(KnotVector::periodic_uniform(3, 6), points);
  const auto arcs = finite_arcs(curve, 10.0);
  ASSERT_EQ(arcs.size(), 2u);
  for (const NurbsCurve& arc : arcs) {
    for (const glm::dvec4& p : arc.points()) EXPECT_GT(p.w, 0.0);
    const double u = arc.domain().middle();
    EXPECT_LE(largest(point_at(arc, u) - point_at(curve, u)), 1e-12 * (1 + largest(point_at(curve, u))));
  }
}

TEST(FiniteArcs, KeepTheirPromisesForThousandCurves) {
  Random random(520);
  for (int round = 0; round < 1000; ++round) {
    const Ends ends = integer(random, 0, 1) == 0 ? Ends::clamped : Ends::unclamped;
    const NurbsCurve curve = random_curve(random, {integer(random, 1, 9), integer(random, 1, 5), ends, Weights::any});
    const double length = std::exp2(real(random, -3, 10));
    expect_sound(curve, finite_arcs(curve, length), length);
  }
}

// What is left out lies farther out than the length.
TEST(FiniteArcs, LeaveOutNothingNear) {
  Random random(521);
  for (int round = 0; round < 300; ++round) {
    const NurbsCurve curve = random_curve(random, {integer(random, 1, 5), 3, Ends::clamped, Weights::any});
    const auto arcs = finite_arcs(curve, 20.0);
    for (const double u : random_parameters(random, curve.domain(), 50)) {
      const bool kept = std::ranges::any_of(arcs, [&](const NurbsCurve& arc) {
        return u >= arc.domain().start && u <= arc.domain().end;
      });
      const glm::dvec4 h = homogeneous_at(curve, u);
      if (std::abs(h.w) < 1e-9) continue;
      EXPECT_EQ(kept, outside(curve, glm::dvec3(h) / h.w) <= 20.0) << u;
    }
  }
}

TEST(FiniteArcs, OfACurveThatIsNowhereDefinedInOnePointComeToAnEnd) {
  // (2t - 1) times a line: all four coordinates are zero at t = 1/2.
  const NurbsCurve curve = NurbsCurve::from_homogeneous(
      KnotVector::bezier(2), std::vector<glm::dvec4>{{0, 0, 0, -1}, {-0.5, 0, 0, 0}, {1, 0, 0, 1}});
  for (const NurbsCurve& arc : finite_arcs(curve, 5.0)) {
    EXPECT_NEAR(point_at(arc, arc.domain().middle()).x, arc.domain().middle(), 1e-6);
  }
}

TEST(FiniteArcs, RefuseALengthThatIsNone) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(refusal([&] { finite_arcs(conic(1), bad); }).find("length = "), std::string::npos);
  }
}

}  // namespace
}  // namespace splinecore
