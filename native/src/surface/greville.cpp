#include "greville.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

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

std::vector<double> interpolation_places(const KnotVector& knots) {
  std::vector<double> places = greville_places(knots);
  const Interval domain = knots.domain();
  if (knots.spans().size() > 1 || places.size() < 2 || places.front() != domain.start || places.back() != domain.end) return places;
  const auto count = static_cast<double>(places.size());
  const double outermost = std::cos(0.5 * std::numbers::pi / count);
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    const double zero = std::cos((static_cast<double>(k) + 0.5) * std::numbers::pi / count) / outermost;
    places[k] = domain.start + 0.5 * (1.0 - zero) * domain.length();
  }
  return places;
}

std::vector<double> interpolation_places_between_slopes(const KnotVector& knots) {
  std::vector<double> places = interpolation_places(knots);
  places.erase(places.end() - 2);
  places.erase(places.begin() + 1);
  return places;
}

}  // namespace splinecore
