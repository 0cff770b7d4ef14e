#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "kernels/kernels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What lies between two corners, which may be infinitely far.
struct TreeBox {
  glm::dvec3 low;
  glm::dvec3 high;
};

/// The box of all of them.
TreeBox around(std::span<const TreeBox> boxes);

/// Boxes in groups of eight, groups in groups of eight, up to one: flat arrays, coordinate by coordinate, so that the
/// boxes of a group are looked at together. Neighbors in the order given share groups.
class BoxTree {
 public:
  static constexpr std::size_t kGroup = kBoxGroup;
  using Group = BoxGroup;  ///< boxes that are missing at the end of a level lie far away

  explicit BoxTree(std::span<const TreeBox> leaves);

  /// Level 0 has the leaves; group i of a level is box i of the next. The last level is one group.
  std::size_t levels() const noexcept { return levels_.size(); }
  const Group& group(std::size_t level, std::size_t i) const noexcept { return levels_[level][i]; }

  /// How many boxes are in all groups of a level.
  std::size_t count(std::size_t level) const noexcept { return level == 0 ? leaves_ : levels_[level - 1].size(); }

 private:
  std::size_t leaves_;
  std::vector<std::vector<Group>> levels_;
};

}  // namespace splinecore
#pragma GCC visibility pop
