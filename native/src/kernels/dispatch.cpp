#include <cstdlib>
#include <string_view>

#include "kernels.hpp"

namespace splinecore {

#pragma GCC visibility push(hidden)
extern const Kernels baseline;
#if defined(__x86_64__)
extern const Kernels x86_64_v3;
#endif
#pragma GCC visibility pop

namespace {

const Kernels& chosen() noexcept {
  const char* named = std::getenv("SPLINECORE_KERNELS");
  const std::string_view name = named == nullptr ? "" : named;
  if (name == "baseline") return baseline;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("x86-64-v3")) return x86_64_v3;
#endif
  return baseline;
}

}  // namespace

const Kernels& kernels() noexcept {
  static const Kernels& found = chosen();
  return found;
}

}  // namespace splinecore
