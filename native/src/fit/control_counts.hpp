#pragma once

#include <cstddef>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How few control points a spline of this degree can have.
/// @throws InvalidShape if there is none of this degree.
std::size_t least_count(int degree, bool is_periodic);

/// @throws InvalidShape if so many control points are fewer than the degree needs.
void require_count(std::size_t count, int degree, bool is_periodic);

/// @throws InvalidShape if so many are fewer than those that the ends hold.
void require_room_for_ends(std::size_t count, std::size_t held);

/// @throws InvalidShape if so many points are fewer than the control points that the degree needs.
void require_enough_points(std::size_t points, int degree, bool is_periodic);

}  // namespace splinecore
#pragma GCC visibility pop
