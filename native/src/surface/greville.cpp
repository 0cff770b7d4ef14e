#include "greville.hpp"

#include <algorithm>
#include <cstddef>

namespace splinecore {

std::vector<double> greville_places(const KnotVector& knots) {
  const auto all = knots.unrolled();
  const auto degree = static_cast<std::size_t>(knots.degree());
  const Interval domain = knots.domain();
  std::vector<double> places;
  for (int i = 0; i < knots.count(); ++i) {
    const auto own = all.subspan(static_cast<std::size_t>(i) + 1, degree);
    double sum = 0.0;
    for (const double knot : own) sum += knot / static_cast<double>(degree);
    if (own.front() == own.back()) sum = own.front();
    if (knots.periodic() && sum >= domain.end) sum -= domain.length();
    if (knots.periodic() && sum < domain.start) sum += domain.length();
    places.push_back(std::clamp(sum, domain.start, domain.end));
  }
  std::ranges::sort(places);
  return places;
}

}  // namespace splinecore
