#pragma once

#include <utility>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The best after all removals that are allowed: `remove(value, times)` gives the next best, or nothing where so many
/// may not go at once. First 1, then 2, 4, … as long as that works.
template <class Best, class Remove>
Best removed_as_often_as_can_be(Best best, Remove remove) {
  bool is_growing = true;
  for (int times = 1; times > 0; times = is_growing ? 2 * times : times / 2) {
    auto next = remove(best.value, times);
    if (next) best = std::move(*next);
    is_growing = is_growing && next;
  }
  return best;
}

}  // namespace splinecore
#pragma GCC visibility pop
