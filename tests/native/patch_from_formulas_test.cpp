#include "splinecore/build/patch_from_formulas.hpp"

#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "splinecore/formula/evaluate.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

using Texts = std::array<std::string, 3>;

std::vector<Formula> formulas(const Texts& texts) {
  std::vector<Formula> made;
  for (const std::string& text : texts) made.push_back(Formula::make(text, {"u", "v"}));
  return made;
}

Approximation<NurbsPatch> fit(const Texts& texts, Interval u, Interval v, double tolerance = 1e-6) {
  return patch_from_formulas(formulas(texts), {u, v}, tolerance);
}

/// The largest distance at random parameters.
double distance(const NurbsPatch& patch, const Texts& texts) {
  Random random(78);
  const std::vector<double> u = random_parameters(random, patch.knot_vector(Axis::u).domain(), 5'000);
  const std::vector<double> v = random_parameters(random, patch.knot_vector(Axis::v).domain(), 5'000);
  std::vector<double> points(3 * u.size());
  evaluate(patch, u, v, points);
  std::vector<double> squares(u.size(), 0.0);
  std::vector<double> values(u.size());
  const std::span<const double> places[]{u, v};
  const std::vector<Formula> made = formulas(texts);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    evaluate(made[axis], places, values);
    for (std::size_t i = 0; i < values.size(); ++i) squares[i] += std::pow(points[3 * i + axis] - values[i], 2);
  }
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0, worse));
}

TEST(PatchFromFormulas, OfPolynomialsIsOneExactBezierPatch) {
  const auto [patch, error] = fit({"u", "v", "u^2*v - 3*v^3/2"}, {-1.0, 2.0}, {0.0, 4.0});
  EXPECT_EQ(error, 0.0);
  EXPECT_EQ(patch.knot_vector(Axis::u).degree(), 2);
  EXPECT_EQ(patch.knot_vector(Axis::v).degree(), 3);
  EXPECT_LT(distance(patch, {"u", "v", "u^2*v - 3*v^3/2"}), 1e-13);
  EXPECT_EQ(fit({"1", "2", "3"}, {0.0, 1.0}, {0.0, 1.0}).value.points().size(), 4U);
  const Texts far{"u", "v", "(u - 1000)^9*(v + 1000)^8"};
  EXPECT_LT(distance(fit(far, {999.0, 1001.0}, {-1001.0, -999.0}).value, far), 2e-12);
}

TEST(PatchFromFormulas, LiesWithinTheToleranceAtItsOwnParameters) {
  constexpr double pi = std::numbers::pi;
  const struct {
    Texts texts;
    Interval u;
    Interval v;
  } cases[]{
      {{"(3 + cos(v))*cos(u)", "(3 + cos(v))*sin(u)", "sin(v)"}, {0.0, 2 * pi}, {0.0, 2 * pi}},
      {{"cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)"}, {0.0, 2 * pi}, {-pi / 2, pi / 2}},
      {{"u", "v", "sin(u)*exp(v)"}, {-3.0, 3.0}, {-1.0, 1.0}},
      {{"u", "v", "1/(1 + 4*u^2 + 9*v^2)"}, {-1.0, 1.0}, {-1.0, 1.0}},
      {{"u", "v", "sqrt(u) + v"}, {0.0, 1.0}, {0.0, 2.0}},
      {{"u", "v*1000", "sin(20*u)"}, {0.0, 1.0}, {0.0, 1.0}},
  };
  for (const auto& [texts, u, v] : cases) {
    for (const double tolerance : {1e-2, 1e-5}) {
      const auto [patch, error] = fit(texts, u, v, tolerance);
      EXPECT_LE(error, tolerance) << texts[2];
      EXPECT_EQ(patch.knot_vector(Axis::u).domain(), u);
      EXPECT_LE(distance(patch, texts), std::min(tolerance, 1.2 * error + 1e-9)) << texts[2] << " " << tolerance;
    }
  }
}

TEST(PatchFromFormulas, HasTheMixedDerivativesOfTheFormulasAtItsJoints) {
  const NurbsPatch patch = fit({"u", "v", "sin(2*u)*cos(3*v)"}, {0.0, 2.0}, {0.0, 1.0}).value;
  const double u = patch.knot_vector(Axis::u).knots()[6];
  const double v = patch.knot_vector(Axis::v).knots()[6];
  std::vector<double> found(27);
  derivatives(patch, {&u, 1}, {&v, 1}, 2, found);
  for (int k = 0; k <= 2; ++k) {
    for (int l = 0; l <= 2; ++l) {
      const double wanted = std::pow(2.0, k) * std::sin(2.0 * u + 0.5 * k * std::numbers::pi) * std::pow(3.0, l) *
                            std::cos(3.0 * v + 0.5 * l * std::numbers::pi);
      EXPECT_NEAR(found[3 * (3 * k + l) + 2], wanted, 1e-8) << k << " " << l;
    }
  }
}

TEST(PatchFromFormulas, RefinesOnlyTheDirectionThatNeedsIt) {
  const NurbsPatch patch = fit({"u", "v", "sin(40*u) + v"}, {0.0, 1.0}, {0.0, 1.0}).value;
  EXPECT_GT(patch.knot_vector(Axis::u).spans().size(), 20U);
  EXPECT_EQ(patch.knot_vector(Axis::v).spans().size(), 1U);
}

TEST(PatchFromFormulas, RefusesWhatItCannotFollow) {
  EXPECT_EQ(refusal([] { fit({"u", "v", "1/(u*v)"}, {0.0, 1.0}, {0.0, 1.0}); }),
            "the formula '1/(u*v)' has no finite value at u = 0, v = 0");
  EXPECT_THROW(fit({"u", "v", "sign(u - 0.3)"}, {0.0, 1.0}, {0.0, 1.0}), ToleranceNotReached);
  EXPECT_THROW(fit({"u", "v", "abs(u - v)"}, {0.0, 1.0}, {0.0, 1.0}), ToleranceNotReached);
}

TEST(PatchFromFormulas, RefusesBadArguments) {
  const Texts flat{"u", "v", "0"};
  EXPECT_EQ(refusal([&] { fit(flat, {0.0, 0.0}, {0.0, 1.0}); }), "domain_u = [0, 0] does not increase");
  EXPECT_EQ(refusal([&] { fit(flat, {0.0, 1.0}, {0.0, NAN}); }), "domain_v = [0, nan] is not finite");
  EXPECT_EQ(refusal([&] { fit(flat, {0.0, 1.0}, {0.0, 1.0}, -1.0); }), "tolerance = -1 is not a positive length");
  const std::vector<Formula> two(2, Formula::make("u", {"u", "v"}));
  EXPECT_EQ(refusal([&] { patch_from_formulas(two, {}, 1.0); }), "formulas has 2 of them, x, y and z are expected");
  const std::vector<Formula> curves(3, Formula::make("u", {"u"}));
  EXPECT_EQ(refusal([&] { patch_from_formulas(curves, {}, 1.0); }), "formulas[0] has 1 variables, a patch has two");
}

}  // namespace
}  // namespace splinecore
