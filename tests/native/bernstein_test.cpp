#include "splinecore/basis/bernstein.hpp"

#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "reference.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// B_i^n(t) by the recursion B_i^n = (1 - t) B_i^{n-1} + t B_{i-1}^{n-1}.
std::vector<Real> by_recursion(int degree, Real t) {
  std::vector<Real> values{1.0L};
  for (int n = 1; n <= degree; ++n) {
    values.push_back(0.0L);
    for (int i = n; i >= 0; --i) values[i] = (1.0L - t) * values[i] + (i > 0 ? t * values[i - 1] : 0.0L);
  }
  return values;
}

TEST(Binomial, ObeysPascalsRuleInIntegersWhileTheseFit) {
  for (int n = 1; n <= 56; ++n) {
    for (int k = 1; k < n; ++k) {
      const auto sum =
          static_cast<std::int64_t>(binomial(n - 1, k - 1)) + static_cast<std::int64_t>(binomial(n - 1, k));
      EXPECT_EQ(static_cast<std::int64_t>(binomial(n, k)), sum) << n << " " << k;
    }
  }
}

TEST(Binomial, RowsSumToAPowerOfTwoUpToTheHighestDegree) {
  for (const int n : {1, 17, 33, 60, 128, kMaxDegree, kMaxDegree + 1, 2 * kMaxDegree, 3 * kMaxDegree}) {
    double sum = 0.0;
    for (int k = 0; k <= n; ++k) sum += binomial(n, k);
    EXPECT_NEAR(sum / std::exp2(n), 1.0, 1e-13) << n;
    EXPECT_EQ(binomial(n, 0), 1.0);
    EXPECT_EQ(binomial(n, n), 1.0);
  }
}

TEST(Binomial, IsRefusedOutsideTheTable) {
  for (const auto& [n, k] : {std::pair{-1, 0}, std::pair{3 * kMaxDegree + 1, 3}, std::pair{5, 6}, std::pair{5, -1},
                             std::pair{std::numeric_limits<int>::max(), 1}}) {
    EXPECT_THROW(binomial(n, k), std::out_of_range) << n << " " << k;
  }
  std::vector<double> values(3 * kMaxDegree + 2);
  EXPECT_THROW(bernstein(3 * kMaxDegree + 1, 0.5, 0.5, values), std::out_of_range);
}

TEST(Bernstein, HasSmallRelativeErrorUpToDegree60) {
  Random random(6);
  for (const int degree : {0, 1, 2, 3, 9, 17, 18, 33, 34, 60}) {
    std::vector<double> values(degree + 1);
    for (const double t : random_parameters(random, {0, 1}, 50)) {
      bernstein(degree, t, 1.0 - t, values);
      const std::vector<Real> expected = by_recursion(degree, t);
      for (int i = 0; i <= degree; ++i) {
        EXPECT_NEAR(values[i] / static_cast<double>(expected[i]), 1.0, 1e-13) << degree << " " << i << " " << t;
      }
    }
  }
}

TEST(Bernstein, IsAPartitionOfUnityAtTheHighestDegree) {
  std::vector<double> values(kMaxDegree + 1);
  for (const double t : {0.0, 1e-300, 1e-3, 0.25, 0.5, 0.999, 1.0}) {
    bernstein(kMaxDegree, t, 1.0 - t, values);
    EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 1.0, 1e-13) << t;
    EXPECT_TRUE(std::ranges::all_of(values, [](double value) { return value >= 0.0; })) << t;
  }
}

}  // namespace
}  // namespace splinecore
