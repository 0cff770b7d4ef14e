#include "base/sort_by.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace splinecore {

std::vector<std::size_t> order_of(std::span<const SortKey> keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return std::tie(keys[a].first, keys[a].second, a) < std::tie(keys[b].first, keys[b].second, b);
  });
  return order;
}

}  // namespace splinecore
