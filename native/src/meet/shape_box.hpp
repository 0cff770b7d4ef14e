#pragma once

#include "boxed_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Points farther out than that, in a space that several shapes share, are drawn nearer.
inline constexpr double kOutOfBoxes = 0x1p500;

/// The box of a shape in a space that it shares with others.
TreeBox box_in(const NearSpace& space, const BoxedPieces& pieces);

}  // namespace splinecore
#pragma GCC visibility pop
