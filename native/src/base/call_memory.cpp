#include "call_memory.hpp"

#include <array>
#include <new>
#include <utility>

namespace splinecore {

namespace {

/// More than that a thread does not keep.
constexpr std::size_t kMostKept = std::size_t{1} << 24;

/// Blocks of calls that are over, the last one on top.
struct KeptBlocks {
  std::array<CallMemory::Block, 4> blocks;
  std::size_t count = 0;

  CallMemory::Block take() noexcept { return count == 0 ? CallMemory::Block{} : std::move(blocks[--count]); }
  void put(CallMemory::Block block) noexcept {
    if (count < blocks.size()) blocks[count++] = std::move(block);
  }
};

KeptBlocks& kept_blocks() {
  thread_local KeptBlocks kept;
  return kept;
}

}  // namespace

CallMemory::CallMemory() : block_(kept_blocks().take()), taken_(block_.bytes.get(), block_.size, &missing_) {}

CallMemory::~CallMemory() {
  taken_.release();
  const std::size_t needed = block_.size + missing_.size();
  if (needed > kMostKept) return;
  if (missing_.size() > 0) {
    block_.bytes.reset(new (std::nothrow) std::byte[needed]);
    block_.size = block_.bytes != nullptr ? needed : 0;
  }
  kept_blocks().put(std::move(block_));
}

}  // namespace splinecore
