#include "edge_fit.hpp"

#include <algorithm>
#include <cmath>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

int rows_of(PatchSmoothness smoothness) noexcept {
  if (smoothness == PatchSmoothness::c0) return 1;
  return smoothness == PatchSmoothness::c1 || smoothness == PatchSmoothness::g1 ? 2 : 3;
}

bool is_geometric(PatchSmoothness smoothness) noexcept {
  return smoothness == PatchSmoothness::g1 || smoothness == PatchSmoothness::g2;
}

void require_legs(const LocalRows& on) {
  double longest = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < on.rows[0].size(); ++i) {
    longest = std::max(longest, glm::length(glm::dvec3(on.rows[1][i])));
    weight = std::max(weight, std::abs(on.rows[1][i].w));
  }
  if (longest <= kRoundingOfShape * weight * largest_coordinate(on.source->rows[0])) {
    throw InvalidShape("a patch leaves the edge in no direction: its points beside the edge lie on it");
  }
}

namespace {

/// The given form of a local point.
glm::dvec4 given_at(const glm::dvec4& local, const glm::dvec3& origin) {
  return local.w == 0.0 ? local : glm::dvec4(origin + glm::dvec3(local) / local.w, local.w);
}

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

}  // namespace

Constants follow_locally(const LocalRows& a, LocalRows& b, PatchSmoothness smoothness, bool is_rational,
                         KnownRatios known) {
  const int count = rows_of(smoothness);
  b.rows[0] = a.rows[0];
  Constants by;
  if (count >= 2) {
    if (is_geometric(smoothness)) by.k = known.k ? *known.k : ratio_for_b(a, b);
    const NextRow next = next_row(a, b, 1, by);
    if (is_rational) by.g = weight_constant(next, a.rows[0], b.rows[1]);
    b.rows[1] = finished(next, a.rows[0], by.g, is_rational);
  }
  if (count >= 3) {
    if (is_geometric(smoothness)) by.m = known.m ? *known.m : turn_for_b(a, b, by);
    const NextRow next = next_row(a, b, 2, by);
    if (is_rational) by.e = weight_constant(next, a.rows[0], b.rows[2]);
    b.rows[2] = finished(next, a.rows[0], by.e, is_rational);
  }
  return by;
}

void write_back(const LocalRows& local, const std::vector<glm::dvec3>& origins, int first, int last, EdgeRows& to) {
  for (int row = first; row < last; ++row) {
    for (std::size_t i = 0; i < origins.size(); ++i) to.rows[row][i] = given_at(local.rows[row][i], origins[i]);
  }
}

void follow(const EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational, KnownRatios known) {
  const std::vector<glm::dvec3> origins = origins_of(a.rows[0]);
  LocalRows on_b = local_rows(b, origins);
  follow_locally(local_rows(a, origins), on_b, smoothness, is_rational, known);
  write_back(on_b, origins, 1, rows_of(smoothness), b);
  b.rows[0] = a.rows[0];
}

void follow(const EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational) {
  follow(a, b, smoothness, is_rational, {});
}

}  // namespace splinecore
