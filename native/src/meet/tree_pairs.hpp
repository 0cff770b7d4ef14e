#pragma once

#include <algorithm>
#include <cstddef>

#include "box_tree.hpp"
#include "splinecore/base/pause.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Calls work(i, j) with the leaves of two trees whose boxes are within a distance of each other. Of one tree with itself
/// some pairs i > j are left out.
template <class Work>
class TreePairs {
 public:
  TreePairs(const BoxTree& a, const BoxTree& b, double distance, Work work)
      : a_(a), b_(b), is_one_(&a == &b), slack_(distance + 0x1p-40), work_(work) {}  // middles of boxes are rounded

  void visit() {
    const std::size_t top_a = a_.levels() - 1;
    const std::size_t top_b = b_.levels() - 1;
    for (std::size_t i = 0; i < a_.count(top_a); ++i) {
      for (std::size_t j = 0; j < b_.count(top_b); ++j) nodes({top_a, i}, {top_b, j});
    }
  }

 private:
  struct Node {
    std::size_t level;
    std::size_t i;
  };

  bool are_apart(const Node& a, const Node& b) const {
    const BoxTree::Group& of_a = a_.group(a.level, a.i / BoxTree::kGroup);
    const BoxTree::Group& of_b = b_.group(b.level, b.i / BoxTree::kGroup);
    const std::size_t in_a = a.i % BoxTree::kGroup;
    const std::size_t in_b = b.i % BoxTree::kGroup;
    for (int axis = 0; axis < 3; ++axis) {
      const double apart = of_a.middle[axis][in_a] - of_b.middle[axis][in_b];
      const double reach = of_a.half[axis][in_a] + of_b.half[axis][in_b];
      if (apart - reach > slack_ || -apart - reach > slack_) return true;
    }
    return false;
  }

  template <class Each>
  static void for_children(const BoxTree& tree, const Node& node, Each each) {
    const std::size_t level = node.level - 1;
    const std::size_t end = std::min((node.i + 1) * BoxTree::kGroup, tree.count(level));
    for (std::size_t i = node.i * BoxTree::kGroup; i < end; ++i) each(Node{level, i});
  }

  void nodes(const Node& a, const Node& b) {
    if (is_one_ && a.level == b.level && a.i > b.i) return;
    breathe(32);
    if (are_apart(a, b)) return;
    if (a.level == 0 && b.level == 0) return work_(a.i, b.i);
    if (a.level == b.level) {
      for_children(a_, a, [&](const Node& in_a) { for_children(b_, b, [&](const Node& in_b) { nodes(in_a, in_b); }); });
    } else if (a.level > b.level) {
      for_children(a_, a, [&](const Node& in_a) { nodes(in_a, b); });
    } else {
      for_children(b_, b, [&](const Node& in_b) { nodes(a, in_b); });
    }
  }

  const BoxTree& a_;
  const BoxTree& b_;
  bool is_one_;
  double slack_;
  Work work_;
};

template <class Work>
void for_near_pairs(const BoxTree& a, const BoxTree& b, double distance, Work work) {
  TreePairs<Work>(a, b, distance, work).visit();
}

}  // namespace splinecore
#pragma GCC visibility pop
