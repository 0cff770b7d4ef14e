#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/patch/patch_set.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

std::vector<glm::dvec4> moved(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec4> found(points.begin(), points.end());
  for (glm::dvec4& p : found) p.x += 1.0;
  return found;
}

/// Not only equal: what was computed of the knots lies in the same place.
void expect_same_tables(const KnotVector& before, const KnotVector& after) {
  EXPECT_EQ(&after.tables(), &before.tables());
  EXPECT_EQ(after.knots().data(), before.knots().data());
  for (int span = 0; span < static_cast<int>(before.spans().size()); ++span) {
    EXPECT_EQ(after.bezier_matrix(span)[0].data(), before.bezier_matrix(span)[0].data()) << span;
  }
}

void expect_same_tables(const NurbsPatch& before, const NurbsPatch& after) {
  for (const Axis axis : {Axis::u, Axis::v}) expect_same_tables(before.knot_vector(axis), after.knot_vector(axis));
}

TEST(WithPoints, CurvesKeepTheTablesOfTheirKnots) {
  Random random(613);
  for (const Kind& kind : all_kinds(Weights::any)) {
    const NurbsCurve curve = random_curve(random, kind);
    expect_same_tables(curve.knot_vector(), curve.with_points(moved(curve.points())).knot_vector());
  }
  const BezierCurve bezier = BezierCurve::make(random_points(random, 5, Weights::positive));
  expect_same_tables(bezier.nurbs().knot_vector(), bezier.with_points(moved(bezier.points())).nurbs().knot_vector());
}

TEST(WithPoints, PatchesKeepTheTablesOfTheirKnots) {
  Random random(614);
  for (int round = 0; round < 50; ++round) {
    const NurbsPatch patch = random_patch(random);
    expect_same_tables(patch, patch.with_points(moved(patch.points())));
  }
  const BezierPatch bezier = BezierPatch::make(3, 4, random_points(random, 12, Weights::positive));
  expect_same_tables(bezier.nurbs(), bezier.with_points(moved(bezier.points())).nurbs());
}

HermiteNet random_net(Random& random) {
  HermiteNet net;
  for (auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    for (int i = 0; i < 6; ++i) list->push_back(random_vector(random));
  }
  return net;
}

TEST(WithPoints, SetsKeepTheTablesOfAllKnotsAndThePatchesOfWhichNoPointMoved) {
  Random random(615);
  const Kind ring{2, 3, Ends::periodic, Weights::positive};
  const std::vector<AnyPatch> patches{BezierPatch::make(3, 3, random_points(random, 9, Weights::positive)),
                                      HermitePatch::make(3, 2, random_net(random)), random_patch(random, ring, ring)};
  const PatchSet set = PatchSet::of(patches, false);
  for (std::size_t chosen = 0; chosen < patches.size(); ++chosen) {
    std::vector<glm::dvec4> points(set.points().begin(), set.points().end());
    points[set.patches()[chosen].indices.front()].x += 1.0;
    const PatchSet after = set.with_points(std::move(points));
    for (std::size_t i = 0; i < patches.size(); ++i) {
      EXPECT_EQ(&after.patch(i) == &set.patch(i), i != chosen);
      expect_same_tables(nurbs_of(set.patch(i)), nurbs_of(after.patch(i)));
    }
  }
}

}  // namespace
}  // namespace splinecore
