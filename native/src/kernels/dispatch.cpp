#include <array>
#include <cstdlib>
#include <span>
#include <string_view>

#include "kernels.hpp"
#include "processor.hpp"

namespace splinecore {

#pragma GCC visibility push(hidden)
extern const Kernels baseline;
#if defined(__x86_64__)
extern const Kernels x86_64_v3;
extern const Kernels x86_64_v4;
#endif
#pragma GCC visibility pop

namespace {

/// The sets that this machine can run, the best first.
std::span<const Kernels* const> usable() noexcept {
#if defined(__x86_64__)
  static constexpr std::array<const Kernels*, 3> kSets{&x86_64_v4, &x86_64_v3, &baseline};
  const int level = x86_64_level();
  return std::span(kSets).subspan(level == 4 ? 0 : level == 3 ? 1 : 2);
#else
  static constexpr std::array<const Kernels*, 1> kSets{&baseline};
  return kSets;
#endif
}

const Kernels& chosen() noexcept {
  const char* named = std::getenv("SPLINECORE_KERNELS");
  for (const Kernels* set : usable()) {
    if (named == nullptr || std::string_view(set->name) == named) return *set;
  }
  return *usable().front();
}

}  // namespace

const Kernels& kernels() noexcept {
  static const Kernels& found = chosen();
  return found;
}

}  // namespace splinecore
