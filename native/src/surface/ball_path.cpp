#include "ball_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "base/length.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kNodes = 14;
constexpr std::size_t kNumbers = 10;

using Numbers = std::array<double, kNumbers>;

BallArc arc_of(const Contact& contact) {
  return {contact.first, contact.second, contact.circle_center, contact.circle_radius};
}

Numbers numbers_of_arc(const BallArc& arc) {
  return {arc.first.x,  arc.first.y,  arc.first.z,  arc.second.x, arc.second.y,
          arc.second.z, arc.center.x, arc.center.y, arc.center.z, arc.radius};
}

BallArc arc_with(const Numbers& n) { return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9]}; }

/// Chebyshev's places in [0, 1], and the factors of Lagrange's formula for them (Berrut and Trefethen 2004).
struct Nodes {
  Nodes() {
    for (std::size_t k = 0; k < kNodes; ++k) {
      const double angle = std::numbers::pi * (static_cast<double>(k) + 0.5) / kNodes;
      places[k] = 0.5 - 0.5 * std::cos(angle);
      factors[k] = (k % 2 == 0 ? 1.0 : -1.0) * std::sin(angle);
    }
  }

  Numbers between(std::span<const double> values, double t) const {
    Numbers sums{};
    double all = 0.0;
    for (std::size_t k = 0; k < kNodes; ++k) {
      const double off = t - places[k];
      const double* const row = &values[k * kNumbers];
      if (off == 0.0) {
        std::copy_n(row, kNumbers, sums.begin());
        return sums;
      }
      const double share = factors[k] / off;
      all += share;
      for (std::size_t i = 0; i < kNumbers; ++i) sums[i] += share * row[i];
    }
    for (double& sum : sums) sum /= all;
    return sums;
  }

  std::array<double, kNodes> places;
  std::array<double, kNodes> factors;
};

const Nodes& nodes() {
  static const Nodes all;
  return all;
}

}  // namespace

glm::dvec3 BallArc::at(double v) const {
  const glm::dvec3 middle = (first - center) + (second - center);
  const double half = 0.5 * length_of(middle) / radius;  // cosine of half the angle
  const glm::dvec3 tip = half * center + middle / (2.0 * half);
  const double a = (1.0 - v) * (1.0 - v);
  const double b = v * v;
  const double between = 2.0 * v * (1.0 - v);
  return (a * first + between * tip + b * second) / (a + between * half + b);
}

BallPath::BallPath(const RollingBall& ball, const Interval& range, bool is_closed, double within) : ball_(ball), is_closed_(is_closed) {
  std::vector<double> breaks{range.start};
  for (const BallJoint& joint : ball.joints()) {
    if (joint.at > breaks.back() && joint.at < range.end) breaks.push_back(joint.at);
  }
  breaks.push_back(range.end);
  constexpr double kNarrow = 0x1p-12;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i] < breaks[i + 1]) add({breaks[i], breaks[i + 1]}, kNarrow * range.length(), within);
  }
}

void BallPath::add(const Interval& range, double width, double within) {
  constexpr std::array kLooks{0.0, 0.02, 0.13, 0.34, 0.5, 0.77, 0.98};
  if (range.length() <= width) {
    parts_.push_back({range, {}});
    return;
  }
  breathe(64);
  const auto place = [&](double t) { return range.start + t * range.length(); };
  Part part{range, {}};
  for (const double t : nodes().places) {
    const Numbers numbers = numbers_of_arc(arc_of(ball_.at(place(t), true)));
    part.values.insert(part.values.end(), numbers.begin(), numbers.end());
  }
  double off = 0.0;
  for (const double t : kLooks) {
    const Numbers found = nodes().between(part.values, t);
    const Numbers wanted = numbers_of_arc(arc_of(ball_.at(place(t), true)));
    for (std::size_t i = 0; i < kNumbers; ++i) off = std::max(off, std::abs(found[i] - wanted[i]));
  }
  if (off <= within) {
    error_ = std::max(error_, off);
    parts_.push_back(std::move(part));
    return;
  }
  const double middle = range.middle();
  add({range.start, middle}, width, within);
  add({middle, range.end}, width, within);
}

BallArc BallPath::at(double u) const {
  const double inside = is_closed_ ? u - std::floor(u) : u;
  const auto next = std::ranges::upper_bound(parts_, inside, {}, [](const Part& part) { return part.range.start; });
  if (next == parts_.begin()) return arc_of(ball_.at(u, true));
  const Part& part = *std::prev(next);
  if (part.values.empty() || inside > part.range.end) return arc_of(ball_.at(u, true));
  return arc_with(nodes().between(part.values, (inside - part.range.start) / part.range.length()));
}

}  // namespace splinecore
