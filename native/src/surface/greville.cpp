#include "greville.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "splinecore/basis/greville.hpp"

namespace splinecore {

std::vector<double> greville_places(const KnotVector& knots) {
  const Interval domain = knots.domain();
  std::vector<double> places = greville_abscissae(knots);
  for (double& place : places) {
    if (knots.periodic() && place >= domain.end) place -= domain.length();
    if (knots.periodic() && place < domain.start) place += domain.length();
    place = std::clamp(place, domain.start, domain.end);
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
