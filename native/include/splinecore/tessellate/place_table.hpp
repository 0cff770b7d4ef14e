#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "splinecore/tessellate/mesh_spans.hpp"

namespace splinecore {

/// What is known of a vertex.
struct PlaceEntry {
  Place u = 0;
  Place v = 0;
  std::int32_t number = -1;                   ///< that the mesh gives it
  std::array<std::int32_t, 3> cells{-1, -1, -1};  ///< that have it as the corner (u0, v0), (u0, v1), (u1, v0)
};

/// Vertices by their places: a hash table with open addresses.
class PlaceTable {
 public:
  /// @param count  that it has room for before it grows
  explicit PlaceTable(std::size_t count);

  /// The entry of a place, or nothing.
  const PlaceEntry* find(Place u, Place v) const {
    const PlaceEntry& entry = entries_[slot_of(u, v)];
    return entry.u == kNone ? nullptr : &entry;
  }
  PlaceEntry* find(Place u, Place v) {
    PlaceEntry& entry = entries_[slot_of(u, v)];
    return entry.u == kNone ? nullptr : &entry;
  }

  /// The entry of a place, and whether it is new; good until the next one is added.
  std::pair<PlaceEntry&, bool> add(Place u, Place v);

 private:
  static constexpr Place kNone = -1;

  /// Where the place is, or would be.
  std::size_t slot_of(Place u, Place v) const {
    std::uint64_t mixed = static_cast<std::uint64_t>(u) * 0x9e3779b97f4a7c15u;
    mixed = (mixed ^ (mixed >> 32)) + static_cast<std::uint64_t>(v) * 0xc2b2ae3d27d4eb4fu;
    mixed = (mixed ^ (mixed >> 29)) * 0xff51afd7ed558ccdu;
    std::size_t slot = (mixed >> 32) & mask_;
    while (entries_[slot].u != kNone && (entries_[slot].u != u || entries_[slot].v != v)) slot = (slot + 1) & mask_;
    return slot;
  }
  void grow();

  std::vector<PlaceEntry> entries_;
  std::size_t mask_ = 0;
  std::size_t count_ = 0;
};

}  // namespace splinecore
