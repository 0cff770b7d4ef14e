#include "splinecore/build/cardinal.hpp"

#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Shaping kPlain{};

std::vector<glm::dvec3> random_places(Random& random, int count) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random_vector(random));
  return points;
}

HermiteCurve spline(const std::vector<glm::dvec3>& points, Parameterization kind, const Shaping& shaping = kPlain,
                    Closing closing = Closing::open, EndTangent ends = EndTangent::parabola) {
  return kochanek_bartels(points, {&shaping, 1}, parameters_of(points, kind, closing), closing, ends);
}

glm::dvec3 derivative_at(const HermiteCurve& curve, double u, int order, Side side) {
  std::vector<glm::dvec3> values(order + 1);
  derivatives(curve.nurbs(), {&u, 1}, order, std::span(&values[0].x, 3 * values.size()), {.side = side});
  return values[order];
}

// Lecture row S5.
TEST(KochanekBartels, OnUniformParametersHasTheTangentsOfTheLectures) {
  Random random(320);
  for (int round = 0; round < 200; ++round) {
    const std::vector<glm::dvec3> p = random_places(random, 3);
    const double t = real(random, -1, 1), c = real(random, -1, 1), b = real(random, -1, 1);
    const HermiteCurve curve = spline(p, Parameterization::uniform, {t, c, b});
    const glm::dvec3 before = p[1] - p[0], after = p[2] - p[1];
    const glm::dvec3 incoming = (1 - t) * (1 - c) * (1 + b) / 2 * before + (1 - t) * (1 + c) * (1 - b) / 2 * after;
    const glm::dvec3 outgoing = (1 - t) * (1 + c) * (1 + b) / 2 * before + (1 - t) * (1 - c) * (1 - b) / 2 * after;
    EXPECT_LE(largest(curve.tangents()[1].incoming - incoming), 1e-13);
    EXPECT_LE(largest(curve.tangents()[1].outgoing - outgoing), 1e-13);
  }
}

TEST(KochanekBartels, WithoutShapingIsCatmullsAndRoms) {
  Random random(321);
  const std::vector<glm::dvec3> p = random_places(random, 6);
  const HermiteCurve uniform = spline(p, Parameterization::uniform);
  const HermiteCurve tense = spline(p, Parameterization::uniform, {0.25, 0, 0});
  for (int i = 1; i < 5; ++i) {
    EXPECT_LE(largest(uniform.tangents()[i].incoming - 0.5 * (p[i + 1] - p[i - 1])), 1e-14);
    EXPECT_EQ(uniform.tangents()[i].incoming, uniform.tangents()[i].outgoing);
    EXPECT_LE(largest(tense.tangents()[i].incoming - 0.375 * (p[i + 1] - p[i - 1])), 1e-14);
  }
}

TEST(KochanekBartels, ReproducesAParabolaOnAnyParameters) {
  const std::vector<double> u{0, 0.5, 2, 2.25, 4};
  std::vector<glm::dvec3> points;
  for (const double t : u) points.emplace_back(t, t * t, 3 - t - 2 * t * t);
  const HermiteCurve curve = kochanek_bartels(points, {&kPlain, 1}, u);
  for (std::size_t i = 0; i < u.size(); ++i) {
    EXPECT_LE(largest(curve.tangents()[i].outgoing - glm::dvec3(1, 2 * u[i], -1 - 4 * u[i])), 1e-14) << i;
  }
  EXPECT_LE(largest(point_at(curve.nurbs(), 3.0) - glm::dvec3(3, 9, -18)), 1e-14);
}

TEST(KochanekBartels, HasTheTangentsThatItsEndsAsk) {
  Random random(322);
  const std::vector<glm::dvec3> p = random_places(random, 5);
  const HermiteCurve natural = spline(p, Parameterization::chordal, {0.3, 0.2, 0.1}, Closing::open, EndTangent::natural);
  const double end = natural.parameters().back();
  EXPECT_LE(largest(derivative_at(natural, 0, 2, Side::right)), 1e-13);
  EXPECT_LE(largest(derivative_at(natural, end, 2, Side::left)), 1e-13);
  const HermiteCurve chord = spline(p, Parameterization::uniform, {0.5, 0, 0}, Closing::open, EndTangent::chord);
  EXPECT_EQ(chord.tangents().front().outgoing, 0.5 * (p[1] - p[0]));
  EXPECT_EQ(chord.tangents().back().incoming, 0.5 * (p[4] - p[3]));
  for (const EndTangent ends : {EndTangent::parabola, EndTangent::chord, EndTangent::natural}) {
    const HermiteCurve line = spline({p[0], p[1]}, Parameterization::uniform, kPlain, Closing::open, ends);
    EXPECT_LE(largest(point_at(line.nurbs(), 0.25) - (0.75 * p[0] + 0.25 * p[1])), 1e-14);
  }
}

TEST(KochanekBartels, ClosedReturnsWithOneTangentAndDoesNotMindWhereItBegan) {
  Random random(323);
  for (const auto kind : {Parameterization::uniform, Parameterization::centripetal, Parameterization::chordal}) {
    std::vector<glm::dvec3> p = random_places(random, 7);
    const HermiteCurve curve = spline(p, kind, {0.1, 0, -0.3}, Closing::closed);
    ASSERT_EQ(curve.points().size(), 8u);
    EXPECT_EQ(curve.points().back(), p.front());
    EXPECT_EQ(curve.tangents().front(), curve.tangents().back());
    std::rotate(p.begin(), p.begin() + 1, p.end());
    const HermiteCurve turned = spline(p, kind, {0.1, 0, -0.3}, Closing::closed);
    for (int i = 0; i < 7; ++i) {
      EXPECT_LE(largest(turned.tangents()[i].outgoing - curve.tangents()[i + 1].outgoing), 1e-12);
    }
  }
}

TEST(KochanekBartels, RunBackwardsHasItsTangentsTurned) {
  Random random(324);
  for (int round = 0; round < 100; ++round) {
    std::vector<glm::dvec3> p = random_places(random, integer(random, 2, 7));
    const double t = real(random, -1, 1), c = real(random, -1, 1), b = real(random, -1, 1);
    const auto ends = static_cast<EndTangent>(integer(random, 0, 2));
    const HermiteCurve curve = spline(p, Parameterization::chordal, {t, c, b}, Closing::open, ends);
    std::ranges::reverse(p);
    const HermiteCurve back = spline(p, Parameterization::chordal, {t, c, -b}, Closing::open, ends);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Tangents& there = curve.tangents()[p.size() - 1 - i];
      EXPECT_LE(largest(back.tangents()[i].incoming + there.outgoing), 1e-12);
      EXPECT_LE(largest(back.tangents()[i].outgoing + there.incoming), 1e-12);
    }
  }
}

TEST(KochanekBartels, OfOnePointEachIsItsOwn) {
  Random random(325);
  const std::vector<glm::dvec3> p = random_places(random, 4);
  const std::vector<Shaping> shaping{{}, {1, 0, 0}, {0, 0, 0}, {}};
  const HermiteCurve curve = kochanek_bartels(p, shaping, {});
  EXPECT_EQ(curve.tangents()[1].incoming, glm::dvec3(0));
  EXPECT_LE(largest(curve.tangents()[2].incoming - 0.5 * (p[3] - p[1])), 1e-14);
}

TEST(ParametersOf, AreDistancesTheirRootsOrOne) {
  const std::vector<glm::dvec3> p{{0, 0, 0}, {3, 4, 0}, {3, 4, 9}};
  EXPECT_EQ(parameters_of(p, Parameterization::uniform), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(parameters_of(p, Parameterization::chordal), (std::vector<double>{0, 5, 14}));
  EXPECT_EQ(parameters_of(p, Parameterization::centripetal), (std::vector<double>{0, std::sqrt(5.0), 3 + std::sqrt(5.0)}));
  EXPECT_EQ(parameters_of(p, Parameterization::uniform, Closing::closed), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_NEAR(parameters_of(p, Parameterization::chordal, Closing::closed)[3], 14 + std::sqrt(106), 1e-14);
}

TEST(KochanekBartels, NamesWhatIsWrong) {
  const std::vector<glm::dvec3> p{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(refusal([&] { spline(p, Parameterization::chordal); }),
            "points[2] is too close to points[1]: they coincide within rounding and get equal parameters");
  EXPECT_EQ(refusal([&] { spline({p[0], p[1], {2, 2, 2}, p[0]}, Parameterization::centripetal, kPlain, Closing::closed); }),
            "points[0] is too close to points[3]: they coincide within rounding and get equal parameters");
  EXPECT_EQ(refusal([&] { spline({{0, 0, 0}, {1e308, 1e308, 1e308}, {-1e308, 0, 0}}, Parameterization::chordal); }),
            "points[2] is too far from points[1]: their distance overflows");
  EXPECT_EQ(refusal([&] { spline({p[0]}, Parameterization::uniform); }), "points has 1 rows, 2 or more are needed");
  EXPECT_EQ(refusal([&] { spline({p[0], p[1]}, Parameterization::uniform, kPlain, Closing::closed); }),
            "points has 2 rows, 3 or more are needed");
  EXPECT_EQ(refusal([&] { spline({p[0], {0, 0, kNan}}, Parameterization::uniform); }), "points[1].z = nan is not finite");
  EXPECT_EQ(refusal([&] { spline(p, Parameterization::uniform, {0, kNan, 0}); }), "continuity = nan is not finite");
  const std::vector<Shaping> three{{}, {}, {0, 0, kNan}};
  EXPECT_EQ(refusal([&] { kochanek_bartels(p, three, {}); }), "shaping has 3 rows for 4 points");
  EXPECT_EQ(refusal([&] { kochanek_bartels(std::span(p).first(3), three, {}); }), "bias[2] = nan is not finite");
  EXPECT_EQ(refusal([&] { kochanek_bartels(p, {&kPlain, 1}, {0, 1, 2}); }), "parameters has 3 values for 4 points");
  EXPECT_EQ(spline(p, Parameterization::uniform).points().size(), 4u);
}

}  // namespace
}  // namespace splinecore
