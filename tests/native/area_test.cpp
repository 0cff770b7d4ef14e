#include "splinecore/measure/area.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "splinecore/build/primitives.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;
constexpr double kExact = 1e-13;
const glm::dvec3 kCenter(10.0, -20.0, 5.0);
const glm::dvec3 kUp(0.0, 0.0, 1.0);

PatchSet set_of(std::vector<AnyPatch> patches) { return PatchSet::of(patches, true); }

PatchSet capped(const NurbsPatch& mantle, double radius, double height) {
  const NurbsPatch top = disc(kCenter + height * kUp, kUp, radius);
  return set_of({mantle, reversed(disc(kCenter, kUp, 2.0), Axis::v), top});
}

}  // namespace

TEST(Area, OfTheUsualBodiesIsTheirClosedForm) {
  EXPECT_NEAR(area(sphere(kCenter, 2.5, {1, 2, 2})).value / (4.0 * kPi * 6.25), 1.0, kExact);
  EXPECT_NEAR(area(cylinder(kCenter, {1, 2, 2}, 2.0, 5.0)).value / (20.0 * kPi), 1.0, kExact);
  EXPECT_NEAR(area(cone(kCenter, {1, 2, 2}, 3.0, 4.0)).value / (15.0 * kPi), 1.0, kExact);
  EXPECT_NEAR(area(cone(kCenter, {1, 2, 2}, 5.0, 4.0, 2.0)).value / (35.0 * kPi), 1.0, kExact);
  EXPECT_NEAR(area(torus(kCenter, {1, 2, 2}, 3.0, 1.0)).value / (12.0 * kPi * kPi), 1.0, kExact);
  EXPECT_NEAR(area(disc(kCenter, {1, 2, 2}, 3.0)).value / (9.0 * kPi), 1.0, kExact);
  EXPECT_NEAR(area(sphere(kCenter, 2.5, kUp, {0.1, 0.4})).value / (0.4 * 2.0 * 6.25), 1.0, kExact);
  EXPECT_NEAR(area(plane({0, 0, 0}, {2, 0, 0}, {1, 3, 0})).value, 6.0, 1e-14);
}

TEST(Area, SaysHowFarItIsOffAtMost) {
  const auto [value, error] = area(sphere(kCenter, 2.5));
  EXPECT_LE(std::abs(value - 25.0 * kPi), error);
  EXPECT_LE(error, 1.1e-12 * value);
}

TEST(Area, OfASetIsTheSumOfItsPatches) {
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Kind kind{integer(random, 1, 3), 2, Ends::clamped, Weights::positive};
    const NurbsPatch patch = random_patch(random, kind, kind);
    std::vector<AnyPatch> pieces;
    double sum = 0.0;
    for (const BezierPatch& piece : to_bezier(patch).patches) {
      pieces.emplace_back(piece);
      sum += area(piece.nurbs(), 1e-8).value;
    }
    EXPECT_NEAR(area(set_of(pieces), 1e-8).value / sum, 1.0, 2e-8);
    EXPECT_NEAR(area(patch, 1e-8).value / sum, 1.0, 2e-8);
  }
}

TEST(Area, KeepsItsRangeOfSizes) {
  for (const double radius : {1e-150, 1e150}) {
    EXPECT_NEAR(area(sphere({0, 0, 0}, radius)).value / radius / radius, 4.0 * kPi, 1e-13);
  }
  EXPECT_EQ(refusal([] { area(sphere({0, 0, 0}, 1e160)); }), "the area is too large for a number");
}

TEST(Area, OfAPatchThatFoldsBackTakesBothSheets) {
  // x = u² - u over [0, 1] goes to -1/4 and back.
  const NurbsPatch patch = NurbsPatch::make(
      KnotVector::bezier(2), KnotVector::bezier(1),
      {{0, 0, 0, 1}, {0, 1, 0, 1}, {-0.5, 0, 0, 1}, {-0.5, 1, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}});
  EXPECT_NEAR(area(patch).value, 0.5, 1e-14);
}

TEST(Area, RefusesInfinity) {
  const std::vector<glm::dvec4> points{{1, 0, 0, 1},    {1, 0, 1, 1},  {0, 1, 0, -1.5},
                                       {0, 1, 1, -1.5}, {-1, 0, 0, 1}, {-1, 0, 1, 1}};
  const NurbsPatch patch = NurbsPatch::make(KnotVector::bezier(2), KnotVector::bezier(1), points);
  EXPECT_THROW(area(patch), PointAtInfinity);
  EXPECT_THROW(volume(set_of({patch, swapped(patch)})), PointAtInfinity);
  // A weight of 0 at a point inside the net, and a negative one, are no infinity.
  std::vector<glm::dvec4> half = points;
  half[2].w = half[3].w = 0.0;
  half[3].z = 0.0;
  EXPECT_NEAR(area(patch.with_points(half)).value, kPi, 1e-13);
  half[2].w = half[3].w = -0.5;
  half[3].z = 1.0;
  EXPECT_GT(area(patch.with_points(half)).value, kPi);
}

TEST(Volume, OfTheUsualBodiesIsTheirClosedForm) {
  EXPECT_NEAR(volume(set_of({sphere(kCenter, 2.5, {1, 2, 2})})).value / (4.0 / 3.0 * kPi * 15.625), 1.0, kExact);
  EXPECT_NEAR(volume(set_of({torus(kCenter, {1, 2, 2}, 3.0, 1.0)})).value / (6.0 * kPi * kPi), 1.0, kExact);
  EXPECT_NEAR(volume(capped(cylinder(kCenter, kUp, 2.0, 5.0), 2.0, 5.0)).value / (20.0 * kPi), 1.0, kExact);
  EXPECT_NEAR(volume(capped(cone(kCenter, kUp, 2.0, 3.0, 1.0), 1.0, 3.0)).value / (7.0 * kPi), 1.0, kExact);
  const PatchSet pointed = set_of({cone(kCenter, kUp, 2.0, 3.0), reversed(disc(kCenter, kUp, 2.0), Axis::v)});
  EXPECT_NEAR(volume(pointed).value / (4.0 * kPi), 1.0, kExact);
  EXPECT_NEAR(volume(flipped(pointed)).value / (-4.0 * kPi), 1.0, kExact);
}

TEST(Volume, OfABoxOfSixPlanes) {
  const glm::dvec3 a(2, 0, 0);
  const glm::dvec3 b(0, 3, 0);
  const glm::dvec3 c(0, 0, 4);
  const PatchSet box = set_of({plane({0, 0, 0}, b, a), plane(c, a, b), plane({0, 0, 0}, a, c), plane(b, c, a),
                               plane({0, 0, 0}, c, b), plane(a, b, c)});
  EXPECT_NEAR(volume(box).value, 24.0, 1e-13);
}

TEST(Volume, OfAHollowBodyIsTheDifference) {
  const NurbsPatch inner = reversed(sphere(kCenter, 1.0), Axis::v);
  EXPECT_NEAR(volume(set_of({sphere(kCenter, 2.0), inner})).value, 4.0 / 3.0 * kPi * 7.0, 1e-12);
}

TEST(Volume, RefusesSetsThatAreNotClosedOrTurnedAgainstEachOther) {
  const NurbsPatch mantle = cylinder(kCenter, kUp, 2.0, 5.0);
  EXPECT_EQ(refusal([&] { volume(set_of({mantle})); }),
            "the side v = start of patches[0] meets no other: the patches enclose no volume");
  const PatchSet turned = set_of({mantle, disc(kCenter, kUp, 2.0), disc(kCenter + 5.0 * kUp, kUp, 2.0)});
  EXPECT_EQ(refusal([&] { volume(turned); }),
            "normals point to the other side beyond the side v = start of patches[0]: flip one of both patches, or orient all of them");
}

}  // namespace splinecore
