#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Largest distance of the homogeneous points, relative to the largest coordinate.
template <class Map>
double difference(const NurbsCurve& before, const NurbsCurve& after, std::span<const double> parameters, Map map) {
  double error = 0.0;
  for (const double u : parameters) {
    error = worse(error, largest(homogeneous_at(before, u) - homogeneous_at(after, map(u))));
  }
  return error / size_of(before);
}

double difference(const NurbsCurve& before, const NurbsCurve& after, std::span<const double> parameters) {
  return difference(before, after, parameters, [](double u) { return u; });
}

NurbsCurve random_plain_curve(Random& random, Weights weights = Weights::any) {
  return random_curve(
      random, {integer(random, 1, 9), integer(random, 1, 8), static_cast<Ends>(integer(random, 0, 1)), weights});
}

NurbsCurve random_periodic_curve(Random& random) {
  return random_curve(random, {integer(random, 1, 9), integer(random, 1, 8), Ends::periodic, Weights::any});
}

TEST(Split, GivesBothPartsOfThousandRandomCurves) {
  Random random(60);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_plain_curve(random);
    const Interval range = curve.domain();
    const double u = range.start + range.length() * real(random, 0.01, 0.99);
    const auto [left, right] = split(curve, u);
    EXPECT_EQ(left.domain(), (Interval{range.start, u}));
    EXPECT_EQ(right.domain(), (Interval{u, range.end}));
    EXPECT_LE(difference(curve, left, random_parameters(random, left.domain(), 5)), 1e-12);
    EXPECT_LE(difference(curve, right, random_parameters(random, right.domain(), 5)), 1e-12);
  }
}

TEST(Split, AtAKnotOfAnyMultiplicityKeepsBothLimits) {
  Random random(61);
  for (int degree = 1; degree <= 9; ++degree) {
    for (int times = 1; times <= degree + 1; ++times) {
      std::vector<double> knots(degree + 1, 0.0);
      knots.insert(knots.end(), times, 1.0);
      knots.insert(knots.end(), degree + 1, 2.0);
      const NurbsCurve curve =
          NurbsCurve::make(degree, knots, random_points(random, degree + 1 + times, Weights::positive));
      const auto [left, right] = split(curve, 1);
      EXPECT_LE(largest(point_at(left, 1) - point_at(curve, 1, Side::left)), 1e-12) << degree << " " << times;
      EXPECT_LE(largest(point_at(right, 1) - point_at(curve, 1, Side::right)), 1e-12) << degree << " " << times;
    }
  }
}

TEST(Split, OfAnArcAtItsMiddleGivesArcsOfTheSameCircle) {
  const NurbsCurve semicircle = NurbsCurve::make(KnotVector::bezier(2), {{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  const auto [left, right] = split(semicircle, 0.5);
  EXPECT_EQ(left.points()[2], glm::dvec4(0, 1, 0, 0.5));
  EXPECT_EQ(left.points()[1], glm::dvec4(1, 1, 0, 0.5));
  EXPECT_EQ(right.points()[1], glm::dvec4(-1, 1, 0, 0.5));
}

TEST(Split, RefusesParametersThatLeaveNothingAndPeriodicCurves) {
  const NurbsCurve line = NurbsCurve::make(KnotVector::bezier(1), {{0, 0, 0, 1}, {1, 0, 0, 1}});
  EXPECT_EQ(refusal([&] { split(line, 0); }), "u = 0 is not inside the domain (0, 1)");
  EXPECT_EQ(refusal([&] { split(line, 1); }), "u = 1 is not inside the domain (0, 1)");
  EXPECT_EQ(refusal([&] { split(line, -3); }), "u = -3 is not inside the domain (0, 1)");
  EXPECT_EQ(refusal([&] { split(line, std::numeric_limits<double>::quiet_NaN()); }),
            "u = nan is not inside the domain (0, 1)");
  const NurbsCurve ring =
      NurbsCurve::make(KnotVector::periodic_uniform(2, 3), std::vector<glm::dvec4>(3, glm::dvec4(1)));
  EXPECT_EQ(refusal([&] { split(ring, 1.5); }),
            "a periodic shape is not cut in two at one parameter: open it there first");
}

TEST(Split, RefusesAPartThatLiesAtInfinityAltogether) {
  const NurbsCurve curve = NurbsCurve::make(KnotVector::clamped(1, 3), {{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 0}});
  EXPECT_EQ(refusal([&] { split(curve, 1.5); }), "weights are all zero: no point of the shape is finite");
}

TEST(Opened, IsThePeriodicCurveFromThereOnForThousandCurves) {
  Random random(62);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_periodic_curve(random);
    const Interval range = curve.domain();
    const auto& knots = curve.knot_vector();
    const bool at_knot = integer(random, 0, 2) == 0;
    const int span = integer(random, 0, static_cast<int>(knots.spans().size()) - 1);
    const double u = at_knot ? knots.span_interval(span).start : real(random, range.start, range.end);
    const NurbsCurve open = opened(curve, u);
    EXPECT_FALSE(open.periodic());
    EXPECT_EQ(open.domain().start, u);
    EXPECT_NEAR(open.domain().length(), range.length(), 1e-15 * (std::abs(u) + range.length()));
    EXPECT_EQ(multiplicity(open.knot_vector(), u), curve.degree() + 1);
    EXPECT_EQ(multiplicity(open.knot_vector(), open.domain().end), curve.degree() + 1);
    EXPECT_LE(difference(curve, open, random_parameters(random, open.domain(), 8)), 1e-12) << "u = " << u;
  }
}

TEST(Opened, TakesItsParameterModuloThePeriodAndRefusesPlainCurves) {
  Random random(63);
  const NurbsCurve ring =
      NurbsCurve::make(KnotVector::periodic_uniform(3, 4), random_points(random, 4, Weights::positive));
  EXPECT_EQ(opened(ring, 5.5), opened(ring, 1.5));
  EXPECT_EQ(opened(ring, 4), opened(ring, 0));
  EXPECT_EQ(refusal([&] { opened(unrolled(ring), 1); }), "only a periodic curve can be opened");
}

TEST(Unrolled, IsThePeriodicCurveOnItsFirstPeriod) {
  Random random(64);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_periodic_curve(random);
    const NurbsCurve plain = unrolled(curve);
    EXPECT_FALSE(plain.periodic());
    EXPECT_EQ(plain.domain(), curve.domain());
    EXPECT_EQ(difference(curve, plain, random_parameters(random, curve.domain(), 8)), 0.0);
  }
}

TEST(Unrolled, ReturnsAPlainCurveAsItIs) {
  Random random(65);
  const NurbsCurve curve = random_plain_curve(random);
  EXPECT_EQ(unrolled(curve), curve);
}

TEST(Reversed, RunsBackwardsOverTheSameDomainForThousandCurves) {
  Random random(66);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_curve(random);
    const NurbsCurve back = reversed(curve);
    const Interval range = curve.domain();
    EXPECT_EQ(back.domain(), range);
    EXPECT_EQ(back.periodic(), curve.periodic());
    const auto mirror = [&](double u) { return range.start + (range.end - u); };
    EXPECT_LE(difference(curve, back, random_parameters(random, range, 8), mirror), 1e-12);
  }
}

TEST(Reversed, KeepsThePointsBitForBit) {
  Random random(67);
  const NurbsCurve plain = random_plain_curve(random);
  EXPECT_TRUE(
      std::ranges::equal(reversed(plain).points(), std::vector(plain.points().rbegin(), plain.points().rend())));
  for (int round = 0; round < 50; ++round) {
    const NurbsCurve ring = random_periodic_curve(random);
    EXPECT_TRUE(std::ranges::is_permutation(reversed(ring).points(), ring.points()));
    EXPECT_TRUE(std::ranges::equal(reversed(reversed(ring)).points(), ring.points()));
  }
}

TEST(NurbsCurveMake, NamesWhatIsWrong) {
  const auto refused = [](int degree, std::vector<double> knots, std::vector<glm::dvec4> points) {
    return refusal([&] { NurbsCurve::make(degree, knots, points); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> knots{0, 0, 1, 1};
  EXPECT_EQ(refused(0, {0, 1}, {{0, 0, 0, 1}}), "degree = 0: a curve needs degree 1 or more");
  EXPECT_EQ(refused(1, knots, {{0, 0, 0, 1}}), "points has 1 rows, but 4 knots of degree 1 belong to 2");
  EXPECT_EQ(refused(1, knots, {{0, 0, 0, 1}, {0, nan, 0, 1}}), "points[1].y = nan is not finite");
  EXPECT_EQ(refused(1, knots, {{0, 0, -infinity, 1}, {0, 0, 0, 1}}), "points[0].z = -inf is not finite");
  EXPECT_EQ(refused(1, knots, {{0, 0, 0, 1}, {0, 0, 0, infinity}}), "weights[1] = inf is not finite");
  EXPECT_EQ(refused(1, knots, {{1, 0, 0, 0}, {0, 1, 0, -0.0}}),
            "weights are all zero: no point of the shape is finite");
  EXPECT_EQ(refused(2, {0, 1, 2, 3}, {{0, 0, 0, 1}}),
            "knots leave no domain: for degree 2 the knots u_2 and u_1 must differ");
}

TEST(NurbsCurve, GivesPointsAndWeightsBackBitForBit) {
  const std::vector<glm::dvec4> points{{1.0 / 3, -0.0, 5e-324, 1.0 / 7}, {0.1, 0.2, 0.3, -0.7}, {1, 2, 3, 0}};
  const NurbsCurve curve = NurbsCurve::make(KnotVector::bezier(2), points);
  EXPECT_TRUE(std::ranges::equal(curve.points(), points));
  EXPECT_TRUE(std::signbit(curve.points()[0].y));
  EXPECT_EQ(NurbsCurve::from_homogeneous(KnotVector::bezier(2),
                                         std::vector<glm::dvec4>{{2, 4, 6, 2}, {1, 0, 0, 0}, {3, 0, 0, -1}}),
            NurbsCurve::make(KnotVector::bezier(2), {{1, 2, 3, 2}, {1, 0, 0, 0}, {-3, 0, 0, -1}}));
}

}  // namespace
}  // namespace splinecore
