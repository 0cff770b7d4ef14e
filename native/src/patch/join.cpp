#include "splinecore/patch/join.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/quotient.hpp"
#include "base/rounding.hpp"
#include "common_edge.hpp"
#include "edge_rows.hpp"
#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

constexpr std::array<const char*, 4> kNames{"u_start", "u_end", "v_start", "v_end"};

/// @throws InvalidShape if the side is no edge. @param which  "first"
void require_edge(const NurbsPatch& patch, Border side, const char* which) {
  const std::string name = "side '" + std::string(kNames[static_cast<int>(side)]) + "' of the " + which + " patch ";
  if (patch.knot_vector(axis_of(side)).periodic()) {
    throw InvalidShape(name + "is the seam of a periodic direction: it has nothing to join");
  }
  const NurbsPatch whole = clamped(patch, axis_of(side));
  const Lines lines = lines_of(whole, axis_of(side));
  std::vector<glm::dvec4> edge;
  for (std::size_t i = 0; i < lines.count; ++i) {
    edge.push_back(whole.points()[lines.at(i, is_at_end(side) ? lines.size - 1 : 0)]);
  }
  if (std::ranges::all_of(edge, [](const glm::dvec4& p) { return p.w == 0.0; })) {
    throw InvalidShape(name + "lies at infinity");
  }
  const bool is_in_sight = std::ranges::none_of(edge, [](const glm::dvec4& p) { return p.w == 0.0; });
  if (is_in_sight && extent(edge) <= kRoundingOfShape * largest_coordinate(patch.points())) {
    throw InvalidShape(name + "is one point: an edge without length cannot be joined");
  }
}

/// The sum of squared distances at places t and, on the other side, t or 1 - t; places at infinity are left out.
struct Nearness {
  double along = 0.0;
  double against = 0.0;

  bool is_tie(double size) const {
    constexpr double kTie = 1e-9;
    return std::abs(along - against) <= kTie * size * size;
  }
};

glm::dvec3 point_at(const NurbsCurve& curve, double t) {
  const Interval domain = curve.domain();
  const double u = t < 1.0 ? domain.start + t * domain.length() : domain.end;
  glm::dvec3 point;
  evaluate(curve, {&u, 1}, std::span(&point.x, 3),
           {.side = t < 1.0 ? Side::right : Side::left, .at_infinity = AtInfinity::nan});
  return point;
}

Nearness nearness(const NurbsCurve& a, const NurbsCurve& b, std::span<const double> places) {
  Nearness found;
  for (const double t : places) {
    const glm::dvec3 on_a = point_at(a, t);
    const glm::dvec3 along = point_at(b, t) - on_a;
    const glm::dvec3 against = point_at(b, 1.0 - t) - on_a;
    if (!is_finite(along) || !is_finite(against)) continue;
    found.along += glm::dot(along, along);
    found.against += glm::dot(against, against);
  }
  return found;
}

bool runs_against(const NurbsCurve& a, const NurbsCurve& b) {
  constexpr std::array<double, 2> kEnds{0.0, 1.0};
  constexpr std::array<double, 2> kQuarters{0.25, 0.75};
  const double size = std::max(extent(a.points()), extent(b.points()));
  const Nearness of_ends = nearness(a, b, kEnds);
  const Nearness found = of_ends.is_tie(size) ? nearness(a, b, kQuarters) : of_ends;
  return !found.is_tie(size) && found.against < found.along;
}

/// The factor by which b's weights come nearest to a's, in the sum of squares.
double weight_factor(const EdgeRow& a, const EdgeRow& b) {
  double largest = 0.0;
  for (const glm::dvec4& p : b) largest = std::max(largest, std::abs(p.w));
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += a[i].w * (b[i].w / largest);
    square += (b[i].w / largest) * (b[i].w / largest);
  }
  const double factor = product / square / largest;
  return factor == 0.0 || std::abs(factor - 1.0) <= kRoundingOfShape ? 1.0 : factor;
}

NurbsPatch with_weights_times(const NurbsPatch& patch, double factor) {
  if (factor == 1.0) return patch;
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (glm::dvec4& p : points) p = p.w == 0.0 ? factor * p : glm::dvec4(glm::dvec3(p), factor * p.w);
  return patch.with_points(std::move(points));
}

/// Of a degree across the side at which the opposite one is not among the rows that move.
NurbsPatch with_room(const NurbsPatch& patch, Border side, PatchSmoothness smoothness) {
  const int rows = rows_of(smoothness);
  NurbsPatch raised = patch;
  const Axis axis = axis_of(side);
  while (raised.knot_vector(axis).degree() < rows - 1 || raised.count(axis) < rows + 1) raised = elevated(raised, axis);
  return raised;
}

std::vector<std::size_t> in_order(std::size_t count) {
  std::vector<std::size_t> columns(count);
  for (std::size_t i = 0; i < count; ++i) columns[i] = i;
  return columns;
}

PatchJoin joined_near_one(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                          PatchSmoothness smoothness, bool is_first_moved, std::optional<bool> reversed) {
  const bool is_reversed = reversed ? *reversed : run_against(a, side_a, b, side_b);
  CommonEdge edge = on_common_edge(a, side_a, b, side_b, is_reversed);
  const auto columns_of_a = in_order(edge.columns_of_b.size());
  if (is_first_moved) edge.a = with_room(edge.a, side_a, smoothness);
  edge.b = with_room(edge.b, side_b, smoothness);
  const double unit = std::max(first_step(edge.a, side_a), first_step(edge.b, side_b));
  EdgeRows rows_a = edge_rows(edge.a, side_a, columns_of_a, Heading::out_of_patch, unit);
  EdgeRows rows_b = edge_rows(edge.b, side_b, edge.columns_of_b, Heading::into_patch, unit);
  const double factor = weight_factor(rows_a.rows[0], rows_b.rows[0]);
  edge.b = with_weights_times(edge.b, factor);
  rows_b = edge_rows(edge.b, side_b, edge.columns_of_b, Heading::into_patch, unit);
  const bool is_rational = edge.a.rational() || edge.b.rational();
  if (is_first_moved) {
    meet(rows_a, rows_b, smoothness, is_rational);
  } else {
    follow(rows_a, rows_b, smoothness, is_rational);
  }
  const int count = rows_of(smoothness);
  PatchJoin join{edge.a, with_edge_rows(edge.b, side_b, edge.columns_of_b, rows_b, count)};
  if (is_first_moved) {
    join.first = with_edge_rows(edge.a, side_a, columns_of_a, rows_a, count);
    join.first_error = largest_distance(a, join.first);
  }
  join.second_error = largest_distance(b, join.second);
  join.reversed = is_reversed;
  return join;
}

/// Coordinates times 2^exponent.
NurbsPatch scaled(const NurbsPatch& patch, int exponent) {
  if (exponent == 0) return patch;
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (glm::dvec4& p : points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::scalbn(p[axis], exponent);
  }
  return patch.with_points(std::move(points));
}

/// A power of two that brings both to the size of one; none where squares stay in range as they are.
int exponent_of(const NurbsPatch& a, const NurbsPatch& b) {
  constexpr int kNear = 100;
  const double largest = std::max(largest_coordinate(a.points()), largest_coordinate(b.points()));
  const int exponent = largest > 0.0 ? std::ilogb(largest) : 0;
  return std::abs(exponent) < kNear ? 0 : exponent;
}

}  // namespace

bool run_against(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b) {
  return runs_against(boundary(a, side_a), boundary(b, side_b));
}

PatchJoin joined_patches(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                         PatchSmoothness smoothness, JoinMoves moves, std::optional<bool> reversed) {
  require_edge(a, side_a, "first");
  require_edge(b, side_b, "second");
  const int exponent = exponent_of(a, b);
  const NurbsPatch first = scaled(a, -exponent);
  const NurbsPatch second = scaled(b, -exponent);
  const bool is_swapped = moves == JoinMoves::first;
  PatchJoin join =
      is_swapped ? joined_near_one(second, side_b, first, side_a, smoothness, false, reversed)
                 : joined_near_one(first, side_a, second, side_b, smoothness, moves == JoinMoves::both, reversed);
  if (is_swapped) {
    std::swap(join.first, join.second);
    std::swap(join.first_error, join.second_error);
  }
  return {scaled(join.first, exponent), scaled(join.second, exponent), std::scalbn(join.first_error, exponent),
          std::scalbn(join.second_error, exponent), join.reversed};
}

}  // namespace splinecore
