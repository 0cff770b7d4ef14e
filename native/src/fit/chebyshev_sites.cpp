#include "chebyshev_sites.hpp"

#include <algorithm>
#include <glm/vec3.hpp>
#include <span>

#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/interpolate.hpp"

namespace splinecore {

namespace {

std::vector<double> even_clamped_knots(int degree, std::size_t count) {
  const auto spans = count - static_cast<std::size_t>(degree);
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  for (std::size_t i = 0; i <= spans; ++i) knots.push_back(static_cast<double>(i));
  knots.insert(knots.end(), static_cast<std::size_t>(degree), static_cast<double>(spans));
  return knots;
}

/// The knot averages (Greville's abscissae).
std::vector<double> knot_averages(int degree, std::span<const double> knots) {
  std::vector<double> found;
  const auto width = static_cast<std::size_t>(degree);
  for (std::size_t i = 0; i + width + 1 < knots.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 1; k <= width; ++k) sum += knots[i + k];
    found.push_back(sum / degree);
  }
  return found;
}

/// Each inner place to the top between its neighbors of the spline that alternates at the places (Remez 1934).
std::vector<double> at_tops(int degree, const std::vector<double>& knots, const std::vector<double>& places) {
  constexpr int kBetween = 80;
  std::vector<glm::dvec3> signs;
  for (std::size_t i = 0; i < places.size(); ++i) signs.emplace_back(i % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0);
  InterpolationOptions options;
  options.degree = degree;
  options.knots = knots;
  const NurbsCurve curve = interpolate(signs, places, options).value;
  std::vector<double> moved = places;
  std::vector<double> tried(kBetween + 1);
  std::vector<glm::dvec3> values(tried.size());
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const double width = places[i + 1] - places[i - 1];
    for (int k = 0; k <= kBetween; ++k) tried[k] = std::min(places[i - 1] + width * k / kBetween, places[i + 1]);
    evaluate(curve, tried, {&values.front().x, 3 * values.size()});
    const auto top = std::ranges::max_element(values, {}, [&](const glm::dvec3& v) { return v.x * signs[i].x; });
    moved[i] = tried[static_cast<std::size_t>(top - values.begin())];
  }
  return moved;
}

/// The same from both ends.
std::vector<double> symmetric(std::vector<double> places) {
  const double length = places.back();
  const std::vector<double> before = places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = 0.5 * (before[i] + (length - before[before.size() - 1 - i]));
  }
  return places;
}

}  // namespace

ChebyshevSites chebyshev_sites(int degree, std::size_t count, double length) {
  constexpr int kRounds = 6;
  // Farther from the ends the tops of even splines are at the averages of their knots.
  const std::size_t few = std::min(count, 4 * static_cast<std::size_t>(degree));
  const std::vector<double> few_knots = even_clamped_knots(degree, few);
  std::vector<double> ends = knot_averages(degree, few_knots);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<double> moved = at_tops(degree, few_knots, ends);
    if (std::ranges::adjacent_find(moved, std::greater_equal{}) != moved.end()) break;
    ends = moved;
  }
  ends = symmetric(std::move(ends));
  ChebyshevSites made{even_clamped_knots(degree, count), {}};
  made.parameters = knot_averages(degree, made.knots);
  const double last = made.knots.back();
  for (std::size_t i = 0; i < (few + 1) / 2; ++i) {
    made.parameters[i] = ends[i];
    made.parameters[count - 1 - i] = last - ends[i];
  }
  const double scale = length / last;
  for (double& knot : made.knots) knot *= scale;
  for (double& parameter : made.parameters) parameter *= scale;
  made.parameters.front() = made.knots.front();
  made.parameters.back() = made.knots.back();
  return made;
}

}  // namespace splinecore
