#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "base/length.hpp"
#include "base/require.hpp"
#include "calm_steps.hpp"
#include "grid.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

void require_grid(const PointGrid& grid) {
  if (grid.count_u == 0 || grid.count_v == 0 || grid.points.size() / grid.count_v != grid.count_u ||
      grid.points.size() % grid.count_v != 0) {
    throw InvalidShape("points has " + std::to_string(grid.points.size()) + " rows, for a grid of " +
                       std::to_string(grid.count_u) + " by " + std::to_string(grid.count_v));
  }
  require_finite(grid.points, "points", grid.count_v);
}

namespace {

/// Steps between neighbouring rows of points, as shares of each line that crosses them, added up over the lines.
class Steps {
 public:
  static constexpr std::size_t kTogether = 16;  ///< lines, that lie side by side in memory along u

  Steps(const PointGrid& grid, Axis axis, int roots, Closing closing)
      : grid_(grid), axis_(axis), roots_(roots), count_(grid.count(axis)),
        sums_(closing == Closing::closed ? count_ : count_ - 1), steps_(kTogether * sums_.size()) {}

  void add_lines(std::size_t begin, std::size_t end) {
    breathe(8 * steps_.size());
    std::array<double, kTogether> lengths{};
    const std::size_t number = end - begin;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const std::size_t next = i + 1 < count_ ? i + 1 : 0;
      for (std::size_t k = 0; k < number; ++k) {
        double step = distance_of(at(i, begin + k), at(next, begin + k));
        for (int root = 0; root < roots_; ++root) step = std::sqrt(step);
        steps_[kTogether * i + k] = step;
        lengths[k] += step;
      }
    }
    for (std::size_t k = 0; k < number; ++k) add_shares(k, lengths[k]);
  }

  std::vector<double> parameters() const {
    if (lines_ == 0.0) throw InvalidShape("points along " + name() + " coincide in every line: they have no distance");
    std::vector<double> found{0.0};
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      found.push_back(found.back() + length_ * (sums_[i] / lines_));
      if (found.back() > found[i]) continue;
      throw InvalidShape("points along " + name() + ": line " + std::to_string((i + 1) % count_) +
                         " is too close to line " + std::to_string(i) +
                         ": their distance is no step of the parameter");
    }
    return found;
  }

 private:
  void add_shares(std::size_t line, double length) {
    if (length == 0.0) return;
    if (!std::isfinite(length)) {
      throw InvalidShape("points are too far apart along " + name() + ": their distances overflow");
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += steps_[kTogether * i + line] / length;
    // A mean that is kept while lines come, because their sum may overflow.
    lines_ += 1.0;
    length_ += (length - length_) / lines_;
  }

  std::string name() const { return axis_ == Axis::u ? "u" : "v"; }

  const glm::dvec3& at(std::size_t i, std::size_t line) const {
    return grid_.points[axis_ == Axis::u ? i * grid_.count_v + line : line * grid_.count_v + i];
  }

  const PointGrid& grid_;
  Axis axis_;
  int roots_;  ///< that are taken of a distance
  std::size_t count_;
  std::vector<double> sums_;
  std::vector<double> steps_;  ///< of the lines that are together
  double length_ = 0.0;
  double lines_ = 0.0;
};

std::vector<double> equal_steps(std::size_t count, Closing closing) {
  std::vector<double> numbers(count + (closing == Closing::closed ? 1 : 0));
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return numbers;
}

/// Of the lines along an axis that are no points.
double mean_length(const PointGrid& grid, Axis axis, Closing closing) {
  const std::size_t count = grid.count(axis);
  const std::size_t lines = axis == Axis::u ? grid.count_v : grid.count_u;
  const std::size_t steps = closing == Closing::closed ? count : count - 1;
  const auto at = [&](std::size_t i, std::size_t line) {
    return grid.points[axis == Axis::u ? i * grid.count_v + line : line * grid.count_v + i];
  };
  double mean = 0.0;
  double number = 0.0;
  for (std::size_t line = 0; line < lines; ++line) {
    breathe(8 * steps);
    double length = 0.0;
    for (std::size_t i = 0; i < steps; ++i) length += distance_of(at(i, line), at((i + 1) % count, line));
    if (!(length > 0.0)) continue;
    number += 1.0;
    mean += (length - mean) / number;
  }
  return mean;
}

std::vector<double> by_roots(const PointGrid& grid, Axis axis, int roots, Closing closing) {
  require_grid(grid);
  if (roots == kNoRoots || grid.count(axis) == 1) return equal_steps(grid.count(axis), closing);
  Steps steps(grid, axis, roots, closing);
  const std::size_t lines = axis == Axis::u ? grid.count_v : grid.count_u;
  for (std::size_t line = 0; line < lines; line += Steps::kTogether) {
    steps.add_lines(line, std::min(line + Steps::kTogether, lines));
  }
  return steps.parameters();
}

}  // namespace

std::vector<double> parameters_of(const PointGrid& grid, Axis axis, Parametrisation kind, Closing closing) {
  if (kind == Parametrisation::uniform) return by_roots(grid, axis, kNoRoots, closing);
  return by_roots(grid, axis, kind == Parametrisation::chordal ? 0 : 1, closing);
}

std::vector<double> calm_parameters(const PointGrid& grid, Axis axis, int degree, Closing closing) {
  std::vector<double> parameters = by_roots(grid, axis, calm_roots(degree), closing);
  return ending_at(std::move(parameters), mean_length(grid, axis, closing));
}

}  // namespace splinecore
