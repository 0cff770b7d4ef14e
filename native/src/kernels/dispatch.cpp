#include <array>
#include <cstdlib>
#include <span>
#include <string_view>

#include "kernels.hpp"

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
  __builtin_cpu_init();
  const bool has_v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool has_v4 = has_v3 && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  return std::span(kSets).subspan(has_v4 ? 0 : has_v3 ? 1 : 2);
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
