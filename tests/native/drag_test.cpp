#include "splinecore/build/drag.hpp"

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

const glm::dvec3 kBy{0.5, -2.0, 1.25};

std::vector<glm::dvec3> with_tangent(const NurbsCurve& curve, double u) {
  std::vector<glm::dvec3> found(2);
  derivatives(curve, {&u, 1}, 1, {&found[0].x, 6}, {});
  return found;
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance);
}

/// (p0 + p1) / 2 moves by d where both move by d: the least change.
TEST(Drag, OfALineInItsMiddleMovesBothEndsAlike) {
  const BezierCurve line = BezierCurve::make({{0, 0, 0, 1}, {2, 0, 0, 1}});
  const BezierCurve moved = dragged(line, 0.5, {kBy, {}});
  for (int i = 0; i < 2; ++i) expect_near(glm::dvec3(moved.points()[i] - line.points()[i]), kBy, 1e-15);
}

/// At 1/4 of a parabola the rows are 9, 6, 1 sixteenths, of squares 118/256.
TEST(Drag, OfAParabolaMovesPointsByWhatTheyCount) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}});
  const BezierCurve moved = dragged(curve, 0.25, {kBy, {}});
  const std::vector<double> counts{9.0, 6.0, 1.0};
  for (int i = 0; i < 3; ++i) {
    expect_near(glm::dvec3(moved.points()[i] - curve.points()[i]), counts[i] * 16.0 / 118.0 * kBy, 1e-15);
  }
}

TEST(Drag, ArrivesOnCurvesOfEveryKind) {
  Random random(1);
  for (const Kind& kind : all_kinds(Weights::positive)) {
    SCOPED_TRACE(text_of(kind));
    const NurbsCurve curve = random_curve(random, kind);
    const Interval domain = curve.domain();
    const double u = domain.start + 0.37 * domain.length();
    const NurbsCurve moved = dragged(curve, u, {kBy, {}}, {{}, 1.0});
    expect_near(point_at(moved, u) - point_at(curve, u), kBy, 1e-11);
    if (curve.points().size() < 4) continue;
    const auto before = with_tangent(curve, u);
    const auto after = with_tangent(dragged(curve, u, {kBy, glm::dvec3(0.0)}), u);
    expect_near(after[0] - before[0], kBy, 1e-11);
    expect_near((after[1] - before[1]) * domain.length(), glm::dvec3(0.0), 1e-8);
  }
}

TEST(Drag, LeavesPointsAtInfinityAndThoseOfFactorZero) {
  const BezierCurve curve = BezierCurve::make({{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  const BezierCurve moved = dragged(curve, 0.5, {kBy, {}}, {{1.0, 1.0, 0.0}, 0.0});
  EXPECT_EQ(moved.points()[1], curve.points()[1]);
  EXPECT_EQ(moved.points()[2], curve.points()[2]);
  expect_near(glm::dvec3(moved.points()[0] - curve.points()[0]), 2.0 * kBy, 1e-15);
}

TEST(Drag, KeepsAClosedChainClosedAndSmooth) {
  const Tangents smooth{{0, 1, 0}, {0, 1, 0}};
  const HermiteCurve chain = HermiteCurve::make({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {0, 0, 0}},
                                                {smooth, {{1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 1, 0}}, smooth});
  const HermiteCurve moved = dragged(chain, 0.25, {kBy, {}});
  EXPECT_EQ(moved.points().front(), moved.points().back());
  EXPECT_NE(moved.points().front(), chain.points().front());
  EXPECT_EQ(moved.tangents().front(), moved.tangents().back());
  EXPECT_EQ(moved.tangents()[1].incoming, moved.tangents()[1].outgoing);
  expect_near(point_at(moved.nurbs(), 0.25) - point_at(chain.nurbs(), 0.25), kBy, 1e-14);
}

BezierPatch sheet(double from) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) points.emplace_back(from + i, j, i * j, 1.0);
  }
  return BezierPatch::make(3, 3, std::move(points));
}

TEST(Drag, MovesWhatPatchesShareOnce) {
  // The sheets meet where x = 2, but for z.
  const BezierPatch neighbor = sheet(2.0);
  std::vector<glm::dvec4> right(neighbor.points().begin(), neighbor.points().end());
  const BezierPatch first = sheet(0.0);
  for (int j = 0; j < 3; ++j) right[j] = first.points()[6 + j];
  const std::vector<AnyPatch> both{first, BezierPatch::make(3, 3, right)};
  for (const bool merged : {true, false}) {
    const PatchSet set = PatchSet::of(both, merged);
    const PatchSet moved = dragged(set, 1, 0.1, 0.5, {kBy});
    const auto left_points = nurbs_of(moved.patch(0)).points();
    const auto right_points = nurbs_of(moved.patch(1)).points();
    for (int j = 0; j < 3; ++j) EXPECT_EQ(left_points[6 + j], right_points[j]);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(left_points[i], first.points()[i]);
    EXPECT_EQ(dragged(BezierPatch::make(3, 3, right), 0.1, 0.5, {kBy}), std::get<BezierPatch>(moved.patch(1)));
  }
}

TEST(Drag, RefusesInWords) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}});
  const auto message = [&](double u, const Drag& drag, const Following& following) -> std::string {
    try {
      dragged(curve, u, drag, following);
    } catch (const InvalidShape& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(0.5, {kBy, {}}, {{0, 0, 0}, 0.0}),
            "no control point that the point at u = 0.5 depends on may move");
  EXPECT_EQ(message(0.5, {kBy, {}}, {{1, 1}, 0.0}), "factors has 2 values for 3 points");
  EXPECT_EQ(message(0.5, {kBy, glm::dvec3(0)}, {{0, 1, 0}, 0.0}),
            "the tangent at u = 0.5 cannot be chosen beside the point: too few control points may move");
  EXPECT_EQ(message(0.5, {kBy, {}}, {{}, -1.0}), "locality = -1 is not a number of 0 or more");
  EXPECT_NE(message(1.5, {kBy, {}}, {}).find("u = 1.5"), std::string::npos);
  EXPECT_THROW(dragged(BezierCurve::make({{0, 0, 0, 1}, {1, 2, 0, -1}, {2, 0, 0, 1}}), 0.5, {kBy, {}}), PointAtInfinity);
}

}  // namespace
}  // namespace splinecore
