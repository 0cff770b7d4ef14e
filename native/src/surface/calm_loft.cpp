#include "calm_loft.hpp"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "span_places.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

std::vector<double> places_across(const KnotVector& knots, int in_span) {
  const Interval domain = knots.domain();
  std::vector<double> ends{domain.start, domain.end};
  for (const double knot : knots.knots()) {
    if (knot > domain.start && knot < domain.end) ends.push_back(knot);
  }
  return places_of_spans(std::move(ends), in_span);
}

/// The largest distance of its places from the middle of both sides, by that of the sides.
double reach_of(const NurbsPatch& loft) {
  const std::vector<double> u = places_across(loft.knot_vector(Axis::u), 6);
  const std::vector<double> v = places_across(loft.knot_vector(Axis::v), 16);
  std::vector<glm::dvec3> points(u.size() * v.size());
  evaluate_grid(loft, u, v, std::span(&points[0].x, 3 * points.size()), {.at_infinity = AtInfinity::nan});
  const auto first = [&](std::size_t i) { return points[i * v.size()]; };
  const auto last = [&](std::size_t i) { return points[(i + 1) * v.size() - 1]; };
  glm::dvec3 middle(0.0);
  for (std::size_t i = 0; i < u.size(); ++i) middle += (first(i) + last(i)) / (2.0 * static_cast<double>(u.size()));
  double of_sides = 0.0;
  double of_all = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    of_sides = std::max({of_sides, distance_of(first(i), middle), distance_of(last(i), middle)});
  }
  for (const glm::dvec3& point : points) of_all = std::max(of_all, distance_of(point, middle));
  return of_all / of_sides;
}

/// Those of the loft's neighbors that it goes on from by more than their sides.
std::vector<LoftNeighbor*> followed(LoftOptions& options) {
  std::vector<LoftNeighbor*> found;
  for (LoftEnd* const end : {&options.start, &options.end}) {
    if (end->neighbor && end->neighbor->continuity > 0) found.push_back(&*end->neighbor);
  }
  return found;
}

/// How far a loft may reach, by how far its sides do: as a few of those that go on with tangent planes alone.
double most_reach(LoftOptions options, const MadeLoft& make) {
  constexpr double kMost = 3.0;
  for (LoftNeighbor* const one : followed(options)) one->continuity = 1;
  return kMost * std::max(1.0, reach_of(make(options).value));
}

}  // namespace

LoftSurface calm_loft(LoftOptions options, const MadeLoft& make) {
  const int halvings = options.is_calm ? 8 : 0;
  const auto told = [](Approximation<NurbsPatch> made, double part) {
    return LoftSurface{std::move(made.value), made.error, part};
  };
  const std::vector<LoftNeighbor*> neighbors = followed(options);
  if (neighbors.empty()) return told(make(options), 1.0);
  const bool are_bent = std::ranges::any_of(neighbors, [](const LoftNeighbor* one) { return one->continuity > 1; });
  std::exception_ptr refusal;
  std::optional<double> most;
  double reach = 0.0;
  for (int i = 0; i <= halvings; ++i) {
    try {
      Approximation<NurbsPatch> made = make(options);
      if (!are_bent) return told(std::move(made), std::ldexp(1.0, -i));
      if (!most) most = most_reach(options, make);
      reach = reach_of(made.value);
      if (reach <= *most) return told(std::move(made), std::ldexp(1.0, -i));
    } catch (const InvalidShape&) {
      if (!refusal) refusal = std::current_exception();
    }
    for (LoftNeighbor* const one : neighbors) one->strength *= 0.5;
  }
  if (refusal) std::rethrow_exception(refusal);
  throw InvalidShape("a neighbor bends so sharply at a side that its continuation would shoot out, " + text_of(reach) +
                     " times as far as the sides reach: a lower continuity has less of that");
}

}  // namespace splinecore
