#include "splinecore/build/polynomial.hpp"

#include <limits>
#include <numbers>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> random_steps(Random& random, int count) {
  std::vector<double> parameters{real(random, -3, 3)};
  while (static_cast<int>(parameters.size()) < count) parameters.push_back(parameters.back() + real(random, 0.5, 1.5));
  return parameters;
}

std::vector<glm::dvec3> derivatives_at(const NurbsCurve& curve, double u, int order, Side side) {
  std::vector<glm::dvec3> values(order + 1);
  derivatives(curve, {&u, 1}, order, std::span(&values[0].x, 3 * values.size()), {.side = side});
  return values;
}

// Through (0, 0), (1, 1), (2, 8), (3, 27) goes t^3 alone.
TEST(PolynomialThrough, PointsOfACubicIsTheCubic) {
  const std::vector<glm::dvec3> points{{0, 0, 1}, {1, 1, 1}, {2, 8, 1}, {3, 27, 1}};
  const NurbsCurve curve = polynomial_through(points, {0, 1, 2, 3});
  EXPECT_EQ(curve.degree(), 3);
  EXPECT_EQ(curve.domain(), (Interval{0, 3}));
  const glm::dvec4 expected[]{{0, 0, 1, 1}, {1, 0, 1, 1}, {2, 0, 1, 1}, {3, 27, 1, 1}};
  for (int i = 0; i < 4; ++i) EXPECT_LE(largest(curve.points()[i] - expected[i]), 1e-15) << i;
}

TEST(PolynomialThrough, PassesThroughItsPoints) {
  Random random(310);
  for (int count = 2; count <= 15; ++count) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < count; ++i) points.push_back(random_vector(random));
    const std::vector<double> parameters = random_steps(random, count);
    const NurbsCurve curve = polynomial_through(points, parameters);
    EXPECT_EQ(curve.degree(), count - 1);
    for (int i = 0; i < count; ++i) {
      EXPECT_LE(largest(point_at(curve, parameters[i]) - points[i]), 1e-12 * std::max(10.0, size_of(curve))) << count;
    }
    EXPECT_EQ(glm::dvec3(curve.points().front()), points.front());
    EXPECT_EQ(glm::dvec3(curve.points().back()), points.back());
  }
}

TEST(PolynomialThrough, HundredPointsAtChebyshevsParametersIsRungesFunction) {
  const auto runge = [](double x) { return 1 / (1 + 25 * x * x); };
  std::vector<glm::dvec3> points;
  std::vector<double> parameters;
  for (int i = 0; i <= 100; ++i) {
    parameters.push_back(-std::cos(std::numbers::pi * i / 100));
    points.emplace_back(parameters[i], runge(parameters[i]), 0);
  }
  const NurbsCurve curve = polynomial_through(points, parameters);
  EXPECT_GT(curve.knot_vector().spans().size(), 1u);
  std::vector<double> at;
  for (int i = 0; i <= 500; ++i) at.push_back(-1 + i / 250.0);
  std::vector<glm::dvec3> direct(at.size());
  lagrange_evaluate(points, parameters, at, direct);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const glm::dvec3 point = point_at(curve, at[i]);
    EXPECT_LE(largest(point - direct[i]), 1e-13);
    EXPECT_NEAR(point.y, runge(at[i]), 3e-9);
  }
  for (std::size_t i = 0; i <= 100; ++i) EXPECT_LE(largest(point_at(curve, parameters[i]) - points[i]), 2e-14);
}

TEST(PolynomialThrough, EqualStepsOscillatesAsRungeFound) {
  for (const int degree : {10, 20, 40}) {
    std::vector<glm::dvec3> points;
    std::vector<double> parameters;
    for (int i = 0; i <= degree; ++i) {
      parameters.push_back(-1 + 2.0 * i / degree);
      points.emplace_back(parameters[i], 1 / (1 + 25 * parameters[i] * parameters[i]), 0);
    }
    const NurbsCurve curve = polynomial_through(points, parameters);
    double peak = 0;
    for (int i = 0; i <= 1000; ++i) peak = worse(peak, std::abs(point_at(curve, -1 + i / 500.0).y));
    EXPECT_GT(peak, degree == 10 ? 1.9 : degree == 20 ? 50 : 1e4);
    for (int i = 0; i <= degree; ++i) EXPECT_LE(largest(point_at(curve, parameters[i]) - points[i]), 1e-14 * (100 + peak));
  }
}

TEST(LagrangeEvaluate, AtAParameterOfAPointIsThePoint) {
  Random random(311);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 200; ++i) points.push_back(random_vector(random));
  const std::vector<double> parameters = random_steps(random, 200);
  std::vector<glm::dvec3> out(200);
  lagrange_evaluate(points, parameters, parameters, out);
  EXPECT_EQ(out, points);
}

TEST(OsculatingPolynomial, OfTwoPointsWithTangentsIsHermitesCubic) {
  const std::vector<Osculation> data{{0, {{1, 2, 3}, {3, 0, 0}}}, {1, {{4, 0, 1}, {0, 6, 3}}}};
  const NurbsCurve curve = osculating_polynomial(data);
  const glm::dvec4 expected[]{{1, 2, 3, 1}, {2, 2, 3, 1}, {4, -2, 0, 1}, {4, 0, 1, 1}};
  for (int i = 0; i < 4; ++i) EXPECT_LE(largest(curve.points()[i] - expected[i]), 1e-15) << i;
}

TEST(OsculatingPolynomial, HasAllDerivativesThatWereGiven) {
  Random random(312);
  for (int round = 0; round < 200; ++round) {
    const int count = integer(random, 2, 4);
    const std::vector<double> parameters = random_steps(random, count);
    std::vector<Osculation> data;
    for (const double u : parameters) {
      data.push_back({u, {}});
      for (int k = integer(random, 1, 4); k > 0; --k) data.back().derivatives.push_back(random_vector(random));
    }
    const NurbsCurve curve = osculating_polynomial(data);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const int order = static_cast<int>(data[i].derivatives.size()) - 1;
      const Side side = i == 0 ? Side::right : Side::left;
      const std::vector<glm::dvec3> values = derivatives_at(curve, data[i].parameter, order, side);
      for (int k = 0; k <= order; ++k) {
        EXPECT_LE(largest(values[k] - data[i].derivatives[k]), 1e-10 * std::pow(20, k) * size_of(curve)) << k;
      }
    }
  }
}

TEST(OsculatingPolynomial, OfMuchDataAtTwoParametersJoinsSmoothly) {
  // Steps of a smooth transition: all derivatives vanish but for the ends themselves.
  std::vector<Osculation> data{{0, std::vector<glm::dvec3>(10)}, {1, std::vector<glm::dvec3>(10)}};
  data[1].derivatives[0] = {1, 0, 0};
  const NurbsCurve curve = osculating_polynomial(data);
  EXPECT_EQ(curve.degree(), 19);
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(curve.points()[i].x, i < 10 ? 0 : 1, 1e-14);
}

TEST(PolynomialThrough, NamesWhatIsWrong) {
  const std::vector<glm::dvec3> line{{0, 0, 0}, {1, 0, 0}};
  const auto refused = [](std::vector<glm::dvec3> points, std::vector<double> parameters) {
    return refusal([&] { polynomial_through(points, parameters); });
  };
  EXPECT_EQ(refused({}, {}), "points has 0 rows, 2 or more are needed");
  EXPECT_EQ(refused({{0, 0, 0}}, {}), "points has 1 rows, 2 or more are needed");
  EXPECT_EQ(refused(line, {1, 1}), "parameters[1] = 1 does not increase from 1");
  EXPECT_EQ(refused(line, {1, 0}), "parameters[1] = 0 does not increase from 1");
  EXPECT_EQ(refused(line, {0, kNan}), "parameters[1] = nan is not finite");
  EXPECT_EQ(refused(line, {0, 1, 2}), "parameters has 3 values for 2 points");
  EXPECT_EQ(refused(line, {-1e308, 1e308}),
            "parameters from -1e+308 to 1e+308 overflow: their distance is not a finite number");
  EXPECT_EQ(refused({{0, 0, 0}, {0, kNan, 0}}, {}), "points[1].y = nan is not finite");
  EXPECT_EQ(refused(std::vector<glm::dvec3>(257), {}),
            "degree = 256 is above 255: a polynomial has one degree less than it has points and derivatives");
  EXPECT_EQ(refused({{0, 0, 0}, {1e300, 0, 0}, {0, 0, 0}, {-1e300, 0, 0}}, {0, 1e-200, 2e-200, 1}),
            "the points of the polynomial overflow");
  std::vector<glm::dvec3> out(1);
  const double outside = 1.5;
  EXPECT_EQ(refusal([&] { lagrange_evaluate(line, {}, {&outside, 1}, out); }), "u[0] = 1.5 is outside [0, 1]");
  EXPECT_EQ(refusal([&] { lagrange_evaluate(line, {}, {&kNan, 1}, out); }), "u[0] = nan is outside [0, 1]");
  EXPECT_EQ(refusal([&] { osculating_polynomial({}); }), "parameters has 0 values, 2 or more are needed");
  const std::vector<Osculation> empty{{0, {{0, 0, 0}}}, {1, {}}};
  EXPECT_EQ(refusal([&] { osculating_polynomial(empty); }), "data[1] is empty: it needs a point");
}

}  // namespace
}  // namespace splinecore
