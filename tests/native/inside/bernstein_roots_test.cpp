#include "basis/bernstein_roots.hpp"

#include <algorithm>
#include <cmath>

#include "splinecore/basis/bernstein.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Bernstein coefficients of the product of (t - root).
std::vector<double> with_roots(const std::vector<double>& roots) {
  std::vector<double> product{1.0};
  for (const double root : roots) {
    const auto degree = static_cast<double>(product.size());
    std::vector<double> next(product.size() + 1);
    for (std::size_t i = 0; i < product.size(); ++i) {
      const auto k = static_cast<double>(i);
      next[i] += -root * product[i] * (degree - k) / degree;
      next[i + 1] += (1.0 - root) * product[i] * (k + 1.0) / degree;
    }
    product = std::move(next);
  }
  return product;
}

double noise_of(const std::vector<double>& coefficients) {
  double largest = 0.0;
  for (const double c : coefficients) largest = std::max(largest, std::abs(c));
  return 0x1p-50 * largest;
}

TEST(BernsteinRoots, AllSimpleRootsAreFoundAndNoOthers) {
  Random random(71);
  for (int round = 0; round < 500; ++round) {
    std::vector<double> roots;
    for (int i = 0; i < 1 + round % 6; ++i) roots.push_back(real(random, -1.0, 2.0));
    std::ranges::sort(roots);
    const auto is_near = [](double a, double b) { return b - a < 0.01; };
    if (std::ranges::adjacent_find(roots, is_near) != roots.end()) continue;
    const auto found = bernstein_zeros(with_roots(roots), noise_of(with_roots(roots)));
    std::erase_if(roots, [](double root) { return root < 0.0 || root > 1.0; });
    ASSERT_EQ(found.size(), roots.size()) << round;
    for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(found[i].start, roots[i], 1e-9);
  }
}

TEST(BernsteinRoots, RootsAtTheEndsAreTheEnds) {
  const auto found = bernstein_zeros(with_roots({0.0, 0.5, 1.0}), 1e-16);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].start, 0.0);
  EXPECT_EQ(found[1].start, 0.5);
  EXPECT_EQ(found[2].end, 1.0);
}

TEST(BernsteinRoots, MultipleRootsAreOne) {
  for (const int times : {2, 3, 4}) {
    for (const double root : {0.0, 0.25, 1.0 / 3.0, 0.9, 1.0}) {
      const auto coefficients = with_roots(std::vector<double>(times, root));
      const auto found = bernstein_zeros(coefficients, noise_of(coefficients));
      ASSERT_EQ(found.size(), 1u) << times << " " << root;
      EXPECT_EQ(found[0].length(), 0.0);
      EXPECT_NEAR(found[0].start, root, std::pow(2e-15, 1.0 / times));
    }
  }
}

TEST(BernsteinRoots, NothingButNoiseIsZeroEverywhere) {
  const std::vector<double> noise{1e-17, -2e-17, 0.0};
  EXPECT_EQ(bernstein_zeros(noise, 1e-16), (std::vector<Interval>{{0.0, 1.0}}));
  EXPECT_EQ(bernstein_zeros(std::vector<double>{0.0}, 0.0), (std::vector<Interval>{{0.0, 1.0}}));
  EXPECT_TRUE(bernstein_zeros(std::vector<double>{3.0}, 0.0).empty());
}

TEST(BernsteinRoots, AValueIsTheSumOfTheFunctions) {
  Random random(72);
  for (int degree = 0; degree < 12; ++degree) {
    std::vector<double> coefficients;
    for (int i = 0; i <= degree; ++i) coefficients.push_back(real(random, -1, 1));
    std::vector<double> functions(degree + 1);
    const double t = real(random, 0, 1);
    bernstein(degree, t, 1.0 - t, functions);
    double sum = 0.0;
    for (int i = 0; i <= degree; ++i) sum += functions[i] * coefficients[i];
    EXPECT_NEAR(bernstein_value(coefficients, t), sum, 1e-14);
  }
}

}  // namespace
}  // namespace splinecore
