#include "support.hpp"

#include <limits>

namespace splinecore {
namespace {

using namespace testing;

TEST(Support, NoBoundHoldsForAnErrorThatIsNoNumber) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 error(1.0, -2.0, 0.5);
    error[axis] = kNone;
    EXPECT_FALSE(largest(error) <= kInfinity) << axis;
    error[axis] = -kInfinity;
    EXPECT_EQ(largest(error), kInfinity) << axis;
  }
  EXPECT_EQ(largest(glm::dvec3(1.0, -2.0, 0.5)), 2.0);
  EXPECT_EQ(worse(1.0, 2.0), 2.0);
  EXPECT_FALSE(worse(kNone, 2.0) <= kInfinity);
  EXPECT_FALSE(worse(2.0, kNone) <= kInfinity);
}

}  // namespace
}  // namespace splinecore
