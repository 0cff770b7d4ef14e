#include "splinecore/basis/instruction_set.hpp"

#include "kernels/kernels.hpp"

namespace splinecore {

const char* instruction_set() noexcept { return kernels().name; }

}  // namespace splinecore
