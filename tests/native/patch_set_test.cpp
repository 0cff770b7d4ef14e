#include "splinecore/patch/patch_set.hpp"

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

IndexedPatch bezier(int count_u, int count_v, std::vector<int> indices) {
  return {.kind = PatchKind::bezier,
          .count_u = count_u,
          .count_v = count_v,
          .indices = std::move(indices),
          .knots_u = {},
          .knots_v = {}};
}

/// Six points in two rows: two bilinear patches 0 1 / 2 3 and 2 3 / 4 5 share the middle row.
const std::vector<glm::dvec4> kPool{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}, {0, 2, 0, 1}, {1, 2, 0, 1}};

TEST(PatchSet, GivesPatchesThePointsTheirIndicesName) {
  const PatchSet set = PatchSet::make(kPool, {bezier(2, 2, {0, 1, 2, 3}), bezier(2, 2, {5, 4, 3, 2})});
  EXPECT_EQ(nurbs_of(set.patch(1)).points()[0], kPool[5]);
  EXPECT_EQ(point_at(nurbs_of(set.patch(1)), 0.5, 0.5), glm::dvec3(0.5, 1.5, 0));
}

TEST(PatchSetOf, KeepsEveryPatchAndMergesEqualPointsWhereAsked) {
  Random random(150);
  HermiteNet net;
  for (auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    for (int i = 0; i < 6; ++i) list->push_back(random_vector(random));
  }
  const Kind ring{2, 3, Ends::periodic, Weights::any};
  const std::vector<AnyPatch> patches{BezierPatch::make(2, 2, {kPool[0], kPool[1], kPool[2], kPool[3]}),
                                      BezierPatch::make(2, 2, {kPool[2], kPool[3], kPool[4], kPool[5]}),
                                      HermitePatch::make(3, 2, net), random_patch(random, ring, ring)};
  const PatchSet merged = PatchSet::of(patches, true);
  const PatchSet apart = PatchSet::of(patches, false);
  EXPECT_EQ(apart.points().size(), merged.points().size() + 2);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    EXPECT_EQ(merged.patch(i), patches[i]) << i;
    EXPECT_EQ(apart.patch(i), patches[i]) << i;
  }
}

TEST(PatchSetOf, MergesOnlyPointsEqualInEveryBit) {
  std::vector<AnyPatch> patches{BezierPatch::make(2, 2, {{0.0, 0, 0, 1}, {-0.0, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 2}})};
  EXPECT_EQ(PatchSet::of(patches, true).points().size(), 4u);
}

TEST(FlippedPatchSet, ShowsEverySurfaceFromTheOtherSide) {
  Random random(151);
  HermiteNet net;
  for (auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    for (int i = 0; i < 6; ++i) list->push_back(random_vector(random));
  }
  const std::vector<AnyPatch> patches{
      BezierPatch::make(3, 2, random_points(random, 6, Weights::any)), HermitePatch::make(3, 2, net, {0, 1, 3}),
      random_patch(random, {2, 3, Ends::periodic, Weights::any}, {3, 2, Ends::clamped, Weights::any})};
  const PatchSet set = PatchSet::of(patches, true);
  const PatchSet turned = flipped(set);
  EXPECT_EQ(flipped(turned), set);
  EXPECT_TRUE(std::ranges::equal(turned.points(), set.points()));
  EXPECT_EQ(std::get<BezierPatch>(turned.patch(0)), swapped(std::get<BezierPatch>(patches[0])));
  EXPECT_EQ(std::get<HermitePatch>(turned.patch(1)), swapped(std::get<HermitePatch>(patches[1])));
  EXPECT_EQ(std::get<NurbsPatch>(turned.patch(2)), swapped(std::get<NurbsPatch>(patches[2])));
}

TEST(PatchSetMake, NamesWhatIsWrongBeginningWithThePatch) {
  const auto refused = [](std::vector<glm::dvec4> pool, std::vector<IndexedPatch> patches) {
    return refusal([&] { PatchSet::make(pool, patches); });
  };
  const IndexedPatch good = bezier(2, 2, {0, 1, 2, 3});
  EXPECT_EQ(refused(kPool, {}), "patches is empty: a patch set needs one or more");
  EXPECT_EQ(refused(kPool, {good, bezier(2, 2, {0, 1, 6, 3})}),
            "patches[1]: indices[1, 0] = 6 is outside the pool of 6 points");
  EXPECT_EQ(refused(kPool, {bezier(2, 2, {0, 1, 2, -1})}),
            "patches[0]: indices[1, 1] = -1 is outside the pool of 6 points");
  EXPECT_EQ(refused(kPool, {bezier(2, 2, {0, 1, 2})}), "patches[0]: indices has 3 values for 4");
  EXPECT_EQ(refused(kPool, {bezier(1, 4, {0, 1, 2, 3})}), "patches[0]: indices is 1 x 4, a patch needs 2 x 2 or more");
  EXPECT_EQ(refused(kPool, {bezier(1 << 30, 1 << 30, {0, 1, 2, 3})}).substr(0, 38),
            "patches[0]: indices has 4 values for 1");
  std::vector<glm::dvec4> broken = kPool;
  broken[5].x = 0.0 / 0.0;
  EXPECT_NE(refused(broken, {good}).find("points[5].x"), std::string::npos);
}

TEST(PatchSetMake, RefusesAHermitePatchWhoseRowsHaveTheWrongWeight) {
  IndexedPatch patch = bezier(2, 2, {0, 1, 2, 3, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6});
  patch.kind = PatchKind::hermite;
  std::vector<glm::dvec4> pool = kPool;
  pool.emplace_back(1, 1, 0, 0);
  EXPECT_NO_THROW(PatchSet::make(pool, {patch}));
  pool[6].w = 1;
  EXPECT_EQ(refusal([&] { PatchSet::make(pool, {patch}); }),
            "patches[0]: points[6] has w = 1, a Hermite tangent or twist needs w = 0");
  pool[6].w = 0;
  pool[2].w = 2;
  EXPECT_EQ(refusal([&] { PatchSet::make(pool, {patch}); }),
            "patches[0]: points[2] has w = 2, a Hermite point needs w = 1");
}

TEST(PatchSetMake, RefusesWhatTheKindOfPatchHasNot) {
  const IndexedPatch good = bezier(2, 2, {0, 1, 2, 3});
  const auto refused = [&](auto change) {
    IndexedPatch patch = good;
    change(patch);
    return refusal([&] { PatchSet::make(kPool, {patch}); });
  };
  const std::string degrees = "patches[0]: degree and periodic belong to NURBS patches, not to one of another kind";
  EXPECT_EQ(refused([](IndexedPatch& patch) { patch.degree_v = 1; }), degrees);
  EXPECT_EQ(refused([](IndexedPatch& patch) { patch.periodic_u = true; }), degrees);
  EXPECT_EQ(refused([](IndexedPatch& patch) { patch.knots_u = {0, 1}; }),
            "patches[0]: knots belong to no Bezier patch");
}

TEST(PatchSetMake, FillsInTheParametersOfAHermitePatch) {
  IndexedPatch patch = bezier(2, 2, {0, 1, 2, 3, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6});
  patch.kind = PatchKind::hermite;
  std::vector<glm::dvec4> pool = kPool;
  pool.emplace_back(1, 1, 0, 0);
  const PatchSet without = PatchSet::make(pool, {patch});
  patch.knots_u = patch.knots_v = {0, 1};
  EXPECT_EQ(without, PatchSet::make(pool, {patch}));
  EXPECT_EQ(without.patches()[0].knots_u, patch.knots_u);
}

TEST(PatchSetMake, RefusesCountsThatAreNotThoseOfTheKnots) {
  IndexedPatch patch = bezier(3, 2, {0, 1, 2, 3, 4, 5});
  patch.kind = PatchKind::nurbs;
  patch.degree_u = patch.degree_v = 1;
  patch.knots_u = {0, 0, 1, 2, 2};
  patch.knots_v = {0, 0, 1, 1};
  EXPECT_NO_THROW(PatchSet::make(kPool, {patch}));
  std::swap(patch.knots_u, patch.knots_v);
  EXPECT_EQ(refusal([&] { PatchSet::make(kPool, {patch}); }),
            "patches[0]: count is 3 x 2, but the knots belong to 2 x 3");
}

}  // namespace
}  // namespace splinecore
