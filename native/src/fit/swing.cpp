#include "swing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "base/length.hpp"
#include "spread.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kCurvePlaces = 5;  // between two points
constexpr std::size_t kPatchPlaces = 3;

glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) { return a + share * (b - a); }

/// A ball around the mean of points: whichever way they are turned, it is as large.
class PointBall {
 public:
  void add(const glm::dvec3& point) { points_.push_back(point); }

  void close() {
    center_ = glm::dvec3(0.0);
    const double share = 1.0 / static_cast<double>(points_.size());
    for (const glm::dvec3& point : points_) center_ += share * point;
    radius_ = 0.0;
    for (const glm::dvec3& point : points_) radius_ = std::max(radius_, distance_of(point, center_));
  }

  double width() const { return 2.0 * radius_; }

 private:
  std::vector<glm::dvec3> points_;
  glm::dvec3 center_{0.0};
  double radius_ = 0.0;
};

/// The least thick disk around the mean of points, whose axis is where they spread least.
class PointDisk {
 public:
  explicit PointDisk(std::span<const glm::dvec3> points) {
    const double share = 1.0 / static_cast<double>(points.size());
    for (const glm::dvec3& point : points) center_ += share * point;
    std::vector<glm::dvec3> about;
    for (const glm::dvec3& point : points) about.push_back(point - center_);
    axis_ = least_spread(about);
    for (const glm::dvec3& point : about) {
      const double height = glm::dot(point, axis_);
      low_ = std::min(low_, height);
      high_ = std::max(high_, height);
      radius_ = std::max(radius_, length_of(point - height * axis_));
    }
  }

  double width() const { return 2.0 * radius_; }

  double distance_to(const glm::dvec3& point) const {
    const glm::dvec3 about = point - center_;
    const double height = glm::dot(about, axis_);
    const double beside = std::max(length_of(about - height * axis_) - radius_, 0.0);
    return std::hypot(beside, std::max({0.0, low_ - height, height - high_}));
  }

 private:
  glm::dvec3 center_{0.0};
  glm::dvec3 axis_{0.0};
  double low_ = 0.0;
  double high_ = 0.0;
  double radius_ = 0.0;
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
  PointBall ball;
  for (std::size_t a = 0; a < along_u.number; ++a) {
    const std::size_t i = (along_u.first + a) % grid.count_u;
    for (std::size_t b = 0; b < along_v.number; ++b) {
      ball.add(grid.points[i * grid.count_v + (along_v.first + b) % grid.count_v]);
    }
  }
  ball.close();
  return ball.width();
}

const glm::dvec3& point_at(const PointGrid& grid, std::size_t i, std::size_t j) {
  return grid.points[i % grid.count_u * grid.count_v + j % grid.count_v];
}

/// Calls look(i, j, away) with how far the patch leaves the bilinear piece of each cell, until that is false.
template <class Look>
bool for_each_cell(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u, std::span<const double> v,
                   const Look& look) {
  constexpr std::size_t kEach = kPatchPlaces + 1;
  std::vector<double> across;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) add_places<kPatchPlaces>(across, v[j], v[j + 1]);
  std::vector<glm::dvec3> found(kEach * across.size());
  std::vector<double> along;
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    along.clear();
    add_places<kPatchPlaces>(along, u[i], u[i + 1]);
    evaluate_grid(patch, along, across, {&found.front().x, 3 * found.size()});
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
      double farthest = 0.0;
      for (std::size_t a = 0; a < kEach; ++a) {
        const double share = static_cast<double>(a) / kEach;
        const glm::dvec3 left = between(point_at(grid, i, j), point_at(grid, i + 1, j), share);
        const glm::dvec3 right = between(point_at(grid, i, j + 1), point_at(grid, i + 1, j + 1), share);
        for (std::size_t b = 0; b < kEach; ++b) {
          const glm::dvec3 wanted = between(left, right, static_cast<double>(b) / kEach);
          farthest = std::max(farthest, distance_of(found[a * across.size() + j * kEach + b], wanted));
        }
      }
      if (!look(i, j, farthest)) return false;
    }
  }
  return true;
}

/// Of each cell the longest side, as each counts there.
std::vector<double> faded_sides(const NurbsPatch& patch, const PointGrid& grid, std::size_t cells_u, std::size_t cells_v) {
  std::vector<double> sides(cells_u * cells_v);
  for (std::size_t i = 0; i < cells_u; ++i) {
    for (std::size_t j = 0; j < cells_v; ++j) {
      const glm::dvec3& a = point_at(grid, i, j);
      const glm::dvec3& b = point_at(grid, i + 1, j);
      const glm::dvec3& c = point_at(grid, i, j + 1);
      const glm::dvec3& d = point_at(grid, i + 1, j + 1);
      sides[i * cells_v + j] = std::max({distance_of(a, b), distance_of(a, c), distance_of(b, d), distance_of(c, d)});
    }
  }
  for (std::size_t i = 0; i < cells_u; ++i) {
    std::vector<double> row(&sides[i * cells_v], &sides[i * cells_v] + cells_v);
    row = faded(std::move(row), patch.knot_vector(Axis::v).periodic());
    std::ranges::copy(row, &sides[i * cells_v]);
  }
  for (std::size_t j = 0; j < cells_v; ++j) {
    std::vector<double> column;
    for (std::size_t i = 0; i < cells_u; ++i) column.push_back(sides[i * cells_v + j]);
    column = faded(std::move(column), patch.knot_vector(Axis::u).periodic());
    for (std::size_t i = 0; i < cells_u; ++i) sides[i * cells_v + j] = column[i];
  }
  return sides;
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
      PointBall ball;
      breathe(8 * window.number);
      for (std::size_t k = 0; k < window.number; ++k) ball.add(points[(window.first + k) % count]);
      ball.close();
      if (!(farthest <= swing.tolerance + swing.most * ball.width())) return false;
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

double swing_of(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u, std::span<const double> v) {
  const std::vector<double> sides = faded_sides(patch, grid, u.size() - 1, v.size() - 1);
  double largest = 0.0;
  for_each_cell(patch, grid, u, v, [&](std::size_t i, std::size_t j, double away) {
    if (away > 0.0) largest = std::max(largest, away / sides[i * (v.size() - 1) + j]);
    return true;
  });
  return largest;
}

bool stays_near(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u, std::span<const double> v,
                const Swing& swing) {
  const auto reach_u = static_cast<std::size_t>(patch.knot_vector(Axis::u).degree());
  const auto reach_v = static_cast<std::size_t>(patch.knot_vector(Axis::v).degree());
  return for_each_cell(patch, grid, u, v, [&](std::size_t i, std::size_t j, double away) {
    if (away <= swing.tolerance) return true;
    breathe(16 * (reach_u + 1) * (reach_v + 1));
    const PointWindow along_u(i, reach_u, grid.count_u, patch.knot_vector(Axis::u).periodic());
    const PointWindow along_v(j, reach_v, grid.count_v, patch.knot_vector(Axis::v).periodic());
    return away <= swing.tolerance + swing.most * size_around(grid, along_u, along_v);
  });
}

bool stays_near(const NurbsPatch& patch, std::span<const glm::dvec3> points, double most) {
  const PointDisk disk(points);
  const double reach = most * disk.width();
  const std::vector<double> across = places_of(patch.knot_vector(Axis::v));
  std::vector<glm::dvec3> found(across.size());
  for (const double u : places_of(patch.knot_vector(Axis::u))) {
    evaluate_grid(patch, {&u, 1}, across, {&found.front().x, 3 * found.size()});
    for (const glm::dvec3& point : found) {
      if (!(disk.distance_to(point) <= reach)) return false;
    }
  }
  return true;
}

}  // namespace splinecore
