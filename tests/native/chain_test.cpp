#include "splinecore/build/chain.hpp"

#include <limits>

#include "splinecore/basis/uniform.hpp"
#include "splinecore/build/join.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<glm::dvec3> random_places(Random& random, int count) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random_vector(random));
  return points;
}

std::vector<double> random_steps(Random& random, int count) {
  std::vector<double> parameters{real(random, -3, 3)};
  while (static_cast<int>(parameters.size()) < count) parameters.push_back(parameters.back() + real(random, 0.1, 2));
  return parameters;
}

std::vector<double> steps_of(const std::vector<double>& parameters) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < parameters.size(); ++i) steps.push_back(parameters[i] - parameters[i - 1]);
  return steps;
}

BezierCurve polynomial(const std::vector<glm::dvec3>& places) {
  std::vector<glm::dvec4> points;
  for (const glm::dvec3& place : places) points.emplace_back(place, 1.0);
  return BezierCurve::make(points);
}

// Lecture row S8, with knots 0, 1, 2, 3 and d_i = (i, 0, 0) scaled so that every quotient is seen.
TEST(ChainFromPolygon, HasThePointsFGAndEOfTheLectures) {
  const std::vector<glm::dvec3> d{{0, 0, 0}, {6, 0, 0}, {12, 12, 0}, {24, 0, 0}, {30, 6, 0}, {36, 0, 6}};
  const std::vector<BezierCurve> chain = chain_from_polygon(d, {0, 1, 2, 3});
  ASSERT_EQ(chain.size(), 3u);
  const std::vector<std::vector<glm::dvec3>> expected{
      {{0, 0, 0}, {6, 0, 0}, {9, 6, 0}, {12.5, 7, 0}},
      {{12.5, 7, 0}, {16, 8, 0}, {20, 4, 0}, {23.5, 3.5, 0}},
      {{23.5, 3.5, 0}, {27, 3, 0}, {30, 6, 0}, {36, 0, 6}}};
  for (int arc = 0; arc < 3; ++arc) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_LE(largest(glm::dvec3(chain[arc].points()[i]) - expected[arc][i]), 1e-14) << arc << i;
    }
  }
  const std::vector<BezierCurve> single = chain_from_polygon(std::span(d).first(4));
  ASSERT_EQ(single.size(), 1u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(glm::dvec3(single[0].points()[i]), d[i]);
}

TEST(ChainFromPolygon, IsTheCubicBSplineWithFourfoldEnds) {
  Random random(330);
  for (int round = 0; round < 300; ++round) {
    const int arcs = integer(random, 1, 8);
    const std::vector<glm::dvec3> d = random_places(random, arcs + 3);
    const std::vector<double> u = random_steps(random, arcs + 1);
    std::vector<double> knots(3, u.front());
    knots.insert(knots.end(), u.begin(), u.end());
    knots.insert(knots.end(), 3, u.back());
    std::vector<glm::dvec4> points;
    for (const glm::dvec3& place : d) points.emplace_back(place, 1.0);
    const std::vector<BezierCurve> expected = to_bezier(NurbsCurve::make(3, knots, points));
    const std::vector<BezierCurve> chain = chain_from_polygon(d, u);
    ASSERT_EQ(chain.size(), expected.size());
    for (int arc = 0; arc < arcs; ++arc) {
      for (int i = 0; i < 4; ++i) EXPECT_LE(largest(chain[arc].points()[i] - expected[arc].points()[i]), 1e-13);
    }
    const std::vector<glm::dvec3> again = polygon_of_chain(chain, steps_of(u));
    ASSERT_EQ(again.size(), d.size());
    for (std::size_t i = 0; i < d.size(); ++i) EXPECT_LE(largest(again[i] - d[i]), 1e-10) << i;
  }
}

TEST(PolygonOfChain, RefusesTheJointThatIsNotC2) {
  const std::vector<glm::dvec3> d{{0, 0, 0}, {6, 0, 0}, {12, 12, 0}, {24, 0, 0}, {30, 6, 0}, {36, 0, 6}};
  const std::vector<BezierCurve> chain = chain_from_polygon(d);
  const auto moved = [&](int arc, int i, double by) {
    std::vector<BezierCurve> other = chain;
    std::vector<glm::dvec4> points(chain[arc].points().begin(), chain[arc].points().end());
    points[i].y += by;
    other[arc] = BezierCurve::make(points);
    return refusal([&] { polygon_of_chain(other); });
  };
  EXPECT_EQ(moved(1, 0, 0.5), "joint 1 is not C0: two places that should be one lie 0.5 apart");
  EXPECT_EQ(moved(2, 1, 0.5), "joint 2 is not C1: two places that should be one lie 0.25 apart");
  EXPECT_EQ(moved(2, 2, 0.5), "joint 2 is not C2: two places that should be one lie 0.5 apart");
  EXPECT_EQ(moved(2, 3, 0.5), "not refused");
  EXPECT_EQ(refusal([&] { polygon_of_chain(chain, {1, 2, 1}); }).substr(0, 17), "joint 1 is not C1");
  EXPECT_EQ(refusal([&] { polygon_of_chain(chain, {1, 2, 1}, 100.0); }), "not refused");
  EXPECT_EQ(refusal([&] { polygon_of_chain(chain, {1, 2}); }), "lengths has 2 values for 3 curves");
  EXPECT_EQ(refusal([&] { polygon_of_chain(chain, {1, 0, 1}); }), "lengths[1] = 0 is not a positive length");
  EXPECT_EQ(refusal([&] { polygon_of_chain(chain, {}, -1.0); }), "tolerance = -1 is not 0 or more");
  EXPECT_EQ(refusal([&] { polygon_of_chain({}); }), "chain is empty: it needs one curve or more");
  const std::vector<BezierCurve> line{polynomial({{0, 0, 0}, {1, 0, 0}})};
  EXPECT_EQ(refusal([&] { polygon_of_chain(line); }), "chain[0] has degree 1, not 3");
  const std::vector<BezierCurve> rational{BezierCurve::make({{0, 0, 0, 1}, {1, 0, 0, 2}, {1, 1, 0, 1}, {0, 1, 0, 1}})};
  EXPECT_EQ(refusal([&] { polygon_of_chain(rational); }),
            "chain[0] is rational: the polygon is that of a polynomial chain");
}

TEST(ChainFromPolygon, NamesWhatIsWrong) {
  const std::vector<glm::dvec3> d(5);
  EXPECT_EQ(refusal([&] { chain_from_polygon(std::span(d).first(3)); }), "points has 3 rows, a cubic chain needs 4 or more");
  EXPECT_EQ(refusal([&] { chain_from_polygon(d, {0, 1}); }), "parameters has 2 values for 3 points");
  EXPECT_EQ(refusal([&] { chain_from_polygon(d, {0, 1, 1}); }), "parameters[2] = 1 does not increase from 1");
}

// Lecture row S7.
TEST(C2Pair, MeetsWithEqualDerivativesOnItsIntervals) {
  Random random(331);
  for (int round = 0; round < 300; ++round) {
    const std::vector<glm::dvec3> p = random_places(random, 5);
    const double a = real(random, 0.1, 3), b = real(random, 0.1, 3);
    const auto [q, r] = c2_pair(p[0], p[1], p[2], p[3], p[4], a, b);
    const NurbsCurve joined = join_beziers(std::vector{q, r}, {0, a, a + b});
    glm::dvec3 before[3], after[3];
    derivatives(joined, {&a, 1}, 2, std::span(&before[0].x, 9), {.side = Side::left});
    derivatives(joined, {&a, 1}, 2, std::span(&after[0].x, 9));
    for (int k = 0; k < 3; ++k) EXPECT_LE(largest(before[k] - after[k]), 1e-9 * std::pow(10 / std::min(a, b), k)) << k;
    const std::vector<glm::dvec3> polygon = polygon_of_chain(std::vector{q, r}, {a, b});
    EXPECT_LE(largest(polygon[2] - p[2]), 1e-10);
    EXPECT_EQ(glm::dvec3(q.points()[0]), p[0]);
    EXPECT_EQ(glm::dvec3(r.points()[3]), p[4]);
  }
  EXPECT_EQ(refusal([] { c2_pair({}, {}, {}, {}, {}, 0, 1); }), "a = 0 is not a positive length");
  EXPECT_EQ(refusal([] { c2_pair({}, {}, {0, kNan, 0}, {}, {}, 1, 1); }), "d[1] = nan is not finite");
}

TEST(JoinBeziers, KeepsEverySegmentWhateverItsDegreeAndWeights) {
  Random random(332);
  for (int round = 0; round < 300; ++round) {
    std::vector<BezierCurve> curves;
    for (int i = integer(random, 1, 5); i > 0; --i) {
      std::vector<glm::dvec4> points = random_points(random, integer(random, 2, 7), Weights::positive);
      if (!curves.empty()) points.front() = {glm::dvec3(curves.back().points().back()), points.front().w};
      curves.push_back(BezierCurve::make(points));
    }
    const std::vector<double> u = random_steps(random, static_cast<int>(curves.size()) + 1);
    const NurbsCurve joined = join_beziers(curves, u);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_LE(joined.degree() - curves[i].degree(), 5);
      for (const double t : {0.0, 0.25, 0.5, 0.9}) {
        const glm::dvec3 point = point_at(curves[i].nurbs(), t);
        EXPECT_LE(largest(point_at(joined, u[i] + t * (u[i + 1] - u[i])) - point), 1e-11) << i;
      }
    }
  }
}

TEST(JoinBeziers, RefusesWhatDoesNotMeet) {
  const BezierCurve one = polynomial({{0, 0, 0}, {1, 0, 0}});
  const BezierCurve far = polynomial({{1, 0.25, 0}, {2, 0, 0}});
  const auto joined = [](std::vector<BezierCurve> curves, std::vector<double> u = {}, double tolerance = 0) {
    return refusal([&] { join_beziers(curves, u, tolerance); });
  };
  EXPECT_EQ(joined({one, far}), "joint 1 is open: an end lies 0.25 from the next start, the tolerance is 0");
  EXPECT_EQ(joined({one, far}, {}, 0.25), "not refused");
  EXPECT_EQ(joined({}), "curves is empty: it needs one curve or more");
  EXPECT_EQ(joined({one}, {0, 1, 2}), "parameters has 3 values for 1 curves");
  EXPECT_EQ(joined({one}, {1, 0}), "parameters[1] = 0 does not increase from 1");
  EXPECT_EQ(joined({one}, {}, -1), "tolerance = -1 is not 0 or more");
  EXPECT_EQ(joined({one, BezierCurve::make({{1, 0, 0, 0}, {1, 1, 1, 1}})}),
            "joint 1 lies at infinity: the weight of an end is zero");
  const NurbsCurve lines = join_beziers(std::vector{one, polynomial({{1, 0, 0}, {2, 3, 0}})});
  EXPECT_TRUE(std::ranges::equal(lines.knot_vector().knots(), std::vector<double>{0, 0, 1, 2, 2}));
}

// Lecture row S13.
TEST(UniformMatrix, IsTheLecturesMatrix) {
  const double spline[]{-1, 3, -3, 1, 3, -6, 3, 0, -3, 0, 3, 0, 1, 4, 1, 0};
  const double bezier[]{1, 4, 1, 0, 0, 4, 2, 0, 0, 2, 4, 0, 0, 1, 4, 1};
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(uniform_matrix(3).values[i], spline[i] / 6);
    EXPECT_EQ(uniform_to_bezier(3).values[i], bezier[i] / 6);
  }
  EXPECT_EQ(bezier_matrix(3).values, (std::vector<double>{-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(hermite_matrix().values, (std::vector<double>{2, 1, -2, 1, -3, -2, 3, -1, 0, 1, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(uniform_matrix(0).values, std::vector<double>{1});
  EXPECT_EQ(refusal([] { uniform_matrix(19); }), "degree = 19 is outside [0, 18]");
  EXPECT_EQ(refusal([] { uniform_to_bezier(-1); }), "degree = -1 is outside [0, 18]");
  EXPECT_EQ(refusal([] { bezier_matrix(34); }), "degree = 34 is outside [0, 33]");
}

TEST(UniformToBezier, AgreesWithTheBlossoms) {
  for (int degree = 1; degree <= kMaxUniformDegree; ++degree) {
    const KnotVector knots = KnotVector::uniform(degree, degree + 1);
    const auto blossoms = knots.bezier_matrix(0);
    const std::vector<double> values = uniform_to_bezier(degree).values;
    const std::size_t order = blossoms.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], blossoms[i / order][i % order], 1e-15) << degree;
    }
  }
}

}  // namespace
}  // namespace splinecore
