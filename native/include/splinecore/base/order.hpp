#pragma once

namespace splinecore {

/// Highest derivative order that is offered; factorials and binomials stay exact below it.
inline constexpr int kMaxOrder = 64;

/// @throws InvalidShape unless 0 <= order <= kMaxOrder.
void require_order(int order);

}  // namespace splinecore
