#include <gtest/gtest.h>

#include "basis/refinement.hpp"

namespace splinecore {
namespace {

TEST(MissingInside, AreTheInnerKnotsThatAnotherVectorHasMoreOf) {
  const KnotVector own = KnotVector::make(2, {0, 0, 0, 1, 1, 3, 5, 5, 5});
  const KnotVector other = KnotVector::make(2, {-2, -1, 0, 1, 2, 2, 3, 3, 5, 6, 7});
  EXPECT_EQ(missing_inside(own, other), (std::vector<double>{2, 2, 3}));
  EXPECT_EQ(missing_inside(other, own), (std::vector<double>{1}));
  EXPECT_TRUE(missing_inside(own, own).empty());
}

}  // namespace
}  // namespace splinecore
