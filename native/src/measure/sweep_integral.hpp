#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "base/rounding.hpp"
#include "basis/bernstein_net.hpp"
#include "kronrod_31.hpp"
#include "numerators.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Integrals, how far they may be off, and how much is swept to and fro.
template <std::size_t Count>
struct SweepSums {
  std::array<double, Count> values{};
  std::array<double, Count> errors{};
  std::array<double, Count> terms{};

  void add(const SweepSums& more) {
    for (std::size_t i = 0; i < Count; ++i) {
      values[i] += more.values[i];
      errors[i] += more.errors[i];
      terms[i] += more.terms[i];
    }
  }
};

/// Of a plane curve on a span: twice the area that the line from the origin sweeps, times W², and W; where they are asked for, X and Y.
struct SweptSpan {
  BernsteinNet<double> sweep;
  BernsteinNet<double> weight;
  BernsteinNet<double> x;
  BernsteinNet<double> y;

  /// @param points  homogeneous Bernstein points (X, Y, W)
  explicit SweptSpan(std::span<const glm::dvec3> points, bool has_places) {
    std::vector<glm::dvec2> seen;
    std::array<std::vector<double>, 3> columns;
    for (const glm::dvec3& p : points) {
      seen.emplace_back(p);
      for (int k = 0; k < 3; ++k) columns[k].push_back(p[k]);
    }
    sweep = BernsteinNet<double>::of_curve(sweep_of(seen).coefficients);
    weight = BernsteinNet<double>::of_curve(std::move(columns[2]));
    if (!has_places) return;
    x = BernsteinNet<double>::of_curve(std::move(columns[0]));
    y = BernsteinNet<double>::of_curve(std::move(columns[1]));
  }

  /// Whether weights are near each other.
  bool is_even() const {
    constexpr double kMost = 16.0;
    const auto [low, high] = weight.range();
    return low > 0.0 ? high <= kMost * low : high < 0.0 && low >= kMost * high;
  }

  /// The second half; what is left is the first.
  SweptSpan cut_off_half() {
    SweptSpan behind = *this;
    sweep.halve(Axis::u, behind.sweep);
    weight.halve(Axis::u, behind.weight);
    if (!x.values.empty()) {
      x.halve(Axis::u, behind.x);
      y.halve(Axis::u, behind.y);
    }
    for (double& c : sweep.values) c *= 0.5;
    for (double& c : behind.sweep.values) c *= 0.5;
    return behind;
  }
};

/// Integrals of monomials of a place over twice the swept area, by the rules of Gauss and Kronrod of 15 and 31 nodes, halved where
/// they differ and where weights differ much: of 1; and, where six are asked for, of x, y, xx, xy and yy.
template <std::size_t Count>
class SweepIntegral {
  static_assert(Count == 1 || Count == 6);

 public:
  explicit SweepIntegral(double tolerance) : tolerance_(tolerance) {}

  SweepSums<Count> over(std::span<const glm::dvec3> points) { return over(SweptSpan(points, Count > 1), 0); }

 private:
  SweepSums<Count> over(SweptSpan span, int depth) {
    constexpr int kDeepest = 60;
    const bool is_deep = depth == kDeepest;
    if (is_deep || span.is_even()) {
      const SweepSums<Count> found = by_rule(span);
      if (is_deep || is_near(found)) return found;
    }
    SweptSpan behind = span.cut_off_half();
    SweepSums<Count> found = over(std::move(span), depth + 1);
    found.add(over(std::move(behind), depth + 1));
    return found;
  }

  bool is_near(const SweepSums<Count>& found) const {
    constexpr double kCaution = 0.125;
    for (std::size_t i = 0; i < Count; ++i) {
      if (found.errors[i] > std::max(kCaution * tolerance_, kRoundingOfStep) * found.terms[i]) return false;
    }
    return true;
  }

  SweepSums<Count> by_rule(const SweptSpan& span) {
    breathe(64 * span.sweep.rows);
    functions_.resize(std::max(span.sweep.rows, span.weight.rows));
    SweepSums<Count> found;
    const auto add = [&](double t, double s, const KronrodNode& node) {
      const std::array<double, Count> at = values_at(span, t, s);
      for (std::size_t i = 0; i < Count; ++i) {
        found.values[i] += node.kronrod * at[i];
        found.terms[i] += node.kronrod * std::abs(at[i]);
        found.errors[i] += (node.kronrod - node.gauss) * at[i];
      }
    };
    for (const KronrodNode& node : kKronrod31) {
      add(node.at, 1.0 - node.at, node);
      if (node.at != 0.5) add(1.0 - node.at, node.at, node);
    }
    for (double& error : found.errors) error = std::abs(error);
    return found;
  }

  std::array<double, Count> values_at(const SweptSpan& span, double t, double s) {
    bernstein(span.weight.degree(Axis::u), t, s, functions_);
    const double w = sum_of(span.weight);
    std::array<double, Count> found;
    glm::dvec2 place(0.0);
    if constexpr (Count > 1) place = glm::dvec2(sum_of(span.x), sum_of(span.y)) / w;
    bernstein(span.sweep.degree(Axis::u), t, s, functions_);
    found[0] = sum_of(span.sweep) / (w * w);
    if constexpr (Count > 1) {
      found[1] = place.x * found[0];
      found[2] = place.y * found[0];
      found[3] = place.x * found[1];
      found[4] = place.x * found[2];
      found[5] = place.y * found[2];
    }
    return found;
  }

  /// The sum of Bernstein polynomials, whose values are known.
  double sum_of(const BernsteinNet<double>& net) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < net.rows; ++i) sum += functions_[i] * net.values[i];
    return sum;
  }

  double tolerance_;
  std::vector<double> functions_;
};

}  // namespace splinecore
#pragma GCC visibility pop
