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

/// Steps between neighboring rows of points, as shares of each line that crosses them, added up over the lines.
class Steps {
 public:
  static constexpr std::size_t kTogether = 16;  ///< lines, that lie side by side in memory along u

  Steps(const PointGrid& grid, Axis axis, Parameterization kind, Closing closing)
      : grid_(grid), axis_(axis), kind_(kind), count_(grid.count(axis)),
        sums_(closing == Closing::closed ? count_ : count_ - 1), steps_(kTogether * sums_.size()) {}

  void add_lines(std::size_t begin, std::size_t end) {
    breathe(8 * steps_.size());
    std::array<double, kTogether> lengths{};
    const std::size_t number = end - begin;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const std::size_t next = i + 1 < count_ ? i + 1 : 0;
      for (std::size_t k = 0; k < number; ++k) {
        const double distance = distance_of(at(i, begin + k), at(next, begin + k));
        const double step = kind_ == Parameterization::chordal ? distance : std::sqrt(distance);
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
                         ": they coincide within rounding and get equal parameters");
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
  Parameterization kind_;
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

/// The farthest that two neighboring rows of points lie apart in a line, and the mean length of the lines that are no points.
struct RowDistances {
  std::vector<double> largest;
  double length = 0.0;

  RowDistances(const PointGrid& grid, Axis axis, Closing closing) {
    const std::size_t count = grid.count(axis);
    const std::size_t lines = axis == Axis::u ? grid.count_v : grid.count_u;
    const auto at = [&](std::size_t i, std::size_t line) {
      return grid.points[axis == Axis::u ? i * grid.count_v + line : line * grid.count_v + i];
    };
    largest.assign(closing == Closing::closed ? count : count - 1, 0.0);
    double number = 0.0;
    for (std::size_t line = 0; line < lines; ++line) {
      breathe(8 * largest.size());
      double sum = 0.0;
      for (std::size_t i = 0; i < largest.size(); ++i) {
        const double distance = distance_of(at(i, line), at((i + 1) % count, line));
        largest[i] = std::max(largest[i], distance);
        sum += distance;
      }
      if (!(sum > 0.0)) continue;
      number += 1.0;
      length += (sum - length) / number;
    }
  }
};

[[noreturn]] void refuse_step(Axis axis, std::size_t line, std::size_t count) {
  throw InvalidShape("points along " + std::string(axis == Axis::u ? "u" : "v") + ": line " + std::to_string(line % count) +
                     " is too close to line " + std::to_string(line - 1) + ": they coincide within rounding and get equal parameters");
}

}  // namespace

std::vector<double> parameters_of(const PointGrid& grid, Axis axis, Parameterization kind, Closing closing) {
  require_grid(grid);
  if (kind == Parameterization::uniform || grid.count(axis) == 1) return equal_steps(grid.count(axis), closing);
  Steps steps(grid, axis, kind, closing);
  const std::size_t lines = axis == Axis::u ? grid.count_v : grid.count_u;
  for (std::size_t line = 0; line < lines; line += Steps::kTogether) {
    steps.add_lines(line, std::min(line + Steps::kTogether, lines));
  }
  return steps.parameters();
}

std::vector<double> calm_parameters(const PointGrid& grid, Axis axis, int degree, Closing closing) {
  require_grid(grid);
  // Twice as many as of curves: rows that crowd along u and along v share the distances of their points.
  const int roots = calm_roots(degree) == kNoRoots ? kNoRoots : 2 * calm_roots(degree);
  const RowDistances distances(grid, axis, closing);
  if (roots == kNoRoots || grid.count(axis) == 1) {
    return ending_at(equal_steps(grid.count(axis), closing), distances.length);
  }
  const bool is_length = distances.length > 0.0 && std::isfinite(distances.length);
  if (!is_length) return parameters_of(grid, axis, Parameterization::centripetal, closing);
  std::vector<double> found{0.0};
  for (double step : distances.largest) {
    for (int root = 0; root < roots; ++root) step = std::sqrt(step);
    found.push_back(found.back() + step);
    if (!(found.back() > found[found.size() - 2])) refuse_step(axis, found.size() - 1, grid.count(axis));
  }
  return ending_at(std::move(found), distances.length);
}

}  // namespace splinecore
