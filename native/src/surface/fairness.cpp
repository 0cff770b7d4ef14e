#include "fairness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "base/length.hpp"
#include "basis/gauss_legendre.hpp"
#include "basis/selection.hpp"
#include "kink.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// Places in every span, by shares of it.
std::vector<double> places_in(const KnotVector& knots, std::span<const double> shares) {
  std::vector<double> found;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (const double share : shares) found.push_back(span.start + share * span.length());
  }
  return found;
}

/// Of a surface, or a place of it: the area, and times that the sum of both curvatures, and of their squares.
struct BendingSums {
  double area = 0.0;
  double curvatures = 0.0;
  double squares = 0.0;
};

BendingSums sums_at(const glm::dvec3* d) {
  const glm::dvec3& u = d[3];
  const glm::dvec3& v = d[1];
  const glm::dvec3 normal = glm::cross(u, v);
  const double area = length_of(normal);
  const double e = glm::dot(u, u);
  const double f = glm::dot(u, v);
  const double g = glm::dot(v, v);
  const double square = area * area;
  if (!(square > 0.0)) return {};
  const double l = glm::dot(d[6], normal) / area;
  const double m = glm::dot(d[4], normal) / area;
  const double n = glm::dot(d[2], normal) / area;
  const double twice_mean = (e * n - 2.0 * f * m + g * l) / square;
  const double gauss = (l * n - m * m) / square;
  return {area, twice_mean * area, (twice_mean * twice_mean - 2.0 * gauss) * area};
}

glm::dvec3 normal_at(const NurbsPatch& patch, double u, double v) {
  std::array<glm::dvec3, 4> d;
  derivatives(patch, std::span(&u, 1), std::span(&v, 1), 1, std::span(&d.front().x, 3 * d.size()));
  return glm::cross(d[2], d[1]);
}

/// Four places with their normals, in order round them.
struct NormalCell {
  std::array<double, 2> u;
  std::array<double, 2> v;
  std::array<glm::dvec3, 4> normals;

  /// The least cosine between two of them.
  double least() const {
    double found = 1.0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const double lengths = length_of(normals[i]) * length_of(normals[k]);
        if (lengths > 0.0) found = std::min(found, glm::dot(normals[i], normals[k]) / lengths);
      }
    }
    return found;
  }
};

/// Whether normals turn round in a cell as far as it may be halved.
bool turns_round(const NurbsPatch& patch, const NormalCell& cell, int halvings) {
  constexpr double kNear = 0.5;
  const double least = cell.least();
  if (least > kNear) return false;
  if (halvings == 0) return least < 0.0;
  const double u = 0.5 * (cell.u[0] + cell.u[1]);
  const double v = 0.5 * (cell.v[0] + cell.v[1]);
  const glm::dvec3 middle = normal_at(patch, u, v);
  const std::array<glm::dvec3, 4> sides{normal_at(patch, u, cell.v[0]), normal_at(patch, cell.u[1], v),
                                        normal_at(patch, u, cell.v[1]), normal_at(patch, cell.u[0], v)};
  const auto& n = cell.normals;
  const std::array<NormalCell, 4> parts{NormalCell{{cell.u[0], u}, {cell.v[0], v}, {n[0], sides[0], middle, sides[3]}},
                                  NormalCell{{u, cell.u[1]}, {cell.v[0], v}, {sides[0], n[1], sides[1], middle}},
                                  NormalCell{{u, cell.u[1]}, {v, cell.v[1]}, {middle, sides[1], n[2], sides[2]}},
                                  NormalCell{{cell.u[0], u}, {v, cell.v[1]}, {sides[3], middle, sides[2], n[3]}}};
  return std::ranges::any_of(parts, [&](const NormalCell& part) { return turns_round(patch, part, halvings - 1); });
}

/// The least cosine between normals beside a corner of borders: a crease where these turn round as sharply is no fold.
double crease_limit(const NurbsCurve& one, const NurbsCurve& other, double knot) {
  constexpr double kSharper = 1.25;
  const double turn = kSharper * std::max(kink_angle(one, knot), kink_angle(other, knot));
  return std::cos(std::clamp(turn, 0.5 * std::numbers::pi, std::numbers::pi));
}

/// Places of one direction in every span, closer towards its ends.
struct SampledLines {
  std::vector<double> at;
  std::size_t in_span;
  std::vector<std::optional<double>> creases;  ///< behind each span

  SampledLines(const NurbsPatch& patch, Axis axis) {
    constexpr int kMostPlaces = 128;
    constexpr int kMostInSpan = 32;
    constexpr double kFromEnds = 0.01;
    const KnotVector& knots = patch.knot_vector(axis);
    const int spans = static_cast<int>(knots.spans().size());
    const int count = std::clamp(kMostPlaces / spans, knots.degree() + 3, kMostInSpan);
    std::vector<double> shares;
    for (int k = 0; k < count; ++k) {
      const double share = 0.5 * (1.0 - std::cos(std::numbers::pi * k / (count - 1)));
      shares.push_back(kFromEnds + (1.0 - 2.0 * kFromEnds) * share);
    }
    at = places_in(knots, shares);
    in_span = shares.size();
    const bool is_u = axis == Axis::u;
    const NurbsCurve one = boundary(patch, is_u ? Border::v_start : Border::u_start);
    const NurbsCurve other = boundary(patch, is_u ? Border::v_end : Border::u_end);
    for (int i = 0; i + 1 < static_cast<int>(knots.spans().size()); ++i) {
      const double knot = knots.span_interval(i).end;
      const bool is_smooth = multiplicity(knots, knot) < knots.degree();
      creases.push_back(is_smooth ? std::nullopt : std::optional(crease_limit(one, other, knot)));
    }
  }

  /// Where a crease follows a place: the least cosine over it.
  std::optional<double> crease_behind(std::size_t place) const {
    return (place + 1) % in_span == 0 && place + 1 < at.size() ? creases[place / in_span] : std::nullopt;
  }
};

/// Among places of one span along u, and towards the next one.
bool is_folded_along(const NurbsPatch& patch, const SampledLines& lines_u, const SampledLines& lines_v, std::size_t first) {
  constexpr int kHalvings = 1;
  constexpr double kAllNear = 0.9;
  const std::vector<double>& v = lines_v.at;
  const std::size_t end = std::min(first + lines_u.in_span + 1, lines_u.at.size());
  const std::span<const double> u = std::span(lines_u.at).subspan(first, end - first);
  std::vector<glm::dvec3> normals(u.size() * v.size());
  std::vector<glm::dvec3> points(normals.size());
  breathe(normals.size());
  evaluate_grid_with_normals(patch, u, v, std::span(&points.front().x, 3 * points.size()),
                             std::span(&normals.front().x, 3 * normals.size()));
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    const std::optional<double> over_u = lines_u.crease_behind(first + i);
    for (std::size_t k = 0; k + 1 < v.size(); ++k) {
      const glm::dvec3* const n = &normals[i * v.size() + k];
      const std::optional<double> over_v = lines_v.crease_behind(k);
      if (over_u || over_v) {
        if (over_u && glm::dot(n[0], n[v.size()]) < *over_u) return true;
        if (over_v && glm::dot(n[0], n[1]) < *over_v) return true;
        continue;
      }
      const double over_both = glm::dot(n[0], n[v.size() + 1]);
      const double least = std::min({glm::dot(n[0], n[1]), glm::dot(n[0], n[v.size()]), over_both});
      if (least > kAllNear) continue;
      const NormalCell cell{{u[i], u[i + 1]}, {v[k], v[k + 1]}, {n[0], n[v.size()], n[v.size() + 1], n[1]}};
      if (turns_round(patch, cell, kHalvings)) return true;
    }
  }
  return false;
}

}  // namespace

SurfaceBending bending_of(std::span<const NurbsPatch> patches) {
  constexpr int kMostPlaces = 128;
  constexpr int kLeastInSpan = 2;
  BendingSums sum;
  for (const NurbsPatch& patch : patches) {
    std::array<std::vector<double>, 2> at;
    std::array<std::vector<double>, 2> weights;
    for (const Axis axis : {Axis::u, Axis::v}) {
      const KnotVector& knots = patch.knot_vector(axis);
      const int spans = static_cast<int>(knots.spans().size());
      const GaussRule rule = gauss_legendre(std::clamp(kMostPlaces / spans, kLeastInSpan, knots.degree() + 1));
      const auto side = static_cast<std::size_t>(axis);
      at[side] = places_in(knots, rule.nodes);
      for (int i = 0; i < spans; ++i) {
        for (const double weight : rule.weights) weights[side].push_back(weight * knots.span_interval(i).length());
      }
    }
    std::vector<glm::dvec3> line(9 * at[1].size());
    for (std::size_t i = 0; i < at[0].size(); ++i) {
      breathe(line.size());
      const std::vector<double> u(at[1].size(), at[0][i]);
      derivatives(patch, u, at[1], 2, std::span(&line.front().x, 3 * line.size()));
      for (std::size_t k = 0; k < at[1].size(); ++k) {
        const double weight = weights[0][i] * weights[1][k];
        const BendingSums here = sums_at(&line[9 * k]);
        sum.area += weight * here.area;
        sum.curvatures += weight * here.curvatures;
        sum.squares += weight * here.squares;
      }
    }
  }
  if (!(sum.area > 0.0)) return {};
  return {sum.squares, sum.squares - 0.5 * sum.curvatures * sum.curvatures / sum.area};
}

bool is_folded(const NurbsPatch& patch) {
  const SampledLines u(patch, Axis::u);
  const SampledLines v(patch, Axis::v);
  for (std::size_t first = 0; first < u.at.size(); first += u.in_span) {
    if (is_folded_along(patch, u, v, first)) return true;
  }
  return false;
}

}  // namespace splinecore
