#include "splinecore/build/curve_from_formulas.hpp"

#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "splinecore/formula/evaluate.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

std::vector<Formula> formulas(const std::vector<std::string>& texts) {
  std::vector<Formula> made;
  for (const std::string& text : texts) made.push_back(Formula::make(text, {"t"}));
  return made;
}

Approximation<NurbsCurve> fit(const std::vector<std::string>& texts, Interval domain, double tolerance = 1e-6) {
  return curve_from_formulas(formulas(texts), domain, tolerance);
}

/// The largest distance at random parameters.
double distance(const NurbsCurve& curve, const std::vector<std::string>& texts) {
  Random random(77);
  const std::vector<double> parameters = random_parameters(random, curve.domain(), 20'000);
  std::vector<double> points(3 * parameters.size());
  evaluate(curve, parameters, points);
  std::vector<double> squares(parameters.size(), 0.0);
  std::vector<double> values(parameters.size());
  const std::vector<Formula> made = formulas(texts);
  for (std::size_t axis = 0; axis < made.size(); ++axis) {
    evaluate(made[axis], parameters, values);
    for (std::size_t i = 0; i < values.size(); ++i) squares[i] += std::pow(points[3 * i + axis] - values[i], 2);
  }
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0, worse));
}

TEST(CurveFromFormulas, OfPolynomialsIsOneExactSpan) {
  const auto cubic = fit({"t", "t^2", "t^3"}, {0.0, 1.0});
  EXPECT_EQ(cubic.error, 0.0);
  EXPECT_EQ(cubic.value.degree(), 3);
  const double third = 1.0 / 3.0;
  const std::vector<glm::dvec3> wanted{{0, 0, 0}, {third, 0, 0}, {2 * third, third, 0}, {1, 1, 1}};
  for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(glm::dvec3(cubic.value.points()[i]), wanted[i]), 1e-16) << i;
  EXPECT_EQ(fit({"t", "(t + 1)^2 - t^2"}, {-1.0, 2.0}).value.degree(), 1);
  EXPECT_EQ(fit({"1", "2"}, {0.0, 1.0}).value.degree(), 1);
  const auto high = fit({"t", "(t - 1000)^60"}, {999.0, 1001.0});
  EXPECT_EQ(high.value.degree(), 60);
  EXPECT_NEAR(point_at(high.value, 1000.9).y, std::pow(1000.9 - 1000.0, 60), 1e-14);
}

TEST(CurveFromFormulas, LiesWithinTheToleranceAtItsOwnParameter) {
  const struct {
    std::vector<std::string> texts;
    Interval domain;
  } cases[]{
      {{"cos(t)", "sin(t)", "t/5"}, {0.0, 40.0 * std::numbers::pi}},
      {{"t", "sqrt(t)"}, {0.0, 1.0}},
      {{"t", "sqrt(1 - t^2)"}, {-1.0, 1.0}},
      {{"t", "asin(t)", "acos(t)"}, {-1.0, 1.0}},
      {{"t", "1/(1 + 25*t^2)"}, {-1.0, 1.0}},
      {{"t", "exp(t)"}, {-4.0, 4.0}},
      {{"t", "abs(t - 0.3)", "max(t, t^2)"}, {-1.0, 2.0}},
      {{"t", "cbrt(t)"}, {-1.0, 1.0}},
      {{"t", "t^0.1"}, {0.0, 2.0}},
      {{"t", "exp(-1e6*(t - 0.37)^2)"}, {0.0, 1.0}},
      {{"t", "sin(32*pi*t)^4"}, {0.0, 1.0}},
      {{"t", "sin(1/t)"}, {0.01, 1.0}},
      {{"t - 1e6", "sin(t)"}, {1e6, 1e6 + 10.0}},
  };
  for (const auto& [texts, domain] : cases) {
    for (const double tolerance : {1e-2, 1e-6, 1e-7}) {
      const auto [curve, error] = fit(texts, domain, tolerance);
      EXPECT_LE(error, tolerance) << texts[1];
      EXPECT_EQ(curve.domain(), domain);
      EXPECT_LE(distance(curve, texts), std::min(tolerance, 1.1 * error + 1e-9)) << texts[1] << " " << tolerance;
    }
  }
}

TEST(CurveFromFormulas, HasTwoContinuousDerivativesThoseOfTheFormulasAtItsJoints) {
  const NurbsCurve curve = fit({"cos(t)", "sin(t)", "t/5"}, {0.0, 20.0}, 1e-9).value;
  const auto knots = curve.knot_vector().knots();
  double last = -1.0;
  for (const double u : knots) {
    if (u == last) continue;
    last = u;
    for (const Side side : {Side::left, Side::right}) {
      std::vector<double> found(9);
      derivatives(curve, {&u, 1}, 2, found, {.side = side});
      EXPECT_NEAR(found[3], -std::sin(u), 1e-11);
      EXPECT_NEAR(found[5], 0.2, 1e-11);
      EXPECT_NEAR(found[7], -std::sin(u), 1e-9);
    }
  }
}

TEST(CurveFromFormulas, KeepsAKinkThatLiesOnAJoint) {
  const auto [curve, error] = fit({"t", "abs(t)"}, {-1.0, 1.0});
  EXPECT_LT(error, 1e-14);
  EXPECT_EQ(curve.knot_vector().spans().size(), 2U);
  EXPECT_NEAR(point_at(curve, -1e-9).y, 1e-9, 1e-24);
}

TEST(CurveFromFormulas, RefusesPolesJumpsAndUndefinedValues) {
  EXPECT_EQ(refusal([] { fit({"t", "1/t"}, {-1.0, 1.0}); }), "the formula '1/t' has no finite value at t = 0");
  EXPECT_EQ(refusal([] { fit({"t", "log(t)"}, {0.0, 1.0}); }), "the formula 'log(t)' has no finite value at t = 0");
  for (const std::string text : {"1/(t - 0.3)", "tan(5*t)", "sign(t)", "sign(t - 0.3)", "floor(3*t)",
                                 "t*sin(1/(t + 2e-30))"}) {
    EXPECT_THROW(fit({"t", text}, {-1.0, 1.0}), ToleranceNotReached) << text;
  }
  EXPECT_THROW(fit({"cos(t)", "sin(t)"}, {0.0, 6.0}, 1e-17), ToleranceNotReached);
}

TEST(CurveFromFormulas, RefusesBadArguments) {
  EXPECT_EQ(refusal([] { fit({"t"}, {0.0, 1.0}); }), "formulas has 1 of them, x and y or x, y and z are expected");
  EXPECT_EQ(refusal([] { fit({"t", "t"}, {1.0, 0.0}); }), "domain = [1, 0] does not increase");
  EXPECT_EQ(refusal([] { fit({"t", "t"}, {0.0, HUGE_VAL}); }), "domain = [0, inf] is not finite");
  EXPECT_EQ(refusal([] { fit({"t", "t"}, {0.0, 1.0}, 0.0); }), "tolerance = 0 is not a positive length");
  const std::vector<Formula> two{Formula::make("u", {"u", "v"}), Formula::make("u", {"u"})};
  EXPECT_EQ(refusal([&] { curve_from_formulas(two, {0.0, 1.0}, 1.0); }),
            "formulas[0] has 2 variables, a curve has one");
}

}  // namespace
}  // namespace splinecore
