#include "shape_box.hpp"

#include <algorithm>
#include <vector>

namespace splinecore {

TreeBox box_in(const NearSpace& space, const BoxedPieces& pieces) {
  constexpr double kEverywhere = 0x1p400;
  const BoxTree& tree = pieces.tree();
  const BoxTree::Group& root = tree.group(tree.levels() - 1, 0);
  std::vector<TreeBox> boxes;
  for (std::size_t i = 0; i < tree.count(tree.levels() - 1); ++i) {
    const glm::dvec3 middle(root.middle[0][i], root.middle[1][i], root.middle[2][i]);
    const glm::dvec3 half(root.half[0][i], root.half[1][i], root.half[2][i]);
    if (std::max({half.x, half.y, half.z}) > kEverywhere) return {glm::dvec3(-kOutOfBoxes), glm::dvec3(kOutOfBoxes)};
    const auto corner = [&](double side) {
      return space.enter(pieces.space().leave(middle + side * half), kOutOfBoxes).at;
    };
    boxes.push_back({corner(-1.0), corner(1.0)});
  }
  const glm::dvec3 slack(16.0 * (space.rounding() + 0x1p-50));
  const TreeBox all = around(boxes);
  return {all.low - slack, all.high + slack};
}

}  // namespace splinecore
