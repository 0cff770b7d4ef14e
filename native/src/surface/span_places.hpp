#pragma once

#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Places that lie closer towards the ends of every span, as Chebyshev's, and the ends.
/// @param ends  of spans, in any order and as often as they come
std::vector<double> places_of_spans(std::vector<double> ends, int in_span);

}  // namespace splinecore
#pragma GCC visibility pop
