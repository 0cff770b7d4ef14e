#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is compared of an item; the second number decides where the first are equal.
struct SortKey {
  double first;
  double second = 0.0;
};

/// The indices of keys from the lowest up, equal ones as they stand.
std::vector<std::size_t> order_of(std::span<const SortKey> keys);

/// Puts items in the order of key(item), a number or a SortKey; equal ones stay as they stand, with any standard library.
template <class Item, class Key>
void sort_by(std::vector<Item>& items, Key key) {
  std::vector<SortKey> keys;
  keys.reserve(items.size());
  for (const Item& item : items) keys.push_back(SortKey{key(item)});
  std::vector<Item> sorted;
  sorted.reserve(items.size());
  for (const std::size_t i : order_of(keys)) sorted.push_back(std::move(items[i]));
  items = std::move(sorted);
}

}  // namespace splinecore
#pragma GCC visibility pop
