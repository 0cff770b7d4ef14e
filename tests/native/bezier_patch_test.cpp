#include "splinecore/patch/bezier_patch.hpp"

#include "reference.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

BezierPatch random_bezier(Random& random, int count_u, int count_v, Weights weights) {
  return BezierPatch::make(count_u, count_v, random_points(random, count_u * count_v, weights));
}

/// De Casteljau in one direction, then in the other.
glm::dvec4 by_de_casteljau(const BezierPatch& patch, double u, double v) {
  const int width = patch.count(Axis::v);
  std::vector<Point> column;
  for (int i = 0; i < patch.count(Axis::u); ++i) {
    column.push_back(de_casteljau(long_homogeneous(patch.points().subspan(i * width, width)), v).left.back());
  }
  return glm::dvec4(de_casteljau(column, u).left.back());
}

TEST(BezierPatch, OfAnyBidegreeAgreesWithDeCasteljauInLongDouble) {
  Random random(130);
  for (const int count_u : {2, 3, 4, 7, 10, 31}) {
    for (const int count_v : {2, 4, 5, 61}) {
      for (const Weights weights : {Weights::one, Weights::positive, Weights::any}) {
        const BezierPatch patch = random_bezier(random, count_u, count_v, weights);
        for (const auto& [u, v] : {std::pair{0.0, 0.0}, {0.3, 0.8}, {0.99, 0.01}, {1.0, 0.5}}) {
          const double error = largest(homogeneous_at(patch.nurbs(), u, v) - by_de_casteljau(patch, u, v));
          EXPECT_LE(error, 1e-13 * size_of(patch.nurbs())) << count_u << " " << count_v;
        }
      }
    }
  }
}

TEST(BezierPatch, PassesThroughItsCornersBitForBit) {
  Random random(131);
  const BezierPatch patch = random_bezier(random, 4, 3, Weights::one);
  EXPECT_EQ(point_at(patch.nurbs(), 0, 0), glm::dvec3(patch.points()[0]));
  EXPECT_EQ(point_at(patch.nurbs(), 0, 1), glm::dvec3(patch.points()[2]));
  EXPECT_EQ(point_at(patch.nurbs(), 1, 0), glm::dvec3(patch.points()[9]));
  EXPECT_EQ(point_at(patch.nurbs(), 1, 1), glm::dvec3(patch.points()[11]));
}

TEST(BezierPatchSplit, GivesBothPartsOverTheUnitSquare) {
  Random random(132);
  for (int round = 0; round < 200; ++round) {
    const BezierPatch patch = random_bezier(random, integer(random, 2, 6), integer(random, 2, 6), Weights::any);
    const double cut = real(random, 0.05, 0.95);
    const double s = real(random, 0, 1), t = real(random, 0, 1);
    const double tolerance = 1e-12 * size_of(patch.nurbs());
    const auto [low, high] = split(patch, Axis::u, cut);
    EXPECT_LE(largest(homogeneous_at(low.nurbs(), s, t) - homogeneous_at(patch.nurbs(), s * cut, t)), tolerance);
    EXPECT_LE(largest(homogeneous_at(high.nurbs(), s, t) - homogeneous_at(patch.nurbs(), cut + s * (1 - cut), t)),
              tolerance);
    const auto [left, right] = split(patch, Axis::v, cut);
    EXPECT_LE(largest(homogeneous_at(left.nurbs(), s, t) - homogeneous_at(patch.nurbs(), s, t * cut)), tolerance);
    EXPECT_LE(largest(homogeneous_at(right.nurbs(), s, t) - homogeneous_at(patch.nurbs(), s, cut + t * (1 - cut))),
              tolerance);
  }
}

TEST(BezierPatch, ReversedAndSwappedTwiceIsItselfBitForBit) {
  Random random(133);
  const BezierPatch patch = random_bezier(random, 4, 3, Weights::any);
  EXPECT_EQ(reversed(reversed(patch, Axis::u), Axis::u), patch);
  EXPECT_EQ(reversed(reversed(patch, Axis::v), Axis::v), patch);
  EXPECT_EQ(swapped(swapped(patch)), patch);
  EXPECT_EQ(swapped(reversed(patch, Axis::u)), reversed(swapped(patch), Axis::v));
  EXPECT_EQ(reversed(patch, Axis::u).points()[0], patch.points()[9]);
  EXPECT_EQ(swapped(patch).points()[1], patch.points()[3]);
}

TEST(BezierPatchMake, NamesWhatIsWrong) {
  const auto refused = [](int count_u, int count_v, std::size_t size) {
    return refusal([&] { BezierPatch::make(count_u, count_v, std::vector<glm::dvec4>(size, glm::dvec4(1))); });
  };
  EXPECT_EQ(refused(1, 4, 4), "points has 1 in u, a Bezier patch needs from 2 to 256");
  EXPECT_EQ(refused(2, 257, 514), "points has 257 in v, a Bezier patch needs from 2 to 256");
  EXPECT_EQ(refused(-2, -2, 4), "points has -2 in u, a Bezier patch needs from 2 to 256");
  EXPECT_EQ(refused(2, 2, 5), "points has 5 entries, but the knots belong to 2 x 2");
  EXPECT_EQ(refusal([] { BezierPatch::make(2, 2, std::vector<glm::dvec4>(4, glm::dvec4(1, 1, 1, 0))); }),
            "weights are all zero: no point of the shape is finite");
}

}  // namespace
}  // namespace splinecore
