#include "splinecore/curve/hermite_curve.hpp"

#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

HermiteCurve random_chain(Random& random, int count) {
  std::vector<glm::dvec3> points;
  std::vector<Tangents> tangents;
  std::vector<double> parameters{real(random, -2, 2)};
  for (int i = 0; i < count; ++i) {
    points.push_back(random_vector(random));
    tangents.push_back({random_vector(random), random_vector(random)});
    if (i > 0) parameters.push_back(parameters.back() + real(random, 0.1, 2));
  }
  return HermiteCurve::make(points, tangents, parameters);
}

glm::dvec3 tangent_at(const NurbsCurve& curve, double u, Side side) {
  glm::dvec3 values[2];
  derivatives(curve, {&u, 1}, 1, std::span(&values[0].x, 6), {.side = side});
  return values[1];
}

// Lecture row S4: H0 = 2t^3-3t^2+1, H1 = -2t^3+3t^2, H2 = t^3-2t^2+t, H3 = t^3-t^2.
TEST(HermiteCurve, IsTheSumOfHermitesPolynomials) {
  Random random(80);
  const glm::dvec3 p1 = random_vector(random), p4 = random_vector(random);
  const glm::dvec3 r1 = random_vector(random), r4 = random_vector(random);
  const HermiteCurve curve = HermiteCurve::make({p1, p4}, {{{}, r1}, {r4, {}}});
  for (const double t : random_parameters(random, {0, 1}, 50)) {
    const glm::dvec3 expected = (2 * t * t * t - 3 * t * t + 1) * p1 + (-2 * t * t * t + 3 * t * t) * p4 +
                                (t * t * t - 2 * t * t + t) * r1 + (t * t * t - t * t) * r4;
    EXPECT_LE(largest(point_at(curve.nurbs(), t) - expected), 1e-13) << t;
  }
}

TEST(HermiteCurve, PassesThroughItsPointsWithItsTangentsOnAnyParameters) {
  Random random(81);
  for (const int count : {2, 3, 8}) {
    const HermiteCurve curve = random_chain(random, count);
    for (int i = 0; i < count; ++i) {
      const double u = curve.parameters()[i];
      EXPECT_EQ(point_at(curve.nurbs(), u), curve.points()[i]) << i;
      const Tangents& tangents = curve.tangents()[i];
      if (i > 0) { EXPECT_LE(largest(tangent_at(curve.nurbs(), u, Side::left) - tangents.incoming), 1e-12); }
      if (i + 1 < count) { EXPECT_LE(largest(tangent_at(curve.nurbs(), u, Side::right) - tangents.outgoing), 1e-12); }
    }
  }
}

TEST(HermiteCurve, HasParametersZeroOneTwoUnlessGiven) {
  const HermiteCurve curve = HermiteCurve::make({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, std::vector<Tangents>(3));
  EXPECT_TRUE(std::ranges::equal(curve.parameters(), std::vector<double>{0, 1, 2}));
}

TEST(HermiteCurveSplit, KeepsTheCurveAtParametersAndBetweenThem) {
  Random random(82);
  for (int round = 0; round < 1000; ++round) {
    const HermiteCurve curve = random_chain(random, integer(random, 2, 6));
    const Interval range = curve.nurbs().domain();
    const int last = static_cast<int>(curve.points().size()) - 1;
    const bool at_point = last > 1 && integer(random, 0, 1) == 0;
    const double u = at_point ? curve.parameters()[integer(random, 1, last - 1)]
                              : range.start + range.length() * real(random, 0.01, 0.99);
    const auto [before, after] = split(curve, u);
    for (const HermiteCurve& part : {before, after}) {
      for (const double at : random_parameters(random, part.nurbs().domain(), 5)) {
        EXPECT_LE(largest(point_at(part.nurbs(), at) - point_at(curve.nurbs(), at)), 1e-12 * size_of(curve.nurbs()));
      }
    }
    EXPECT_EQ(before.parameters().back(), u);
    EXPECT_EQ(after.parameters().front(), u);
    EXPECT_EQ(before.points().size() + after.points().size(), curve.points().size() + (at_point ? 1 : 2));
  }
}

TEST(HermiteCurveReversed, RunsBackwards) {
  Random random(83);
  for (int round = 0; round < 1000; ++round) {
    const HermiteCurve curve = random_chain(random, integer(random, 2, 6));
    const HermiteCurve back = reversed(curve);
    const Interval range = curve.nurbs().domain();
    EXPECT_EQ(back.nurbs().domain(), range);
    EXPECT_EQ(back.tangents().front().outgoing, -curve.tangents().back().incoming);
    for (const double u : random_parameters(random, range, 5)) {
      const glm::dvec3 expected = point_at(curve.nurbs(), u);
      EXPECT_LE(largest(point_at(back.nurbs(), range.start + (range.end - u)) - expected),
                1e-12 * size_of(curve.nurbs()));
    }
  }
}

TEST(HermiteCurveMake, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}};
  const std::vector<Tangents> tangents(2);
  const auto refused = [](std::vector<glm::dvec3> p, std::vector<Tangents> t, std::vector<double> u) {
    return refusal([&] { HermiteCurve::make(p, t, u); });
  };
  EXPECT_EQ(refused({{0, 0, 0}}, std::vector<Tangents>(1), {}), "points has 1 rows, a Hermite chain needs 2 or more");
  EXPECT_EQ(refused(points, std::vector<Tangents>(3), {}), "tangents has 3 rows for 2 points");
  EXPECT_EQ(refused({{0, 0, 0}, {0, 0, nan}}, tangents, {}), "points[1].z = nan is not finite");
  EXPECT_EQ(refused(points, {{}, {{0, nan, 0}, {}}}, {}), "tangents[1, 0].y = nan is not finite");
  EXPECT_EQ(refused(points, tangents, {0, 1, 2}), "parameters has 3 values for 2 points");
  EXPECT_EQ(refused(points, tangents, {0, nan}), "parameters[1] = nan is not finite");
  EXPECT_EQ(refused(points, tangents, {1, 1}), "parameters[1] = 1 does not increase from 1");
  EXPECT_EQ(refused(points, tangents, {-1e308, 1e308}),
            "parameters from -1e+308 to 1e+308 overflow: their distance is not a finite number");
  const HermiteCurve curve = HermiteCurve::make(points, tangents);
  EXPECT_EQ(refusal([&] { split(curve, 1); }), "u = 1 is not inside the domain (0, 1)");
  EXPECT_EQ(refusal([&] { split(curve, nan); }), "u = nan is not inside the domain (0, 1)");
}

}  // namespace
}  // namespace splinecore
