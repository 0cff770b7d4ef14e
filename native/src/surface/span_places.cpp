#include "span_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace splinecore {

std::vector<double> places_of_spans(std::vector<double> ends, int in_span) {
  std::ranges::sort(ends);
  std::vector<double> places{ends.front()};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double length = ends[i + 1] - ends[i];
    if (!(length > 0.0)) continue;
    for (int k = 1; k < in_span; ++k) {
      places.push_back(ends[i] + length * 0.5 * (1.0 - std::cos(std::numbers::pi * k / in_span)));
    }
    places.push_back(ends[i + 1]);
  }
  return places;
}

}  // namespace splinecore
