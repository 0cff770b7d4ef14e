#include "basis/power.hpp"

#include <gtest/gtest.h>

#include "base/double_double.hpp"

namespace splinecore {
namespace {

TEST(DoubleDouble, KeepsWhatADoubleLoses) {
  const DoubleDouble third = DoubleDouble(1.0) / 3.0;
  EXPECT_EQ((third * 3.0 - 1.0).rounded(), 0.0);
  EXPECT_NEAR((third + third + third - 1.0).rounded(), 0.0, 1e-31);
  EXPECT_EQ((DoubleDouble(1e16) + 1.0 - 1e16).rounded(), 1.0);
  const DoubleDouble square = exact_product(1.0 + 0x1p-30, 1.0 + 0x1p-30);
  EXPECT_EQ(square.low, 0x1p-60);
}

TEST(TaylorShift, ThereAndBackIsTheSameAlsoAfterManyDigitsWereNeeded) {
  const std::vector<glm::dvec4> rows{{1, 2, 3, 1}, {4, 5, 6, 0}, {7, 8, 9, 0}};
  const std::vector<glm::dvec4> moved = taylor_shifted(rows, 1000.0);
  EXPECT_EQ(moved[0], glm::dvec4(7004001, 8005002, 9006003, 1));
  EXPECT_EQ(taylor_shifted(moved, -1000.0), rows);
}

}  // namespace
}  // namespace splinecore
