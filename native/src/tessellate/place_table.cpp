#include "splinecore/tessellate/place_table.hpp"

#include <bit>

#include "splinecore/base/pause.hpp"

namespace splinecore {

PlaceTable::PlaceTable(std::size_t count)
    : entries_(std::bit_ceil(2 * count + 64), PlaceEntry{kNone, 0, -1, {-1, -1, -1}}), mask_(entries_.size() - 1) {}

std::pair<PlaceEntry&, bool> PlaceTable::add(Place u, Place v) {
  if (2 * (count_ + 1) > entries_.size()) grow();
  PlaceEntry& entry = entries_[slot_of(u, v)];
  if (entry.u != kNone) return {entry, false};
  ++count_;
  entry.u = u;
  entry.v = v;
  return {entry, true};
}

void PlaceTable::grow() {
  constexpr std::size_t kSteps = 20;
  PlaceTable larger(entries_.size());
  for (const PlaceEntry& entry : entries_) {
    breathe(kSteps);
    if (entry.u != kNone) larger.entries_[larger.slot_of(entry.u, entry.v)] = entry;
  }
  larger.count_ = count_;
  *this = std::move(larger);
}

}  // namespace splinecore
