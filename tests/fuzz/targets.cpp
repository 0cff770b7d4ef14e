#include "targets.hpp"

#include "splinecore/base/pause.hpp"

namespace splinecore::fuzz {

namespace {

/// A pause comes every 2^24 steps.
constexpr int kMostPauses = 2;

struct EnoughWork {};

}  // namespace

void run_for_a_while(void (*target)(Input data), Input data) {
  int pauses = 0;
  const Pause pause = [&] {
    if (++pauses > kMostPauses) throw EnoughWork();
  };
  const Pausing pausing(pause);
  try {
    target(data);
  } catch (const EnoughWork&) {
  }
}

}  // namespace splinecore::fuzz
