#include "processor.hpp"

#if defined(__x86_64__)

#include <cpuid.h>

namespace splinecore {

namespace {

struct Features {
  unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
};

/// None where the processor does not know the question.
Features features(unsigned leaf) noexcept {
  Features found;
  __get_cpuid_count(leaf, 0, &found.eax, &found.ebx, &found.ecx, &found.edx);
  return found;
}

/// Which registers the system keeps for each thread.
unsigned kept_registers() noexcept {
  unsigned low = 0;
  unsigned high = 0;
  __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

bool has_all(unsigned word, unsigned bits) noexcept { return (word & bits) == bits; }

}  // namespace

int x86_64_level() noexcept {
  constexpr unsigned kFma = 1U << 12, kMovbe = 1U << 22, kOsXsave = 1U << 27, kAvx = 1U << 28, kF16c = 1U << 29;
  constexpr unsigned kBmi = 1U << 3, kAvx2 = 1U << 5, kBmi2 = 1U << 8;
  constexpr unsigned kAvx512 = 1U << 16 | 1U << 17 | 1U << 28 | 1U << 30 | 1U << 31;  // F, DQ, CD, BW, VL
  constexpr unsigned kLzcnt = 1U << 5;
  constexpr unsigned kOfAvx = 0x6, kOfAvx512 = 0xe6;
  const Features base = features(1);
  const Features more = features(7);
  const bool has_v3 = has_all(base.ecx, kFma | kMovbe | kOsXsave | kAvx | kF16c) && has_all(more.ebx, kBmi | kAvx2 | kBmi2) &&
                      has_all(features(0x80000001).ecx, kLzcnt) && has_all(kept_registers(), kOfAvx);
  if (!has_v3) return 1;
  return has_all(more.ebx, kAvx512) && has_all(kept_registers(), kOfAvx512) ? 4 : 3;
}

}  // namespace splinecore

#endif
