#include "meet/box_tree.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace splinecore;

std::vector<Box> row_of_boxes(std::size_t count) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 2.0 * static_cast<double>(i);
    boxes.push_back({glm::dvec3(x, 0, 0), glm::dvec3(x + 1, 1, 1)});
  }
  return boxes;
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
  std::array<double, BoxTree::kGroup> squared;
  tree.group(0, 0).squared_distances(glm::dvec3(2.5, 3, 0.5), squared);
  EXPECT_EQ(squared[0], 2.25 + 4.0);
  EXPECT_EQ(squared[1], 4.0);
  tree.group(0, 1).squared_distances(glm::dvec3(0), squared);
  EXPECT_EQ(squared[0], 256.0);
  EXPECT_GT(squared[2], 1e300);
}

TEST(BoxTree, NoDistanceToAGroupIsAboveOneOfItsBoxes) {
  const BoxTree tree(row_of_boxes(100));
  const glm::dvec3 from(77.3, -2, 5);
  for (std::size_t level = 1; level < tree.levels(); ++level) {
    for (std::size_t i = 0; i < tree.count(level); ++i) {
      std::array<double, BoxTree::kGroup> outer;
      std::array<double, BoxTree::kGroup> inner;
      tree.group(level, i / BoxTree::kGroup).squared_distances(from, outer);
      tree.group(level - 1, i).squared_distances(from, inner);
      for (const double squared : inner) EXPECT_LE(outer[i % BoxTree::kGroup], squared);
    }
  }
}

}  // namespace
