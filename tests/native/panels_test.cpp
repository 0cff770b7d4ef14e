#include "splinecore/patch/panels.hpp"

#include "splinecore/patch/degree.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Six points in two rows: two bilinear patches 0 1 / 2 3 and 2 3 / 4 5 share the middle row.
const std::vector<glm::dvec4> kPool{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}, {0, 2, 0, 1}, {1, 2, 0, 1}};

BezierPatch quad(const std::array<int, 4>& rows) {
  std::vector<glm::dvec4> points;
  for (const int row : rows) points.push_back(kPool[row]);
  return BezierPatch::make(2, 2, points);
}

std::vector<Panel> panels_of(const std::vector<AnyPatch>& patches) {
  return splinecore::panels_of(PatchSet::of(patches, true));
}

int shared_count(const std::vector<Panel>& panels) {
  return static_cast<int>(std::ranges::count_if(side_counts(panels), [](int count) { return count > 1; }));
}

TEST(Panels, AreOneEdgeInWhateverDirectionItsSidesRun) {
  const std::pair<std::array<int, 4>, std::pair<int, bool>> ways[] = {
      {{2, 3, 4, 5}, {0, false}}, {{3, 2, 5, 4}, {0, true}}, {{4, 5, 2, 3}, {1, false}}, {{5, 4, 3, 2}, {1, true}},
      {{2, 4, 3, 5}, {2, false}}, {{3, 5, 2, 4}, {2, true}}, {{4, 2, 5, 3}, {3, false}}, {{5, 3, 4, 2}, {3, true}}};
  for (const auto& [indices, way] : ways) {
    const auto panels = panels_of({quad({0, 1, 2, 3}), quad(indices)});
    EXPECT_EQ(panels[1].sides[way.first].edge, panels[0].sides[1].edge);
    EXPECT_EQ(panels[1].sides[way.first].reversed != panels[0].sides[1].reversed, way.second);
    EXPECT_EQ(shared_count(panels), 1);
    EXPECT_EQ(side_counts(panels).size(), 7u);
  }
}

TEST(Panels, HaveSidesThatArePoints) {
  const KnotVector ring = KnotVector::periodic_uniform(1, 3);
  Random random(152);
  std::vector<glm::dvec4> points = random_points(random, 9, Weights::one);
  points[1] = points[2] = points[0];
  const auto panels = panels_of({NurbsPatch::make(KnotVector::clamped(1, 3), ring, points)});
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels[0].sides[0].edge, -1);
  EXPECT_GE(panels[0].sides[1].edge, 0);
  EXPECT_EQ(panels[0].sides[2].edge, panels[0].sides[3].edge);
  EXPECT_EQ(panels[0].sides[2].reversed, panels[0].sides[3].reversed);
}

TEST(Panels, OfAnUnclampedPatchHaveSidesThatAreCurves) {
  Random random(154);
  const auto panels = panels_of(
      {NurbsPatch::make(KnotVector::uniform(2, 3), KnotVector::clamped(2, 3), random_points(random, 9, Weights::one))});
  EXPECT_EQ(side_counts(panels), std::vector<int>(4, 1));
}

TEST(Panels, ShareAnEdgeOnKnotsThatAreEqualAfterScalingAndMirroring) {
  Random random(153);
  const std::vector<glm::dvec4> edge = random_points(random, 3, Weights::one);
  for (const double knot : {0.5, 1.0 / 3, 1.0 / 8192, 3.0 / 8192}) {
    std::vector<glm::dvec4> first{edge[0], edge[1], edge[2]}, second{edge[2], edge[1], edge[0]};
    for (auto* net : {&first, &second}) {
      for (const glm::dvec4& p : random_points(random, 3, Weights::one)) net->push_back(p);
    }
    const KnotVector knots = KnotVector::make(1, {0, 0, knot, 1, 1});
    const KnotVector mirrored = KnotVector::make(1, {3, 3, 3 + 2 * (1 - knot), 5, 5});
    const auto panels = panels_of({NurbsPatch::make(KnotVector::bezier(1), knots, first),
                                   NurbsPatch::make(KnotVector::bezier(1), mirrored, second)});
    EXPECT_EQ(panels[0].sides[0].edge, panels[1].sides[0].edge) << knot;
    EXPECT_NE(panels[0].sides[0].reversed, panels[1].sides[0].reversed) << knot;
  }
}

TEST(Panels, ShareAnEdgeWhateverTheDegreesAndWeightsOfTheSidesAre) {
  Random random(155);
  for (int times = 1; times <= 4; ++times) {
    const Kind along{3, 6, Ends::clamped, Weights::positive};
    const NurbsPatch first = random_patch(random, {2, 4, Ends::clamped, Weights::positive}, along);
    const NurbsPatch raised = elevated(first, Axis::v, times);
    const auto panels = panels_of({first, raised});
    const std::size_t half = panels.size() / 2;  // gaps among the knots make several of each patch
    for (std::size_t i = 0; i < half; ++i) {
      EXPECT_EQ(panels[half + i].patch, 1u);
      for (int side = 0; side < 4; ++side) EXPECT_EQ(panels[i].sides[side], panels[half + i].sides[side]) << side;
    }
    EXPECT_EQ(shared_count(panels), static_cast<int>(4 * half));
  }
}

TEST(Panels, ShareNoEdgeWhereTheCurvesDifferByMoreThanRounding) {
  BezierPatch other = quad({2, 3, 4, 5});
  for (const double distance : {1e-12, 1e-6}) {
    std::vector<glm::dvec4> points(other.points().begin(), other.points().end());
    points[0].z += distance;
    EXPECT_EQ(shared_count(panels_of({quad({0, 1, 2, 3}), BezierPatch::make(2, 2, points)})), distance < 1e-9 ? 1 : 0);
  }
}

TEST(Panels, EndAtAGapInsideAPatch) {
  Random random(156);
  const auto panels = panels_of({NurbsPatch::make(KnotVector::make(1, {0, 0, 0.25, 0.25, 1, 1}), KnotVector::bezier(2),
                                                  random_points(random, 12, Weights::one))});
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_EQ(panels[0].u, (Interval{0, 0.25}));
  EXPECT_EQ(panels[1].u, (Interval{0.25, 1}));
  EXPECT_EQ(shared_count(panels), 0);
}

}  // namespace
}  // namespace splinecore
