#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "edge_rows.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

int rows_of(PatchSmoothness smoothness) noexcept {
  if (smoothness == PatchSmoothness::c0) return 1;
  return smoothness == PatchSmoothness::c1 || smoothness == PatchSmoothness::g1 ? 2 : 3;
}

namespace {

bool is_geometric(PatchSmoothness smoothness) {
  return smoothness == PatchSmoothness::g1 || smoothness == PatchSmoothness::g2;
}

/// B(t) is (1 + g t + e t² / 2) A(k t + m t² / 2) up to the second order.
struct Constants {
  double k = 1.0;
  double m = 0.0;
  double g = 0.0;
  double e = 0.0;
};

/// Homogeneous rows about the points of an edge: (w (P - O), w). Far from the origin no digit is lost, and where
/// the edge is in sight its own row has nothing but weights.
struct LocalRows {
  std::array<EdgeRow, kMostRows> rows;
  const EdgeRows* source;

  double coefficient(int k, int i) const { return source->coefficients[k][i]; }

  /// Derivative k of the column, of the rows before `end` alone.
  glm::dvec4 derivative(int k, std::size_t column, int end = kMostRows) const {
    glm::dvec4 sum(0.0);
    for (int i = 0; i < end; ++i) {
      if (coefficient(k, i) != 0.0) sum += coefficient(k, i) * rows[i][column];
    }
    return sum;
  }
};

std::vector<glm::dvec3> origins_of(const EdgeRow& edge) {
  std::vector<glm::dvec3> origins;
  for (const glm::dvec4& p : edge) origins.push_back(p.w == 0.0 ? glm::dvec3(0.0) : glm::dvec3(p));
  return origins;
}

LocalRows local_rows(const EdgeRows& given, const std::vector<glm::dvec3>& origins) {
  LocalRows local{given.rows, &given};
  for (EdgeRow& row : local.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].w != 0.0) row[i] = glm::dvec4(row[i].w * (glm::dvec3(row[i]) - origins[i]), row[i].w);
    }
  }
  return local;
}

/// The given form of a local point.
glm::dvec4 given_at(const glm::dvec4& local, const glm::dvec3& origin) {
  return local.w == 0.0 ? local : glm::dvec4(origin + glm::dvec3(local) / local.w, local.w);
}

/// Products of places, summed over the edge.
template <class One, class Other>
double product(std::size_t count, One one, Other other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += glm::dot(glm::dvec3(one(i)), glm::dvec3(other(i)));
  return sum;
}

/// @throws InvalidShape if the row beside the edge lies on it.
void require_legs(const LocalRows& on) {
  constexpr double kRounding = 0x1p-46;
  double longest = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < on.rows[0].size(); ++i) {
    longest = std::max(longest, glm::length(glm::dvec3(on.rows[1][i])));
    weight = std::max(weight, std::abs(on.rows[1][i].w));
  }
  if (longest <= kRounding * weight * largest_coordinate(on.source->rows[0])) {
    throw InvalidShape("a patch leaves the edge in no direction: its points beside the edge lie on it");
  }
}

/// A k below this share of what keeps the mean length of the legs would fold them back, or nearly.
constexpr double kLeastShare = 0.1;

/// The k by which b's first row moves least.
double ratio_for_b(const LocalRows& a, const LocalRows& b) {
  require_legs(a);
  const std::size_t count = a.rows[0].size();
  const auto on_a = [&](std::size_t i) { return a.derivative(1, i); };
  const auto on_b = [&](std::size_t i) { return b.derivative(1, i, 2); };
  const double square = product(count, on_a, on_a);
  const double k = product(count, on_a, on_b) / square;
  const double of_lengths = std::sqrt(product(count, on_b, on_b) / square);
  if (!(of_lengths > 0.0)) return 1.0;
  return k >= kLeastShare * of_lengths ? k : of_lengths;
}

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

/// The m by which b's second row moves least.
double turn_for_b(const LocalRows& a, const LocalRows& b, const Constants& by) {
  const std::size_t count = a.rows[0].size();
  const auto slope = [&](std::size_t i) { return a.derivative(1, i); };
  const auto rest = [&](std::size_t i) {
    return b.derivative(2, i) - by.k * by.k * a.derivative(2, i) - 2.0 * by.g * by.k * a.derivative(1, i);
  };
  return product(count, slope, rest) / product(count, slope, slope);
}

/// A row of b as (sum + constant edge) / scale.
struct NextRow {
  EdgeRow sum;
  double scale;
};

/// The constant that moves weights least, and more where otherwise one would fall below what it was and below
/// a quarter of that on the edge.
double weight_constant(const NextRow& next, const EdgeRow& edge, const EdgeRow& old) {
  constexpr double kShare = 0.25;
  double product = 0.0;
  double square = 0.0;
  double sign = edge[0].w > 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    product += edge[i].w * (next.scale * old[i].w - next.sum[i].w);
    square += edge[i].w * edge[i].w;
    if (!(sign * edge[i].w > 0.0)) sign = 0.0;
  }
  double constant = product / square;
  for (std::size_t i = 0; i < edge.size() && sign != 0.0; ++i) {
    const double share = kShare * sign * edge[i].w;
    const double was = sign * old[i].w;
    const double least = was > 0.0 ? std::min(was, share) : share;
    constant = std::max(constant, (next.scale * least - sign * next.sum[i].w) / (sign * edge[i].w));
  }
  return constant;
}

EdgeRow finished(const NextRow& next, const EdgeRow& edge, double constant, bool is_rational) {
  EdgeRow row;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    row.push_back((next.sum[i] + constant * edge[i]) / next.scale);
    if (!is_rational) row.back().w = 1.0;
  }
  return row;
}

/// Row `k` of b from derivative k of A(k t + m t² / 2) times the factor, all but the constant that is free.
NextRow next_row(const LocalRows& a, const LocalRows& b, int k, const Constants& by) {
  NextRow next{{}, b.coefficient(k, k)};
  for (std::size_t i = 0; i < a.rows[0].size(); ++i) {
    const glm::dvec4 slope = a.derivative(1, i);
    const glm::dvec4 wanted =
        k == 1 ? by.k * slope : by.k * by.k * a.derivative(2, i) + (by.m + 2.0 * by.g * by.k) * slope;
    next.sum.push_back(wanted - b.derivative(k, i, k));
  }
  return next;
}

/// b's rows after a's; k and m as they were found before, if they were.
Constants follow_locally(const LocalRows& a, LocalRows& b, PatchSmoothness smoothness, bool is_rational,
                         std::optional<Constants> before) {
  const int count = rows_of(smoothness);
  b.rows[0] = a.rows[0];
  Constants by = before.value_or(Constants{});
  by.g = by.e = 0.0;
  if (count >= 2) {
    if (!before && is_geometric(smoothness)) by.k = ratio_for_b(a, b);
    const NextRow next = next_row(a, b, 1, by);
    if (is_rational) by.g = weight_constant(next, a.rows[0], b.rows[1]);
    b.rows[1] = finished(next, a.rows[0], by.g, is_rational);
  }
  if (count >= 3) {
    const bool is_free = smoothness == PatchSmoothness::g2 && (!before || std::isnan(before->m));
    by.m = is_free ? turn_for_b(a, b, by) : by.m;
    const NextRow next = next_row(a, b, 2, by);
    if (is_rational) by.e = weight_constant(next, a.rows[0], b.rows[2]);
    b.rows[2] = finished(next, a.rows[0], by.e, is_rational);
  }
  return by;
}

/// What a condition takes of each row of a and then of b.
using Condition = std::array<double, 2 * kMostRows>;

/// Brings condition k to right angles with those before it, and to length 1 (Gram and Schmidt).
void set_upright(std::array<Condition, kMostRows>& conditions, int k) {
  Condition& own = conditions[k];
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
std::array<Condition, kMostRows> conditions(const LocalRows& a, const LocalRows& b, const Constants& by, int count) {
  const std::array<std::array<double, kMostRows>, kMostRows> of_a{
      {{1.0, 0.0, 0.0}, {by.g, by.k, 0.0}, {by.e, by.m + 2.0 * by.g * by.k, by.k * by.k}}};
  std::array<Condition, kMostRows> found{};
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
void move_first(LocalRows& a, const LocalRows& b, const std::array<Condition, kMostRows>& conditions, int count) {
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

void write_back(const LocalRows& local, const std::vector<glm::dvec3>& origins, int first, int count, EdgeRows& to) {
  for (int row = first; row < count; ++row) {
    for (std::size_t i = 0; i < origins.size(); ++i) to.rows[row][i] = given_at(local.rows[row][i], origins[i]);
  }
}

void follow(const EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational,
            std::optional<Constants> before) {
  const std::vector<glm::dvec3> origins = origins_of(a.rows[0]);
  LocalRows on_b = local_rows(b, origins);
  follow_locally(local_rows(a, origins), on_b, smoothness, is_rational, before);
  write_back(on_b, origins, 1, rows_of(smoothness), b);
  b.rows[0] = a.rows[0];
}

}  // namespace

void follow(const EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational) {
  follow(a, b, smoothness, is_rational, {});
}

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
  Constants by;
  if (is_geometric(smoothness)) by.k = ratio_for_both(about_edge, moved);
  if (smoothness == PatchSmoothness::g2) by.m = std::nan("");
  by = follow_locally(about_edge, moved, smoothness, is_rational, by);
  move_first(on_a, on_b, conditions(on_a, on_b, by, count), count);
  for (std::size_t i = 0; i < edge.size(); ++i) on_a.rows[0][i].w = edge[i].w;
  write_back(on_a, origins, 0, count, a);
  follow(a, b, smoothness, is_rational, by);
}

}  // namespace splinecore
