#pragma once

#include <cstddef>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws InvalidShape unless there is none, or one positive, finite weight for each of `count` points.
void require_weights(std::span<const double> weights, std::size_t count);

/// @throws InvalidShape unless it is finite, and 0 or more.
void require_smoothing(double smoothing);

/// What control points do not reach alone, in a sentence.
const char* and_smoothing(bool is_smoothed) noexcept;

/// That shapes were near the points and were not taken, for they leave them in between; in a sentence.
const char* without_swings(bool is_swinging) noexcept;

/// @throws InvalidShape unless it is from 0 to 1000.
void require_corrections(int corrections);

}  // namespace splinecore
#pragma GCC visibility pop
