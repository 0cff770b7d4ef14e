#include "meet/box_tree.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace splinecore;

std::vector<TreeBox> row_of_boxes(std::size_t count) {
  std::vector<TreeBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 2.0 * static_cast<double>(i);
    boxes.push_back({glm::dvec3(x, 0, 0), glm::dvec3(x + 1, 1, 1)});
  }
  return boxes;
}

std::array<double, BoxTree::kGroup> squares(const BoxTree::Group& group, const glm::dvec3& from) {
  std::array<double, BoxTree::kGroup> found;
  kernels().box_distances(group, &from.x, found.data());
  return found;
}

TEST(BoxTree, HasAsManyLevelsAsGroupsOfEightNeed) {
  EXPECT_EQ(BoxTree(row_of_boxes(1)).levels(), 1U);
  EXPECT_EQ(BoxTree(row_of_boxes(8)).levels(), 1U);
  EXPECT_EQ(BoxTree(row_of_boxes(9)).levels(), 2U);
  EXPECT_EQ(BoxTree(row_of_boxes(65)).levels(), 3U);
  EXPECT_EQ(BoxTree(row_of_boxes(65)).count(1), 9U);
}

TEST(BoxTree, DistancesAreThoseToTheBoxes) {
  const BoxTree tree(row_of_boxes(10));
  const auto squared = squares(tree.group(0, 0), glm::dvec3(2.5, 3, 0.5));
  EXPECT_EQ(squared[0], 2.25 + 4.0);
  EXPECT_EQ(squared[1], 4.0);
  const auto later = squares(tree.group(0, 1), glm::dvec3(0));
  EXPECT_EQ(later[0], 256.0);
  EXPECT_GT(later[2], 1e300);
}

TEST(BoxTree, NoDistanceToAGroupIsAboveOneOfItsBoxes) {
  const BoxTree tree(row_of_boxes(100));
  const glm::dvec3 from(77.3, -2, 5);
  for (std::size_t level = 1; level < tree.levels(); ++level) {
    for (std::size_t i = 0; i < tree.count(level); ++i) {
      const auto outer = squares(tree.group(level, i / BoxTree::kGroup), from);
      for (const double squared : squares(tree.group(level - 1, i), from)) EXPECT_LE(outer[i % BoxTree::kGroup], squared);
    }
  }
}

}  // namespace
