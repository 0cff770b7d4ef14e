#pragma once

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The level of x86-64, 1, 3 or 4, that this processor and the system have (System V ABI, x86-64 supplement). Asked of the
/// processor itself: not every compiler's runtime can.
int x86_64_level() noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
