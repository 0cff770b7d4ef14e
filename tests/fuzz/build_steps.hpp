#pragma once

#include "bytes.hpp"

namespace splinecore::fuzz {

/// Makes one shape of what the bytes say, and looks at it.
using BuildStep = void (*)(Bytes& bytes);

std::span<const BuildStep> shape_builders();
std::span<const BuildStep> conic_builders();

}  // namespace splinecore::fuzz
