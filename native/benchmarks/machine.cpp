// What one core of this machine can do at most: vectors of four doubles and memory.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

using Four = double __attribute__((vector_size(32)));

constexpr int kLanes = 4;
constexpr int kChains = 12;

double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The best of some tries, in seconds a step.
template <class Work>
double seconds(long steps, Work work) {
  double best = 1e9;
  for (int attempt = 0; attempt < 15; ++attempt) {
    const double start = now();
    work();
    best = std::min(best, now() - start);
  }
  return best / static_cast<double>(steps);
}

#define MULTIPLY_ADDS(chains, x, y) \
  for (Four & sum : chains) sum = sum * (x) + (y)

#define DIVISIONS(chains, x) \
  for (Four & value : chains) value = value / (x)

constexpr long kSteps = 2'000'000;

/// Different values, or one chain would do for all.
void spread(Four* chains, const Four& value) {
  for (int i = 0; i < kChains; ++i) chains[i] = value + i;
}

#ifdef __x86_64__
__attribute__((target("avx2,fma"), optimize("unroll-loops")))
#endif
void multiply_adds(Four* result) {
  Four chains[kChains];
  spread(chains, *result);
  const Four x = *result;
  const Four y = *result * 0.5;
  for (long i = 0; i < kSteps; ++i) MULTIPLY_ADDS(chains, x, y);
  for (const Four& sum : chains) *result += sum;
}

#ifdef __x86_64__
__attribute__((target("avx2,fma"), optimize("unroll-loops")))
#endif
void divisions(Four* result) {
  Four chains[kChains];
  spread(chains, *result);
  const Four x = *result * 0 + 1.0000001;
  for (long i = 0; i < kSteps / 10; ++i) DIVISIONS(chains, x);
  for (const Four& value : chains) *result += value;
}

void write_memory(std::vector<Four>& memory, const Four& value) {
  for (Four& place : memory) place = value;
}

}  // namespace

int main() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") == 0 || __builtin_cpu_supports("fma") == 0) {
    std::fprintf(stderr, "this machine has no vectors of four doubles\n");
    return 1;
  }
#endif
  volatile double seed = 0.25;
  Four sink = {seed, seed, seed, seed};
  const double fma = seconds(kSteps * kChains, [&] { multiply_adds(&sink); });
  sink = Four{seed, seed, seed, seed};
  const double division = seconds(kSteps / 10 * kChains, [&] { divisions(&sink); });
  std::vector<Four> memory(24'000'000 / sizeof(Four));
  write_memory(memory, sink);
  const double byte = seconds(24'000'000, [&] { write_memory(memory, sink); });
  volatile double used = sink[0] + memory[memory.size() / 2][kLanes - 1];
  static_cast<void>(used);
  std::printf(R"({"operation_ns": %.4g, "division_ns": %.4g, "byte_ns": %.4g})" "\n", fma * 1e9, division * 1e9,
              byte * 1e9);
}
