#pragma once

namespace splinecore {

/// The set of instructions that evaluation uses here: "baseline", "x86-64-v3" or "x86-64-v4". It is the best that the
/// processor has, or the one that the environment variable SPLINECORE_KERNELS names, if it has that. Results differ by
/// some ulp at most.
const char* instruction_set() noexcept;

}  // namespace splinecore
