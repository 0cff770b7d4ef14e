#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "kernels/kernels.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Below and above the numbers that are looked at together.
constexpr std::size_t kCounts[] = {1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 32, 33, 64, 65, 100};

TEST(NumberKernels, TheLargestSizeIsFoundAtEveryPlace) {
  for (const std::size_t count : kCounts) {
    std::vector<double> values(count, -0.5);
    EXPECT_EQ(kernels().largest_size(values.data(), count), 0.5);
    for (std::size_t i = 0; i < count; ++i) {
      for (const double value : {-3.0, 5e-324, 1.7e308}) {
        values[i] = value;
        EXPECT_EQ(kernels().largest_size(values.data(), count), count == 1 ? std::abs(value) : std::max(0.5, std::abs(value)));
      }
      for (const double value : {kInfinity, -kInfinity, kNoNumber, -kNoNumber}) {
        values[i] = value;
        EXPECT_FALSE(std::isfinite(kernels().largest_size(values.data(), count))) << i << " of " << count;
      }
      values[i] = -0.5;
    }
  }
  EXPECT_EQ(kernels().largest_size(nullptr, 0), 0.0);
}

TEST(NumberKernels, AStepThatDoesNotRiseIsFoundAtEveryPlace) {
  for (const std::size_t count : kCounts) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(i) - 20.0;
    EXPECT_TRUE(kernels().are_increasing(values.data(), count));
    for (std::size_t i = 1; i < count; ++i) {
      const double kept = values[i];
      for (const double value : {values[i - 1], values[i - 1] - 1.0, kNoNumber}) {
        values[i] = value;
        EXPECT_FALSE(kernels().are_increasing(values.data(), count)) << i << " of " << count;
      }
      values[i] = kept;
    }
  }
}

TEST(NumberKernels, AWeightThatIsNotOneIsFoundAtEveryPlace) {
  for (const std::size_t count : kCounts) {
    std::vector<double> points(4 * count, 7.0);
    for (std::size_t i = 0; i < count; ++i) points[4 * i + 3] = 1.0;
    EXPECT_TRUE(kernels().are_weights_one(points.data(), count));
    for (std::size_t i = 0; i < count; ++i) {
      for (const double weight : {0.0, -1.0, std::nextafter(1.0, 2.0), kNoNumber}) {
        points[4 * i + 3] = weight;
        EXPECT_FALSE(kernels().are_weights_one(points.data(), count)) << i << " of " << count;
      }
      points[4 * i + 3] = 1.0;
    }
  }
}

TEST(NumberKernels, ChordsAreTheDistancesOfNeighbors) {
  testing::Random random(5);
  for (const std::size_t count : {4, 5, 6, 7, 8, 9, 63, 64}) {
    std::vector<glm::dvec3> points(count + 1);
    for (glm::dvec3& point : points) point = testing::random_vector(random, 1.0);
    std::vector<double> found(count);
    EXPECT_TRUE(kernels().chords(&points.front().x, count, 1e-280, 1e300, found.data()));
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(found[i], glm::distance(points[i], points[i + 1]), 4e-16) << i << " of " << count;
    }
    for (std::size_t i = 0; i <= count; ++i) {
      const glm::dvec3 kept = points[i];
      for (const double value : {kNoNumber, kInfinity, 1e160}) {
        points[i].y = value;
        EXPECT_FALSE(kernels().chords(&points.front().x, count, 1e-280, 1e300, found.data())) << i << " of " << count;
      }
      points[i] = i > 0 ? points[i - 1] : points[i + 1];
      EXPECT_FALSE(kernels().chords(&points.front().x, count, 1e-280, 1e300, found.data()));
      points[i] = kept;
    }
  }
}

}  // namespace
}  // namespace splinecore
