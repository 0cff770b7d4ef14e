#pragma once

namespace splinecore {

/// A direction of a patch.
enum class Axis { u = 0, v = 1 };

}  // namespace splinecore
