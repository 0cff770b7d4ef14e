#include "breath.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kStepsBetweenPauses = std::size_t{1} << 24;

struct Breath {
  const Pause* pause = nullptr;
  std::size_t left = kStepsBetweenPauses;
};

thread_local Breath breath;

}  // namespace

Pausing::Pausing(const Pause& pause) : before_(breath.pause) { breath.pause = pause ? &pause : nullptr; }

Pausing::~Pausing() { breath.pause = before_; }

void breathe(std::size_t steps) {
  Breath& mine = breath;
  if (mine.pause == nullptr) return;
  if (steps < mine.left) {
    mine.left -= steps;
    return;
  }
  mine.left = kStepsBetweenPauses;
  const Pause& pause = *mine.pause;
  const Pausing not_meanwhile({});
  pause();
}

const Pause* pause_of_thread() noexcept { return breath.pause; }

}  // namespace splinecore
