#pragma once

#include "splinecore/base/pause.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What long work of this thread does now and then, or nothing.
const Pause* pause_of_thread() noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
