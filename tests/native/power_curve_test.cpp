#include "splinecore/curve/power_curve.hpp"

#include "splinecore/convert/to_power.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

PowerCurve random_power(Random& random, Weights weights) {
  std::vector<glm::dvec4> rows;
  const int degree = integer(random, 1, 9);
  for (int k = 0; k <= degree; ++k) {
    const double w = weights == Weights::one ? (k == 0 ? 1.0 : 0.0) : (k == 0 ? 4.0 : real(random, -0.1, 0.1));
    rows.emplace_back(random_vector(random), w);
  }
  const double start = real(random, -1, 1);
  return PowerCurve::make(rows, start + real(random, -0.5, 0.5), {start, start + real(random, 0.1, 1)});
}

glm::dvec4 horner(const PowerCurve& curve, double t) {
  glm::dvec4 sum(0.0);
  for (int k = curve.degree(); k >= 0; --k) sum = sum * (t - curve.origin()) + curve.coefficients()[k];
  return sum;
}

TEST(PowerCurve, IsTheSumOfItsMonomials) {
  Random random(300);
  for (int round = 0; round < 1000; ++round) {
    const PowerCurve curve = random_power(random, round % 2 == 0 ? Weights::one : Weights::positive);
    EXPECT_EQ(curve.polynomial(), round % 2 == 0);
    EXPECT_EQ(curve.nurbs().rational(), round % 2 == 1);
    for (const double t : random_parameters(random, curve.domain(), 5)) {
      EXPECT_LE(largest(homogeneous_at(curve.nurbs(), t) - horner(curve, t)), 1e-13 * (100 + size_of(curve.nurbs())));
    }
  }
}

TEST(PowerCurve, OfASpanIsTheSpanAtEveryDegreeUpTo20) {
  Random random(301);
  for (int degree = 1; degree <= 20; ++degree) {
    const BezierCurve bezier = BezierCurve::make(random_points(random, degree + 1, Weights::positive));
    const PowerCurve power = to_power(bezier, 0.5);
    const double lost = std::exp2(degree);
    for (const double t : random_parameters(random, {0, 1}, 9)) {
      const glm::dvec4 difference = homogeneous_at(power.nurbs(), t) - homogeneous_at(bezier.nurbs(), t);
      EXPECT_LE(largest(difference), 1e-15 * lost * size_of(bezier.nurbs())) << degree;
    }
  }
}

TEST(PowerCurve, OfEverySpanKeepsTheParameter) {
  Random random(302);
  for (int round = 0; round < 200; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const std::vector<PowerCurve> powers = to_power(curve);
    ASSERT_EQ(powers.size(), curve.knot_vector().spans().size());
    for (const PowerCurve& power : powers) {
      EXPECT_EQ(power.origin(), power.domain().start);
      const double t = power.domain().middle();
      EXPECT_LE(largest(homogeneous_at(power.nurbs(), t) - homogeneous_at(curve, t)), 1e-11 * size_of(curve));
    }
  }
}

TEST(PowerCurveDerivative, IsTheDerivativeOfTheCurve) {
  Random random(303);
  for (int round = 0; round < 500; ++round) {
    const PowerCurve curve = random_power(random, round % 2 == 0 ? Weights::one : Weights::positive);
    const PowerCurve slope = derivative(curve);
    for (const double t : random_parameters(random, curve.domain(), 3)) {
      glm::dvec3 values[2];
      derivatives(curve.nurbs(), {&t, 1}, 1, std::span(&values[0].x, 6));
      EXPECT_LE(largest(point_at(slope.nurbs(), t) - values[1]), 1e-9) << round;
    }
  }
}

TEST(PowerCurveVerbs, KeepTheCurve) {
  Random random(304);
  for (int round = 0; round < 500; ++round) {
    const PowerCurve curve = random_power(random, Weights::positive);
    const Interval range = curve.domain();
    const double tolerance = 1e-12 * (100 + size_of(curve.nurbs()));
    const auto [before, after] = split(curve, range.middle());
    const PowerCurve moved = with_origin(curve, range.start);
    const PowerCurve back = reversed(curve);
    for (const double s : random_parameters(random, {0, 0.5}, 3)) {
      const double t = range.start + s * range.length();
      const glm::dvec4 point = homogeneous_at(curve.nurbs(), t);
      EXPECT_LE(largest(homogeneous_at(before.nurbs(), t) - point), tolerance);
      EXPECT_LE(largest(homogeneous_at(moved.nurbs(), t) - point), tolerance);
      EXPECT_LE(largest(homogeneous_at(back.nurbs(), range.start + (range.end - t)) - point), tolerance);
    }
    EXPECT_EQ(after.domain(), (Interval{range.middle(), range.end}));
    EXPECT_EQ(back.domain(), range);
  }
}

TEST(PowerCurveMake, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec4> line{{0, 0, 0, 1}, {1, 0, 0, 0}};
  EXPECT_EQ(refusal([&] { PowerCurve::make({{0, 0, 0, 1}}); }), "coefficients has 1 rows, a power curve needs 2 or more");
  EXPECT_EQ(refusal([&] { PowerCurve::make(std::vector<glm::dvec4>(257, line[0])); }), "degree = 256 is outside [0, 255]");
  EXPECT_EQ(refusal([&] { PowerCurve::make({line[0], {0, 0, nan, 0}}); }), "coefficients[1].z = nan is not finite");
  EXPECT_EQ(refusal([&] { PowerCurve::make(line, nan); }), "origin = nan is not finite");
  EXPECT_EQ(refusal([&] { PowerCurve::make(line, 0, {1, 1}); }),
            "domain = (1, 1) is not an interval of positive, finite length");
  EXPECT_EQ(refusal([&] { PowerCurve::make({line[1], line[1]}); }),
            "coefficients: every w is zero, no point of the curve is finite");
  EXPECT_EQ(refusal([&] { PowerCurve::make({line[0], line[1], {1, 0, 0, 0}}, 1e200); }),
            "coefficients overflow on the domain (0, 1) about origin = 1e+200");
}

}  // namespace
}  // namespace splinecore
