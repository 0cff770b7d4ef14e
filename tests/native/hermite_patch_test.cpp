#include "splinecore/patch/hermite_patch.hpp"

#include <array>
#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

HermiteNet random_net(Random& random, int size) {
  HermiteNet net;
  for (auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    for (int i = 0; i < size; ++i) list->push_back(random_vector(random));
  }
  return net;
}

std::vector<double> increasing(Random& random, int count) {
  std::vector<double> parameters{real(random, -2, 2)};
  while (static_cast<int>(parameters.size()) < count) parameters.push_back(parameters.back() + real(random, 0.1, 2));
  return parameters;
}

HermitePatch random_hermite(Random& random) {
  const int count_u = integer(random, 2, 4);
  const int count_v = integer(random, 2, 4);
  return HermitePatch::make(count_u, count_v, random_net(random, count_u * count_v), increasing(random, count_u),
                            increasing(random, count_v));
}

/// H0, H1 of the two ends and H2, H3 of their derivatives (lecture row S4).
std::array<double, 4> hermite(double t) {
  return {2 * t * t * t - 3 * t * t + 1, -2 * t * t * t + 3 * t * t, t * t * t - 2 * t * t + t, t * t * t - t * t};
}

std::array<glm::dvec3, 4> corner_of(const NurbsPatch& patch, double u, double v) {
  std::array<glm::dvec3, 4> values;
  derivatives(patch, {&u, 1}, {&v, 1}, 1, {&values[0].x, 12});
  return values;
}

TEST(HermitePatch, IsTheTensorSumOfHermitesPolynomials) {
  Random random(140);
  const HermiteNet net = random_net(random, 4);
  const HermitePatch patch = HermitePatch::make(2, 2, net);
  for (int round = 0; round < 50; ++round) {
    const double u = real(random, 0, 1), v = real(random, 0, 1);
    const auto hu = hermite(u), hv = hermite(v);
    glm::dvec3 expected(0.0);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        const int k = 2 * i + j;
        expected += hu[i] * hv[j] * net.points[k] + hu[2 + i] * hv[j] * net.tangents_u[k] +
                    hu[i] * hv[2 + j] * net.tangents_v[k] + hu[2 + i] * hv[2 + j] * net.twists[k];
      }
    }
    EXPECT_LE(largest(point_at(patch.nurbs(), u, v) - expected), 1e-13);
  }
}

TEST(HermitePatch, HasItsPointsTangentsAndTwistsAtEveryCorner) {
  Random random(141);
  for (int round = 0; round < 50; ++round) {
    const HermitePatch patch = random_hermite(random);
    for (int i = 0; i < patch.count(Axis::u); ++i) {
      for (int j = 0; j < patch.count(Axis::v); ++j) {
        const int k = i * patch.count(Axis::v) + j;
        const auto corner = corner_of(patch.nurbs(), patch.parameters(Axis::u)[i], patch.parameters(Axis::v)[j]);
        EXPECT_EQ(corner[0], patch.net().points[k]);
        EXPECT_LE(largest(corner[1] - patch.net().tangents_v[k]), 1e-11);
        EXPECT_LE(largest(corner[2] - patch.net().tangents_u[k]), 1e-11);
        EXPECT_LE(largest(corner[3] - patch.net().twists[k]), 1e-9);
      }
    }
  }
}

TEST(HermitePatch, WithoutTwistsIsFergusons) {
  Random random(142);
  HermiteNet net = random_net(random, 6);
  net.twists.clear();
  const HermitePatch ferguson = HermitePatch::make(2, 3, net);
  net.twists.assign(6, glm::dvec3(0.0));
  EXPECT_EQ(ferguson, HermitePatch::make(2, 3, net, {0, 1}, {0, 1, 2}));
}

TEST(HermitePatch, KeepsItsShapeWhenSplitReversedOrSwapped) {
  Random random(143);
  for (int round = 0; round < 300; ++round) {
    const HermitePatch patch = random_hermite(random);
    const double tolerance = 1e-12 * size_of(patch.nurbs());
    const Interval range_u = patch.nurbs().knot_vector(Axis::u).domain();
    const Interval range_v = patch.nurbs().knot_vector(Axis::v).domain();
    const double u = real(random, range_u.start, range_u.end), v = real(random, range_v.start, range_v.end);
    const glm::dvec3 expected = point_at(patch.nurbs(), u, v);
    EXPECT_LE(largest(point_at(swapped(patch).nurbs(), v, u) - expected), tolerance);
    EXPECT_LE(largest(point_at(reversed(patch, Axis::u).nurbs(), range_u.start + (range_u.end - u), v) - expected),
              tolerance);
    EXPECT_LE(largest(point_at(reversed(patch, Axis::v).nurbs(), u, range_v.start + (range_v.end - v)) - expected),
              tolerance);
    for (const Axis axis : {Axis::u, Axis::v}) {
      const Interval range = axis == Axis::u ? range_u : range_v;
      const bool at_corner = patch.count(axis) > 2 && integer(random, 0, 1) == 0;
      const double cut =
          at_corner ? patch.parameters(axis)[1] : range.start + range.length() * real(random, 0.05, 0.95);
      const auto [before, after] = split(patch, axis, cut);
      const HermitePatch& part = (axis == Axis::u ? u : v) < cut ? before : after;
      EXPECT_LE(largest(point_at(part.nurbs(), u, v) - expected), tolerance);
    }
  }
}

TEST(HermitePatchMake, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Random random(144);
  const HermiteNet good = random_net(random, 6);
  const auto refused = [](int count_u, int count_v, const HermiteNet& net, std::vector<double> u = {},
                          std::vector<double> v = {}) {
    return refusal([&] { HermitePatch::make(count_u, count_v, net, u, v); });
  };
  const auto changed = [&](auto change) {
    HermiteNet net = good;
    change(net);
    return net;
  };
  EXPECT_EQ(refused(1, 6, good), "points is 1 x 6, a Hermite patch needs 2 x 2 or more");
  EXPECT_EQ(refused(2, -3, good), "points is 2 x -3, a Hermite patch needs 2 x 2 or more");
  EXPECT_EQ(refused(2, 2, good), "points has 6 entries for 2 x 2 corners");
  EXPECT_EQ(refused(2, 3, changed([](HermiteNet& net) { net.tangents_v.pop_back(); })),
            "tangents_v has 5 entries for 2 x 3 corners");
  EXPECT_EQ(refused(2, 3, changed([&](HermiteNet& net) { net.twists[4].z = nan; })),
            "twists[1, 1].z = nan is not finite");
  EXPECT_EQ(refused(2, 3, good, {0, 1}, {0, 1, 1}), "parameters_v[2] = 1 does not increase from 1");
  EXPECT_EQ(refused(2, 3, good, {0, 1, 2}), "parameters_u has 3 values for 2 points");
  const HermitePatch patch = HermitePatch::make(2, 3, good);
  EXPECT_EQ(refusal([&] { split(patch, Axis::v, 2); }), "u = 2 is not inside the domain (0, 2)");
  EXPECT_EQ(refusal([&] { split(patch, Axis::u, nan); }), "u = nan is not inside the domain (0, 1)");
}

}  // namespace
}  // namespace splinecore
