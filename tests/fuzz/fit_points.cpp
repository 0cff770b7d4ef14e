#include <algorithm>

#include "finding.hpp"
#include "fit_steps.hpp"
#include "looks.hpp"
#include "shapes.hpp"
#include "splinecore/fit/approximate.hpp"
#include "splinecore/fit/approximate_patch.hpp"
#include "splinecore/fit/project.hpp"

namespace splinecore::fuzz {

namespace {

constexpr int kMostDegree = 30;

Closing closing(Bytes& bytes) { return bytes.flag() ? Closing::closed : Closing::open; }

template <class Shape>
void look(const Approximation<Shape>& made) {
  look_at_points(made.value);
  demand_error(made.error, "what is near points");
}

template <class Shape>
void look_within(const Approximation<Shape>& made, double tolerance) {
  look(made);
  demand(made.error <= tolerance, "a tolerance is not kept");
}

/// What the parameters of points are: of a word, or from the bytes.
std::vector<double> places(Bytes& bytes, std::span<const glm::dvec3> points, Closing how) {
  const std::size_t more = how == Closing::closed ? 1 : 0;
  if (bytes.integer(0, 3) == 0) return increasing(bytes, points.size() + more);
  return parameters_of(points, static_cast<Parameterization>(bytes.integer(0, 2)), how);
}

ApproximationOptions options(Bytes& bytes, std::size_t count) {
  ApproximationOptions made;
  if (bytes.integer(0, 3) == 0) made.weights = numbers(bytes, count);
  made.fixed_ends = bytes.flag();
  if (bytes.integer(0, 3) == 0) made.start = vectors(bytes, bytes.integer(0, 3));
  if (bytes.integer(0, 3) == 0) made.end = vectors(bytes, bytes.integer(0, 3));
  if (bytes.integer(0, 2) == 0) made.smoothing = bytes.number();
  made.corrections = bytes.integer(0, 4) - 1;
  return made;
}

NearDirection direction(Bytes& bytes, std::size_t points) {
  NearDirection made;
  made.degree = degree(bytes, kMostDegree);
  made.closing = closing(bytes);
  made.parameters = increasing(bytes, points + (made.closing == Closing::closed ? 1 : 0));
  made.count = static_cast<std::size_t>(bytes.integer(0, 14));
  if (bytes.integer(0, 5) == 0) made.knots = increasing(bytes, bytes.integer(0, 20));
  if (bytes.integer(0, 2) == 0) made.smoothing = bytes.number();
  return made;
}

ScatteredOptions scattered(Bytes& bytes, std::size_t count) {
  ScatteredOptions made;
  if (bytes.integer(0, 3) == 0) made.weights = numbers(bytes, count);
  if (bytes.flag()) made.smoothing = bytes.tolerance();
  made.corrections = bytes.integer(0, 9) - 1;
  return made;
}

NetSize size(Bytes& bytes) {
  NetSize made{degree(bytes, kMostDegree), degree(bytes, kMostDegree)};
  made.count_u = static_cast<std::size_t>(bytes.integer(0, 12));
  made.count_v = static_cast<std::size_t>(bytes.integer(0, 12));
  return made;
}

std::vector<glm::dvec2> pairs(Bytes& bytes, std::size_t count) {
  std::vector<glm::dvec2> made(bytes.flag() ? count : 0);
  for (glm::dvec2& one : made) one = {bytes.number(), bytes.number()};
  return made;
}

constexpr FitStep kPointFits[] = {
    [](Bytes& bytes) {
      const auto points = vectors(bytes, bytes.integer(0, 40));
      const Closing how = closing(bytes);
      const auto at = places(bytes, points, how);
      const ApproximationOptions chosen = options(bytes, points.size());
      const int of = degree(bytes, kMostDegree);
      look(approximate(points, at, of, static_cast<std::size_t>(bytes.integer(0, 40)), how, chosen));
    },
    [](Bytes& bytes) {
      const auto points = vectors(bytes, bytes.integer(0, 40));
      const Closing how = closing(bytes);
      const auto at = places(bytes, points, how);
      const ApproximationOptions chosen = options(bytes, points.size());
      const int of = degree(bytes, kMostDegree);
      const double tolerance = bytes.tolerance();
      look_within(approximate_within(points, at, of, how, tolerance, static_cast<std::size_t>(bytes.integer(0, 60)), chosen),
                  tolerance);
    },
    [](Bytes& bytes) {
      const auto points = vectors(bytes, bytes.integer(0, 40));
      const KnotVector on = knots(bytes, kMostDegree);
      auto at = parameters(bytes, on.domain(), points.size());
      std::ranges::sort(at);
      look(approximate(points, at, on, options(bytes, points.size())));
    },
    [](Bytes& bytes) {
      const auto u = static_cast<std::size_t>(bytes.integer(0, 9));
      const auto v = static_cast<std::size_t>(bytes.integer(0, 9));
      const auto points = vectors(bytes, u * v);
      const NearDirection along_u = direction(bytes, u);
      const NearDirection along_v = direction(bytes, v);
      look(approximate({points, u, v}, along_u, along_v, bytes.flag()));
    },
    [](Bytes& bytes) {
      const auto u = static_cast<std::size_t>(bytes.integer(0, 9));
      const auto v = static_cast<std::size_t>(bytes.integer(0, 9));
      const auto points = vectors(bytes, u * v);
      const NearDirection along_u = direction(bytes, u);
      const NearDirection along_v = direction(bytes, v);
      const double tolerance = bytes.tolerance();
      look_within(approximate_within({points, u, v}, along_u, along_v, tolerance, bytes.flag()), tolerance);
    },
    [](Bytes& bytes) {
      const auto points = vectors(bytes, bytes.integer(0, 40));
      const auto at = pairs(bytes, points.size());
      const ScatteredOptions chosen = scattered(bytes, points.size());
      look(approximate(points, at, size(bytes), chosen));
    },
    [](Bytes& bytes) {
      const auto points = vectors(bytes, bytes.integer(0, 40));
      const auto at = pairs(bytes, points.size());
      const ScatteredOptions chosen = scattered(bytes, points.size());
      const double tolerance = bytes.tolerance();
      look_within(approximate_within(points, at, size(bytes), tolerance, chosen), tolerance);
    },
    [](Bytes& bytes) {
      const auto points = vectors(bytes, bytes.integer(0, 30));
      const KnotVector u = knots(bytes, 12);
      const KnotVector v = knots(bytes, 12);
      const auto at = pairs(bytes, points.size());
      look(approximate(points, at, u, v, scattered(bytes, points.size())));
    },
    [](Bytes& bytes) {
      const glm::dvec3 factor = vector(bytes);
      const KnotVector on = knots(bytes, kMostDegree);
      const auto function = [&](std::span<const double> at, std::span<glm::dvec3> out) {
        for (std::size_t i = 0; i < at.size(); ++i) out[i] = factor * at[i];
      };
      look(project(function, on, bytes.flag()));
    },
};

}  // namespace

std::span<const FitStep> point_fits() { return kPointFits; }

}  // namespace splinecore::fuzz
