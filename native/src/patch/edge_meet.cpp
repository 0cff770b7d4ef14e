#include "edge_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

/// The k by which the first rows of both move least about a common edge (total least squares).
double ratio_for_both(const LocalRows& a, const LocalRows& b) {
  require_legs(a);
  require_legs(b);
  const std::size_t count = a.rows[0].size();
  const double on_leg = b.coefficient(1, 1) / std::abs(a.coefficient(1, 1));
  const auto leg_a = [&](std::size_t i) { return a.derivative(1, i) / std::abs(a.coefficient(1, 1)); };
  const auto leg_b = [&](std::size_t i) { return b.derivative(1, i, 2) / b.coefficient(1, 1); };
  const double aa = product(count, leg_a, leg_a);
  const double bb = product(count, leg_b, leg_b);
  const double ab = product(count, leg_a, leg_b);
  const double of_lengths = std::sqrt(bb / aa);
  if (!(ab > 0.0)) return of_lengths * on_leg;
  const double half = 0.5 * (bb - aa);
  const double k = half > 0.0 ? (half + std::hypot(half, ab)) / ab : ab / (std::hypot(half, ab) - half);
  const bool is_sensible = k >= kLeastShare * of_lengths && of_lengths >= kLeastShare * k;
  return (is_sensible ? k : of_lengths) * on_leg;
}

/// What a condition takes of each row of a and then of b.
using EdgeCondition = std::array<double, 2 * kMostRows>;

/// Brings condition k to right angles with those before it, and to length 1 (Gram and Schmidt).
void set_upright(std::array<EdgeCondition, kMostRows>& conditions, int k) {
  EdgeCondition& own = conditions[k];
  const auto divide = [&](double by) { std::ranges::for_each(own, [by](double& number) { number /= by; }); };
  divide(std::abs(*std::ranges::max_element(own, {}, [](double number) { return std::abs(number); })));
  constexpr int kTwice = 2;  // once leaves rounding where the angle is small
  for (int round = 0; round < kTwice; ++round) {
    for (int l = 0; l < k; ++l) {
      const double share = std::inner_product(own.begin(), own.end(), conditions[l].begin(), 0.0);
      for (std::size_t i = 0; i < own.size(); ++i) own[i] -= share * conditions[l][i];
    }
    divide(std::sqrt(std::inner_product(own.begin(), own.end(), own.begin(), 0.0)));
  }
}

/// The conditions as unit vectors at right angles, which the same moves meet.
std::array<EdgeCondition, kMostRows> conditions(const LocalRows& a, const LocalRows& b, const Constants& by,
                                                 int count) {
  const std::array<std::array<double, kMostRows>, kMostRows> of_a{
      {{1.0, 0.0, 0.0}, {by.g, by.k, 0.0}, {by.e, by.m + 2.0 * by.g * by.k, by.k * by.k}}};
  std::array<EdgeCondition, kMostRows> found{};
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < kMostRows; ++i) {
      for (int l = 0; l <= k; ++l) found[k][i] += of_a[k][l] * a.coefficient(l, i);
      found[k][kMostRows + i] = -b.coefficient(k, i);
    }
    set_upright(found, k);
  }
  return found;
}

/// Moves the places of a's rows by their part of the least moves that meet upright conditions.
void move_first(LocalRows& a, const LocalRows& b, const std::array<EdgeCondition, kMostRows>& conditions, int count) {
  for (std::size_t column = 0; column < a.rows[0].size(); ++column) {
    std::array<glm::dvec3, 2 * kMostRows> places;
    places.fill(glm::dvec3(0.0));
    for (int i = 0; i < count; ++i) {
      places[i] = glm::dvec3(a.rows[i][column]);
      places[kMostRows + i] = glm::dvec3(b.rows[i][column]);
    }
    for (int k = 0; k < count; ++k) {
      glm::dvec3 miss(0.0);
      for (int i = 0; i < 2 * kMostRows; ++i) miss += conditions[k][i] * places[i];
      for (int i = 0; i < 2 * kMostRows; ++i) places[i] -= conditions[k][i] * miss;
    }
    for (int i = 0; i < count; ++i) a.rows[i][column] = glm::dvec4(places[i], a.rows[i][column].w);
  }
}

glm::dvec4 middle(const glm::dvec4& a, const glm::dvec4& b) {
  if (a == b) return a;
  return a.w == b.w ? 0.5 * a + 0.5 * b : as_given(0.5 * homogeneous(a) + 0.5 * homogeneous(b));
}

}  // namespace

void meet(EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational) {
  const int count = rows_of(smoothness);
  EdgeRow edge;
  for (std::size_t i = 0; i < a.rows[0].size(); ++i) edge.push_back(middle(a.rows[0][i], b.rows[0][i]));
  if (count == 1) {
    a.rows[0] = b.rows[0] = edge;
    return;
  }
  const std::vector<glm::dvec3> origins = origins_of(edge);
  LocalRows on_a = local_rows(a, origins);
  const LocalRows on_b = local_rows(b, origins);
  LocalRows about_edge = on_a;
  LocalRows moved = on_b;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    about_edge.rows[0][i] = edge[i].w == 0.0 ? edge[i] : glm::dvec4(0.0, 0.0, 0.0, edge[i].w);
  }
  moved.rows[0] = about_edge.rows[0];
  KnownRatios known;
  if (is_geometric(smoothness)) known.k = ratio_for_both(about_edge, moved);
  const Constants by = follow_locally(about_edge, moved, smoothness, is_rational, known);
  move_first(on_a, on_b, conditions(on_a, on_b, by, count), count);
  for (std::size_t i = 0; i < edge.size(); ++i) on_a.rows[0][i].w = edge[i].w;
  write_back(on_a, origins, 0, count, a);
  follow(a, b, smoothness, is_rational, {by.k, by.m});
}

}  // namespace splinecore
