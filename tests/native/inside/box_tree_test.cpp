#include "meet/box_tree.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
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

TEST(TurnedBoxes, DistancesAreThoseAlongTheirOwnDirections) {
  TurnedBoxGroup group{};
  const double root = std::sqrt(0.5);
  for (std::size_t i = 0; i < kBoxGroup; ++i) {
    const std::array<glm::dvec3, 3> axes{glm::dvec3(root, root, 0), glm::dvec3(-root, root, 0), glm::dvec3(0, 0, 1)};
    for (int axis = 0; axis < 3; ++axis) {
      for (int c = 0; c < 3; ++c) group.axes[axis][c][i] = axes[axis][c];
      group.half[axis][i] = 1.0 + axis;
    }
    group.center[0][i] = static_cast<double>(i);
  }
  std::array<double, kBoxGroup> found;
  const glm::dvec3 beyond = 3.0 * glm::dvec3(root, root, 0) + glm::dvec3(0, 0, 5);
  kernels().turned_box_distances(group, &beyond.x, found.data());
  EXPECT_NEAR(found[0], 2.0 * 2.0 + 2.0 * 2.0, 1e-14);
  EXPECT_NEAR(found[1], std::pow(2.0 - root, 2) + 4.0, 1e-14);
  const glm::dvec3 inside(7.5, 0.5, -2.9);
  kernels().turned_box_distances(group, &inside.x, found.data());
  EXPECT_EQ(found[7], 0.0);
  EXPECT_GT(found[0], 4.0);
}

}  // namespace
