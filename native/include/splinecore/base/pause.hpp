#pragma once

#include <cstddef>
#include <functional>

namespace splinecore {

/// What long work does now and then; what it throws ends the work.
using Pause = std::function<void()>;

/// As long as it lives, long work of its thread pauses so: with an empty function not at all.
class Pausing {
 public:
  explicit Pausing(const Pause& pause);
  ~Pausing();
  Pausing(const Pausing&) = delete;
  Pausing& operator=(const Pausing&) = delete;

 private:
  const Pause* before_;
};

/// Called between steps of work, never while a lock is held: pauses at intervals of about 20 ms.
/// @param steps  how many multiplications or the like were done, or lie ahead
void breathe(std::size_t steps);

}  // namespace splinecore
