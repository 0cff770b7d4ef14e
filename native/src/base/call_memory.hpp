#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Memory for what a call needs while it runs, given back at its end all at once. A thread keeps it for its next call, so
/// that a loop of calls that need no more asks for none. Of calls within calls each has its own.
class CallMemory {
 public:
  CallMemory();
  ~CallMemory();
  CallMemory(const CallMemory&) = delete;
  CallMemory& operator=(const CallMemory&) = delete;

  /// For one thread. What is given back to it is taken again by the next call only.
  std::pmr::memory_resource* resource() noexcept { return &taken_; }

  struct Block {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t size = 0;
  };

 private:
  /// What the block has no room for, and how much that is.
  class Missing : public std::pmr::memory_resource {
   public:
    std::size_t size() const noexcept { return size_; }

   private:
    void* do_allocate(std::size_t size, std::size_t alignment) override {
      size_ += size + alignment;
      return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override {
      std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    std::size_t size_ = 0;
  };

  Block block_;
  Missing missing_;
  std::pmr::monotonic_buffer_resource taken_;
};

}  // namespace splinecore
#pragma GCC visibility pop
