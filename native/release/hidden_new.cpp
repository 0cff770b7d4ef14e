// What the C++ runtime in a module for Macs would else show to all of a process: its own new and delete.
#include <cstdlib>
#include <new>

#define HIDDEN __attribute__((visibility("hidden")))

namespace {

void* taken(std::size_t size) {
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void* taken(std::size_t size, std::align_val_t alignment) {
  void* memory = nullptr;
  const auto at_least = static_cast<std::size_t>(alignment) < sizeof(void*) ? sizeof(void*) : static_cast<std::size_t>(alignment);
  if (posix_memalign(&memory, at_least, size == 0 ? 1 : size) == 0) return memory;
  throw std::bad_alloc();
}

}  // namespace

HIDDEN void* operator new(std::size_t size) { return taken(size); }
HIDDEN void* operator new[](std::size_t size) { return taken(size); }
HIDDEN void* operator new(std::size_t size, std::align_val_t alignment) { return taken(size, alignment); }
HIDDEN void* operator new[](std::size_t size, std::align_val_t alignment) { return taken(size, alignment); }
HIDDEN void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size == 0 ? 1 : size); }
HIDDEN void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size == 0 ? 1 : size); }
HIDDEN void operator delete(void* memory) noexcept { std::free(memory); }
HIDDEN void operator delete[](void* memory) noexcept { std::free(memory); }
HIDDEN void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
HIDDEN void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
HIDDEN void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
HIDDEN void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
HIDDEN void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
HIDDEN void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
