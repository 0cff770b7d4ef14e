#include "splinecore/meet/stationary.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "splinecore/base/errors.hpp"

namespace {

using namespace splinecore;

TEST(Stationary, OnALineAreTheFootAndTheEnds) {
  const auto line = NurbsCurve::make(1, {0, 0, 2, 2}, {{0, 0, 0, 1}, {2, 0, 0, 1}});
  const auto found = stationary_points(line, {0.5, 3, 0});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].kind, Stationary::maximum);
  EXPECT_DOUBLE_EQ(found[1].parameter, 0.5);
  EXPECT_DOUBLE_EQ(found[1].distance, 3.0);
  EXPECT_EQ(found[1].kind, Stationary::minimum);
  EXPECT_EQ(found[2].parameter, 2.0);
}

TEST(Stationary, OnASquareAreTheFootAndTheCorners) {
  const auto square = NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1),
                                       {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}});
  const auto found = stationary_points(square, {0.25, 0.5, 2});
  ASSERT_EQ(found.size(), 5U);
  EXPECT_DOUBLE_EQ(found[2].u, 0.25);
  EXPECT_DOUBLE_EQ(found[2].v, 0.5);
  EXPECT_DOUBLE_EQ(found[2].distance, 2.0);
  EXPECT_EQ(nearest_all(square, {0.25, 0.5, 2}).size(), 1U);
}

TEST(Stationary, APointThatIsNoneAndAToleranceBelowZeroAreRefused) {
  const auto line = NurbsCurve::make(1, {0, 0, 2, 2}, {{0, 0, 0, 1}, {2, 0, 0, 1}});
  EXPECT_THROW(stationary_points(line, {0, std::numeric_limits<double>::quiet_NaN(), 0}), InvalidShape);
  EXPECT_THROW(nearest_all(line, {0, 0, 0}, -1.0), InvalidShape);
}

}  // namespace
