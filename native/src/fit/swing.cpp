#include "swing.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "base/length.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kCurvePlaces = 5;  // between two points
constexpr std::size_t kPatchPlaces = 3;

glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) { return a + share * (b - a); }

/// A box around points.
struct PointBox {
  glm::dvec3 low;
  glm::dvec3 high;

  explicit PointBox(const glm::dvec3& point) : low(point), high(point) {}
  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  double size() const { return distance_of(low, high); }
  double distance_to(const glm::dvec3& point) const { return distance_of(point, glm::clamp(point, low, high)); }
};

/// Indices first - reach … last + reach of `count` rows: of closed ones around the seam.
struct PointWindow {
  std::size_t first;
  std::size_t number;

  PointWindow(std::size_t at, std::size_t reach, std::size_t count, bool is_closed) {
    const std::size_t wanted = 2 * reach + 2;
    if (wanted >= count) {
      first = 0;
      number = count;
    } else if (is_closed) {
      first = (at + count - reach) % count;
      number = wanted;
    } else {
      first = at > reach ? at - reach : 0;
      number = std::min(count, at + reach + 2) - first;
    }
  }
};

/// Places between two parameters, with the first of them.
template <std::size_t kPlaces>
void add_places(std::vector<double>& places, double from, double to) {
  for (std::size_t k = 0; k <= kPlaces; ++k) {
    places.push_back(from + static_cast<double>(k) / (kPlaces + 1) * (to - from));
  }
}

/// How much less each chord counts for every point that it is farther away: about as splines of degree 15 forget.
constexpr double kFading = 0.75;

/// The longest of the chords, as each place counts them.
std::vector<double> faded(std::vector<double> chords, bool is_closed) {
  const std::size_t count = chords.size();
  const std::size_t rounds = is_closed ? 2 : 1;
  double most = 0.0;
  for (std::size_t k = 0; k < rounds * count; ++k) {
    most = std::max(kFading * most, chords[k % count]);
    chords[k % count] = most;
  }
  most = 0.0;
  for (std::size_t k = rounds * count; k-- > 0;) {
    most = std::max(kFading * most, chords[k % count]);
    chords[k % count] = most;
  }
  return chords;
}

double distance_to_chord(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
  const double length = distance_of(a, b);
  if (!(length > 0.0)) return distance_of(point, a);
  const glm::dvec3 direction = (b - a) / length;
  return distance_of(point, a + std::clamp(glm::dot(point - a, direction), 0.0, length) * direction);
}

/// What lies around a cell of a grid.
double size_around(const PointGrid& grid, const PointWindow& along_u, const PointWindow& along_v) {
  PointBox extent(grid.points[along_u.first * grid.count_v + along_v.first]);
  for (std::size_t a = 0; a < along_u.number; ++a) {
    const std::size_t i = (along_u.first + a) % grid.count_u;
    for (std::size_t b = 0; b < along_v.number; ++b) {
      extent.add(grid.points[i * grid.count_v + (along_v.first + b) % grid.count_v]);
    }
  }
  return extent.size();
}

std::vector<double> places_of(const KnotVector& knots) {
  std::vector<double> places;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    add_places<kPatchPlaces>(places, span.start, span.end);
  }
  places.push_back(knots.domain().end);
  return places;
}

}  // namespace

bool stays_near(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<const double> parameters,
                const Swing& swing) {
  constexpr std::size_t kTogether = 64;
  const std::size_t count = points.size();
  const std::size_t steps = parameters.size() - 1;
  const auto reach = static_cast<std::size_t>(curve.degree());
  std::vector<double> places;
  std::vector<glm::dvec3> found;
  for (std::size_t first = 0; first < steps; first += kTogether) {
    const std::size_t end = std::min(first + kTogether, steps);
    places.clear();
    for (std::size_t i = first; i < end; ++i) add_places<kCurvePlaces>(places, parameters[i], parameters[i + 1]);
    found.resize(places.size());
    evaluate(curve, places, {&found.front().x, 3 * found.size()});
    for (std::size_t i = first; i < end; ++i) {
      double farthest = 0.0;
      for (std::size_t k = 0; k <= kCurvePlaces; ++k) {
        const glm::dvec3 wanted = between(points[i], points[(i + 1) % count], static_cast<double>(k) / (kCurvePlaces + 1));
        farthest = std::max(farthest, distance_of(found[(i - first) * (kCurvePlaces + 1) + k], wanted));
      }
      if (farthest <= swing.tolerance) continue;
      const PointWindow window(i, reach, count, curve.periodic());
      PointBox extent(points[window.first]);
      breathe(8 * window.number);
      for (std::size_t k = 1; k < window.number; ++k) extent.add(points[(window.first + k) % count]);
      if (!(farthest <= swing.tolerance + swing.most * extent.size())) return false;
    }
  }
  return true;
}

double swing_of(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<const double> parameters) {
  constexpr std::size_t kEach = 4;
  constexpr std::size_t kTogether = 64;
  const std::size_t count = points.size();
  const std::size_t steps = parameters.size() - 1;
  std::vector<double> chords(steps);
  for (std::size_t i = 0; i < steps; ++i) chords[i] = distance_of(points[i], points[(i + 1) % count]);
  chords = faded(std::move(chords), curve.periodic());
  std::vector<double> places;
  std::vector<glm::dvec3> found;
  double largest = 0.0;
  for (std::size_t first = 0; first < steps; first += kTogether) {
    const std::size_t end = std::min(first + kTogether, steps);
    breathe(64 * (end - first));
    places.clear();
    for (std::size_t i = first; i < end; ++i) {
      for (std::size_t k = 0; k < kEach; ++k) {
        places.push_back(parameters[i] + (static_cast<double>(k) + 0.5) / kEach * (parameters[i + 1] - parameters[i]));
      }
    }
    found.resize(places.size());
    evaluate(curve, places, {&found.front().x, 3 * found.size()});
    for (std::size_t k = 0; k < found.size(); ++k) {
      const std::size_t i = first + k / kEach;
      const double away = distance_to_chord(found[k], points[i], points[(i + 1) % count]);
      if (away > 0.0) largest = std::max(largest, away / chords[i]);
    }
  }
  return largest;
}

bool stays_near(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u, std::span<const double> v,
                const Swing& swing) {
  constexpr std::size_t kEach = kPatchPlaces + 1;
  const auto reach_u = static_cast<std::size_t>(patch.knot_vector(Axis::u).degree());
  const auto reach_v = static_cast<std::size_t>(patch.knot_vector(Axis::v).degree());
  std::vector<double> across;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) add_places<kPatchPlaces>(across, v[j], v[j + 1]);
  std::vector<glm::dvec3> found(kEach * across.size());
  std::vector<double> along;
  const auto at = [&](std::size_t i, std::size_t j) {
    return grid.points[i % grid.count_u * grid.count_v + j % grid.count_v];
  };
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    along.clear();
    add_places<kPatchPlaces>(along, u[i], u[i + 1]);
    evaluate_grid(patch, along, across, {&found.front().x, 3 * found.size()});
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
      double farthest = 0.0;
      for (std::size_t a = 0; a < kEach; ++a) {
        const double share = static_cast<double>(a) / kEach;
        const glm::dvec3 left = between(at(i, j), at(i + 1, j), share);
        const glm::dvec3 right = between(at(i, j + 1), at(i + 1, j + 1), share);
        for (std::size_t b = 0; b < kEach; ++b) {
          const glm::dvec3 wanted = between(left, right, static_cast<double>(b) / kEach);
          farthest = std::max(farthest, distance_of(found[a * across.size() + j * kEach + b], wanted));
        }
      }
      if (farthest <= swing.tolerance) continue;
      breathe(16 * (reach_u + 1) * (reach_v + 1));
      const PointWindow along_u(i, reach_u, grid.count_u, patch.knot_vector(Axis::u).periodic());
      const PointWindow along_v(j, reach_v, grid.count_v, patch.knot_vector(Axis::v).periodic());
      if (!(farthest <= swing.tolerance + swing.most * size_around(grid, along_u, along_v))) return false;
    }
  }
  return true;
}

bool stays_near(const NurbsPatch& patch, std::span<const glm::dvec3> points, double most) {
  PointBox extent(points.front());
  for (const glm::dvec3& point : points) extent.add(point);
  const double reach = most * extent.size();
  const std::vector<double> across = places_of(patch.knot_vector(Axis::v));
  std::vector<glm::dvec3> found(across.size());
  for (const double u : places_of(patch.knot_vector(Axis::u))) {
    evaluate_grid(patch, {&u, 1}, across, {&found.front().x, 3 * found.size()});
    for (const glm::dvec3& point : found) {
      if (!(extent.distance_to(point) <= reach)) return false;
    }
  }
  return true;
}

}  // namespace splinecore
