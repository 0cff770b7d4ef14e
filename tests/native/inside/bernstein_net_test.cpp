#include "basis/bernstein_net.hpp"

#include "base/one_sign.hpp"
#include "curve/bezier_piece.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

BernsteinNet<double> random_net(Random& random, std::size_t rows, std::size_t columns) {
  BernsteinNet<double> net{rows, columns, {}};
  for (std::size_t k = 0; k < rows * columns; ++k) net.values.push_back(real(random, -1, 1));
  return net;
}

/// By the sum of Bernstein polynomials.
double value(const BernsteinNet<double>& net, double u, double v) {
  std::vector<double> along_u(net.rows);
  std::vector<double> along_v(net.columns);
  bernstein(net.degree(Axis::u), u, 1.0 - u, along_u);
  bernstein(net.degree(Axis::v), v, 1.0 - v, along_v);
  double sum = 0.0;
  for (std::size_t i = 0; i < net.rows; ++i) {
    for (std::size_t j = 0; j < net.columns; ++j) sum += along_u[i] * along_v[j] * net.at(i, j);
  }
  return sum;
}

TEST(BernsteinNet, PartsOfACutAreThePiece) {
  Random random(41);
  for (int round = 0; round < 100; ++round) {
    const auto whole = random_net(random, 1 + round % 6, 2 + round % 5);
    const double u = real(random, 0, 1);
    const double v = real(random, 0, 1);
    const double t = real(random, 0, 1);
    for (const Axis axis : {Axis::u, Axis::v}) {
      auto before = whole;
      BernsteinNet<double> after;
      before.cut(axis, t, after);
      const bool is_u = axis == Axis::u;
      EXPECT_NEAR(value(before, u, v), is_u ? value(whole, t * u, v) : value(whole, u, t * v), 1e-14);
      EXPECT_NEAR(value(after, u, v), is_u ? value(whole, t + (1 - t) * u, v) : value(whole, u, t + (1 - t) * v), 1e-14);
      auto first = whole;
      BernsteinNet<double> second = random_net(random, 7, 7);
      first.halve(axis, second);
      EXPECT_EQ(second.values.size(), whole.values.size());
      EXPECT_NEAR(value(second, u, v), is_u ? value(whole, 0.5 + 0.5 * u, v) : value(whole, u, 0.5 + 0.5 * v), 1e-14);
    }
  }
}

TEST(BernsteinNet, DerivativeIsTheSlope) {
  Random random(42);
  const auto whole = random_net(random, 4, 6);
  constexpr double kStep = 1e-6;
  const double along_u = value(whole, 0.3 + kStep, 0.6) - value(whole, 0.3 - kStep, 0.6);
  EXPECT_NEAR(value(whole.derivative(Axis::u), 0.3, 0.6), along_u / (2 * kStep), 1e-8);
  const double along_v = value(whole, 0.3, 0.6 + kStep) - value(whole, 0.3, 0.6 - kStep);
  EXPECT_NEAR(value(whole.derivative(Axis::v), 0.3, 0.6), along_v / (2 * kStep), 1e-8);
  EXPECT_EQ(whole.derivative(Axis::u).degree(Axis::u), 2);
}

TEST(BernsteinNet, RangeHoldsTheValues) {
  Random random(43);
  const auto whole = random_net(random, 3, 4);
  const auto [low, high] = whole.range();
  for (int k = 0; k <= 100; ++k) {
    const double at = value(whole, 0.01 * k, 1.0 - 0.01 * k);
    EXPECT_TRUE(at >= low - 1e-15 && at <= high + 1e-15);
  }
}

TEST(Cut, PartsAreTheCurve) {
  Random random(502);
  for (int round = 0; round < 200; ++round) {
    const BezierCurve curve = BezierCurve::make(random_points(random, integer(random, 2, 10), Weights::any));
    auto before = bezier_piece(curve.nurbs(), 0);
    BernsteinNet<glm::dvec4> after;
    const double u = real(random, 0, 1);
    before.cut(Axis::u, u, after);
    EXPECT_EQ(before.values.back(), after.values.front());
    const glm::dvec4 given = homogeneous_at(curve.nurbs(), 0.5 * u);
    const glm::dvec4 expected = std::ldexp(1.0, -curve.nurbs().weight_exponent()) * given;
    before.halve(Axis::u, after);
    EXPECT_LE(largest(before.values.back() - expected), 1e-14 * size_of(curve.nurbs()));
  }
}

TEST(OneSign, IsToldApartFromNoise) {
  const std::vector<double> values{1e-3, 1.0, 2.0};
  EXPECT_TRUE(has_one_sign(values));
  EXPECT_FALSE(has_one_sign(values, {}, 1e-2));
  EXPECT_TRUE(has_one_sign(values, [](double v) { return -v; }));
  EXPECT_FALSE(has_one_sign(std::vector<double>{-1.0, 1.0}));
}

}  // namespace
}  // namespace splinecore
