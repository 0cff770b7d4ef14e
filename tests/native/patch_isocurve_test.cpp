#include "splinecore/patch/isocurve.hpp"

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

NurbsPatch any_patch(Random& random) {
  const auto kind = [&] {
    return Kind{integer(random, 1, 9), integer(random, 1, 3), static_cast<Ends>(integer(random, 0, 2)),
                static_cast<Weights>(integer(random, 0, 2))};
  };
  const Kind u = kind();
  return random_patch(random, u, kind());
}

double inside(Random& random, Interval range) { return range.start + range.length() * real(random, 0.0, 1.0); }

TEST(PatchIsocurve, LiesOnAThousandPatches) {
  Random random(320);
  for (int round = 0; round < 1000; ++round) {
    const NurbsPatch patch = any_patch(random);
    const double u = inside(random, patch.knot_vector(Axis::u).domain());
    const double v = inside(random, patch.knot_vector(Axis::v).domain());
    const glm::dvec4 expected = homogeneous_at(patch, u, v);
    const NurbsCurve along_v = isocurve(patch, Axis::u, u);
    const NurbsCurve along_u = isocurve(patch, Axis::v, v);
    EXPECT_LE(largest(homogeneous_at(along_v, v) - expected), 1e-14 * size_of(patch)) << round;
    EXPECT_LE(largest(homogeneous_at(along_u, u) - expected), 1e-14 * size_of(patch)) << round;
    EXPECT_EQ(along_v.knot_vector(), patch.knot_vector(Axis::v));
    EXPECT_TRUE(patch.rational() || !along_u.rational());
    EXPECT_EQ(isocurve(swapped(patch), Axis::v, u), along_v);
  }
}

TEST(PatchIsocurve, IsTheSideOfThePartsThatASplitGives) {
  Random random(321);
  for (int round = 0; round < 300; ++round) {
    const Kind kind{integer(random, 1, 9), 3, Ends::unclamped, Weights::positive};
    const NurbsPatch patch = random_patch(random, kind, kind);
    const double at = inside(random, patch.knot_vector(Axis::v).domain());
    const auto [before, after] = split(patch, Axis::v, at);
    const NurbsCurve curve = isocurve(patch, Axis::v, at);
    for (const NurbsCurve& side : {boundary(before, Border::v_end), boundary(after, Border::v_start)}) {
      const double u = inside(random, curve.domain());
      EXPECT_LE(largest(homogeneous_at(side, u) - homogeneous_at(curve, u)), 1e-13 * size_of(patch)) << round;
    }
  }
}

TEST(PatchBoundary, OfAClampedPatchIsItsOuterRowsBitForBit) {
  Random random(322);
  const Kind kind{3, 3, Ends::clamped, Weights::any};
  for (int round = 0; round < 100; ++round) {
    const NurbsPatch patch = random_patch(random, kind, kind);
    const auto points = patch.points();
    const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
    EXPECT_TRUE(std::ranges::equal(boundary(patch, Border::u_start).points(), points.first(count_v)));
    EXPECT_TRUE(std::ranges::equal(boundary(patch, Border::u_end).points(), points.last(count_v)));
    for (int i = 0; i < patch.count(Axis::u); ++i) {
      EXPECT_EQ(boundary(patch, Border::v_start).points()[i], points[i * count_v]);
      EXPECT_EQ(boundary(patch, Border::v_end).points()[i], points[(i + 1) * count_v - 1]);
    }
  }
}

TEST(PatchBoundary, OfAPeriodicDirectionIsItsSeamTwice) {
  Random random(323);
  const NurbsPatch patch =
      random_patch(random, {3, 4, Ends::clamped, Weights::positive}, {2, 4, Ends::periodic, Weights::positive});
  const auto ring = NurbsPatch::make(patch.knot_vector(Axis::u), KnotVector::periodic_uniform(3, 5),
                                     random_points(random, patch.count(Axis::u) * 5, Weights::positive));
  const NurbsCurve start = boundary(ring, Border::v_start);
  const NurbsCurve end = boundary(ring, Border::v_end);
  for (const double u : random_parameters(random, start.domain(), 20)) {
    EXPECT_LE(largest(homogeneous_at(start, u) - homogeneous_at(end, u)), 1e-14 * size_of(ring));
  }
  EXPECT_TRUE(boundary(ring, Border::u_end).periodic());
}

TEST(PatchIsocurve, AtAGapIsOnTheSideThatIsAskedFor) {
  const KnotVector gap = KnotVector::make(1, {0, 0, 1, 1, 2, 2});
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 2; ++j) points.emplace_back(i, j, 0, 1);
  }
  const NurbsPatch patch = NurbsPatch::make(gap, KnotVector::bezier(1), points);
  EXPECT_EQ(isocurve(patch, Axis::u, 1.0).points()[0], glm::dvec4(2, 0, 0, 1));
  EXPECT_EQ(isocurve(patch, Axis::u, 1.0, Side::left).points()[0], glm::dvec4(1, 0, 0, 1));
  EXPECT_EQ(isocurve(patch, Axis::u, 2.0).points()[1], glm::dvec4(3, 1, 0, 1));
}

TEST(PatchIsocurve, OfABezierPatchIsABezierCurve) {
  const BezierPatch saddle = BezierPatch::make(2, 2, {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 1, 1}});
  const BezierCurve line = isocurve(saddle, Axis::u, 0.5);
  EXPECT_EQ(line, BezierCurve::make({{0.5, 0, 0, 1}, {0.5, 1, 0.5, 1}}));
  EXPECT_EQ(boundary(saddle, Border::v_end), BezierCurve::make({{0, 1, 0, 1}, {1, 1, 1, 1}}));
}

TEST(PatchIsocurve, RefusesParametersOutsideAndCurvesAtInfinity) {
  const KnotVector line = KnotVector::bezier(1);
  const NurbsPatch patch = NurbsPatch::make(line, line, {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 0}, {1, 1, 1, 0}});
  EXPECT_EQ(refusal([&] { isocurve(patch, Axis::v, 1.5); }), "u = 1.5 is outside the domain [0, 1]");
  EXPECT_EQ(refusal([&] { isocurve(patch, Axis::v, std::nan("")); }), "u = nan is outside the domain [0, 1]");
  EXPECT_EQ(refusal([&] { boundary(patch, Border::u_end); }), "weights are all zero: no point of the shape is finite");
}

}  // namespace
}  // namespace splinecore
