#pragma once

#pragma GCC visibility push(hidden)
namespace splinecore {

// How much of a number may be rounding, in parts of what it was computed from, by what is done on the way. What asks for less
// decides by noise; what asks for more loses digits that are there.

/// A few operations: a product of two numbers, a length.
inline constexpr double kRoundingOfStep = 0x1p-50;

/// Sums of some ten terms: a value of a piece, an inner product, a box.
inline constexpr double kRoundingOfSum = 0x1p-48;

/// Control points that were split, elevated or moved a few times.
inline constexpr double kRoundingOfShape = 0x1p-46;

/// Parameters and points that an iteration found.
inline constexpr double kRoundingOfPlace = 0x1p-40;

/// Places where two roots are nearly one, which have half of the digits.
inline constexpr double kRoundingOfTouch = 0x1p-30;

}  // namespace splinecore
#pragma GCC visibility pop
