#include "splinecore/curve/degree.hpp"

#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/removal.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Largest distance of homogeneous points at parameters of the domain, relative to the size.
double farthest(const NurbsCurve& a, const NurbsCurve& b) {
  const Interval domain = a.domain();
  double far = 0.0;
  for (int i = 0; i <= 60; ++i) {
    const double u = i == 60 ? domain.end : domain.start + domain.length() * i / 60.0;
    const Side side = i == 60 ? Side::left : Side::right;
    far = worse(far, largest(homogeneous_at(a, u, side) - homogeneous_at(b, u, side)));
  }
  return far / size_of(a);
}

TEST(CurveElevation, KeepsEveryKindOfCurve) {
  Random random(21);
  for (const Kind& kind : all_kinds()) {
    const NurbsCurve curve = random_curve(random, kind);
    const NurbsCurve raised = elevated(curve, 2);
    EXPECT_EQ(raised.degree(), kind.degree + 2) << text_of(kind);
    EXPECT_EQ(raised.domain(), curve.domain()) << text_of(kind);
    EXPECT_EQ(raised.periodic(), curve.periodic());
    EXPECT_LT(farthest(curve, raised), 1e-14) << text_of(kind);
  }
}

TEST(CurveReduction, UndoesElevation) {
  Random random(22);
  for (const Kind& kind : all_kinds()) {
    const NurbsCurve curve = random_curve(random, kind);
    const NurbsCurve lower = reduced(elevated(curve)).value;
    EXPECT_EQ(lower.degree(), kind.degree) << text_of(kind);
    EXPECT_LT(farthest(curve, lower), 1e-12) << text_of(kind);
  }
}

TEST(CurveRemoval, UndoesInsertion) {
  Random random(23);
  for (const Kind& kind : all_kinds()) {
    const NurbsCurve curve = random_curve(random, kind);
    const Interval domain = curve.domain();
    const double u = domain.start + 0.37 * domain.length();
    const int times = 1 + kind.degree / 2;
    const NurbsCurve back = remove_knot(insert_knot(curve, u, times), u, times).value;
    EXPECT_EQ(back.knot_vector().count(), curve.knot_vector().count()) << text_of(kind);
    EXPECT_LT(farthest(curve, back), 1e-12) << text_of(kind);
  }
}

TEST(CurveEnds, AreClampedAndUnclampedWithoutAChange) {
  Random random(24);
  for (const Kind& kind : all_kinds()) {
    const NurbsCurve curve = random_curve(random, kind);
    EXPECT_LT(farthest(curve, clamped(curve)), 1e-13) << text_of(kind);
    EXPECT_LT(farthest(curve, unclamped(curve)), 1e-9) << text_of(kind);
  }
}

TEST(CurveEnds, OfAClosedCurveMeetAsSmoothlyAsTheyDid) {
  Random random(25);
  for (int degree = 1; degree <= 9; ++degree) {
    const KnotVector knots = KnotVector::periodic_uniform(degree, degree + 4);
    const NurbsCurve curve = NurbsCurve::make(knots, random_points(random, knots.count(), Weights::positive));
    const Approximation<NurbsCurve> closed = made_periodic(clamped(curve), 1e-9);
    EXPECT_EQ(closed.value.knot_vector().count(), curve.knot_vector().count()) << degree;
    EXPECT_LT(closed.error, 1e-9);
    EXPECT_LT(farthest(curve, closed.value), 1e-11) << degree;
  }
}

TEST(CurveDistance, IsKnownWithinOnePercent) {
  const NurbsCurve flat = NurbsCurve::make(KnotVector::bezier(2), {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}});
  const NurbsCurve high = NurbsCurve::make(KnotVector::bezier(2), {{0, 0, 0, 1}, {1, 1, 0, 1}, {2, 0, 0, 1}});
  EXPECT_GE(largest_distance(flat, high), 0.5);
  EXPECT_LE(largest_distance(flat, high), 0.505);
  EXPECT_EQ(largest_distance(flat, flat), 0.0);
}

}  // namespace
}  // namespace splinecore
