#include "reach.hpp"

#include <algorithm>
#include <queue>
#include <vector>

#include "base/one_sign.hpp"
#include "basis/bernstein_roots.hpp"
#include "numerators.hpp"

namespace splinecore {

namespace {

using PlaneNet = BernsteinNet<glm::dvec2>;

double quotient(const glm::dvec2& p) { return p.x / p.y; }

glm::dvec2 value_at(std::span<const glm::dvec2> line, double t) {
  std::vector<double> values;
  std::vector<double> weights;
  for (const glm::dvec2& p : line) {
    values.push_back(p.x);
    weights.push_back(p.y);
  }
  return {bernstein_value(values, t), bernstein_value(weights, t)};
}

/// A part of a patch, and the most that it may reach.
struct BoundedPart {
  PlaneNet net;
  double most;
  bool operator<(const BoundedPart& other) const { return most < other.most; }
};

std::vector<glm::dvec2> line_of(const PlaneNet& net, Axis axis, std::size_t i) {
  std::vector<glm::dvec2> line;
  for (std::size_t j = 0; j < net.count(axis); ++j) line.push_back(axis == Axis::u ? net.at(j, i) : net.at(i, j));
  return line;
}

std::size_t lines_along(const PlaneNet& net, Axis axis) { return net.values.size() / net.count(axis); }

/// By how much the values of neighbors along a direction differ at most.
double unevenness(const PlaneNet& net, Axis axis) {
  double most = 0.0;
  for (std::size_t i = 0; i < lines_along(net, axis); ++i) {
    const std::vector<glm::dvec2> line = line_of(net, axis, i);
    const auto [low, high] = std::ranges::minmax(line, {}, quotient);
    most = std::max(most, quotient(high) - quotient(low));
  }
  return most;
}

/// Whether A rises or falls along the direction everywhere, where W is the same everywhere.
bool is_monotone(const PlaneNet& net, Axis axis) {
  const auto [low, high] = std::ranges::minmax(net.values, {}, &glm::dvec2::y);
  if (low.y != high.y) return false;
  const PlaneNet slope = net.derivative(axis);
  double largest = 0.0;
  for (const glm::dvec2& p : net.values) largest = std::max(largest, std::abs(p.x));
  const double noise = 0x1p-48 * net.degree(axis) * largest;
  return !slope.values.empty() && has_one_sign(slope.values, &glm::dvec2::x, noise);
}

class Ascent {
 public:
  Ascent(Interval& range, double slack) : range_(range), slack_(slack) {}

  double run(PlaneNet whole) {
    constexpr int kMostCells = 200'000;
    add(std::move(whole));
    for (int cells = 0; !cells_.empty(); ++cells) {
      const double beyond = cells_.top().most - range_.end;
      if (!(beyond > slack_)) return 0.0;
      if (cells == kMostCells) return beyond;
      PlaneNet first = cells_.top().net;
      cells_.pop();
      PlaneNet second;
      first.halve(longer_way(first), second);
      add(std::move(first));
      add(std::move(second));
    }
    return 0.0;
  }

 private:
  static Axis longer_way(const PlaneNet& net) {
    if (net.columns == 1) return Axis::u;
    const auto weight = [](const glm::dvec2& p) { return p.y; };
    if (!has_one_sign(net.values, weight)) return weight_way(net);
    return unevenness(net, Axis::u) >= unevenness(net, Axis::v) ? Axis::u : Axis::v;
  }

  /// Along which the weights differ more.
  static Axis weight_way(const PlaneNet& net) {
    const auto spread = [&](Axis axis) {
      double most = 0.0;
      for (std::size_t i = 0; i < lines_along(net, axis); ++i) {
        const std::vector<glm::dvec2> line = line_of(net, axis, i);
        const auto [low, high] = std::ranges::minmax(line, {}, &glm::dvec2::y);
        most = std::max(most, high.y - low.y);
      }
      return most;
    };
    return spread(Axis::u) >= spread(Axis::v) ? Axis::u : Axis::v;
  }

  void add(PlaneNet net) {
    for (const glm::dvec2& corner : net.corners()) take(range_, quotient(corner));
    const double most = hull_of(net.values).end;
    if (!(most > range_.end + slack_)) return;
    for (const Axis axis : {Axis::u, Axis::v}) {
      if (net.count(axis) < 2 || !is_monotone(net, axis)) continue;
      const Axis along = axis == Axis::u ? Axis::v : Axis::u;
      for (const std::size_t side : {std::size_t{0}, net.count(axis) - 1}) take_line(range_, line_of(net, along, side));
      return;
    }
    cells_.push({std::move(net), most});
  }

  Interval& range_;
  double slack_;
  std::priority_queue<BoundedPart> cells_;
};

}  // namespace

Interval hull_of(std::span<const glm::dvec2> points) {
  if (!has_one_sign(points, &glm::dvec2::y)) return {-HUGE_VAL, HUGE_VAL};
  Interval range = kNothing;
  for (const glm::dvec2& p : points) take(range, quotient(p));
  return range;
}

void take_line(Interval& range, std::span<const glm::dvec2> line) {
  take(range, quotient(line.front()));
  take(range, quotient(line.back()));
  const Interval hull = hull_of(line);
  if (line.size() < 3 || (hull.start >= range.start && hull.end <= range.end)) return;
  const Numerator slope = slope_of(line);
  for (const Interval& zero : bernstein_zeros(slope.coefficients, slope.noise)) {
    if (zero.length() == 0.0) take(range, quotient(value_at(line, zero.start)));
  }
}

double take_upper(Interval& range, PlaneNet net, double slack) { return Ascent(range, slack).run(std::move(net)); }

}  // namespace splinecore
