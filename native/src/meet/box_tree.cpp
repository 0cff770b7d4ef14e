#include "box_tree.hpp"

#include <glm/common.hpp>
#include <limits>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

BoxTree::Group group_of(std::span<const TreeBox> boxes) {
  // Widths so large are infinite, and their sums are numbers.
  constexpr double kEverywhere = 0x1p1000;
  constexpr double kFar = 0x1p500;
  BoxTree::Group group;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < BoxTree::kGroup; ++i) {
      const bool is_there = i < boxes.size();
      const double width = is_there ? boxes[i].high[axis] - boxes[i].low[axis] : 0.0;
      const bool is_bounded = width < kEverywhere;
      group.middle[axis][i] = !is_there ? kFar : is_bounded ? boxes[i].low[axis] + 0.5 * width : 0.0;
      group.half[axis][i] = is_bounded ? 0.5 * width : kEverywhere;
    }
  }
  return group;
}

}  // namespace

TreeBox around(std::span<const TreeBox> boxes) {
  TreeBox all{glm::dvec3(kNowhere), glm::dvec3(-kNowhere)};
  for (const TreeBox& box : boxes) all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  return all;
}

BoxTree::BoxTree(std::span<const TreeBox> leaves) : leaves_(leaves.size()) {
  std::vector<TreeBox> boxes(leaves.begin(), leaves.end());
  do {
    std::vector<Group> groups;
    std::vector<TreeBox> outer;
    for (std::size_t i = 0; i < boxes.size(); i += kGroup) {
      const auto some = std::span(boxes).subspan(i, std::min(kGroup, boxes.size() - i));
      breathe(kGroup * kGroup);
      groups.push_back(group_of(some));
      outer.push_back(around(some));
    }
    levels_.push_back(std::move(groups));
    boxes = std::move(outer);
  } while (boxes.size() > 1);
}

}  // namespace splinecore
