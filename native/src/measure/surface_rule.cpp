#include "surface_rule.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "kernels/kernels.hpp"
#include "kronrod_21.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Both ends, where the rules see nothing, lie among the first nodes, and one twice to fill the lanes.
constexpr std::size_t kEnds = 3;
constexpr std::size_t kPlaces = kEnds + 2 * kKronrod21.size() - 1;
static_assert(kPlaces % 4 == 0);

struct Rule {
  std::array<double, kPlaces> at{0.0, 1.0, 1.0};
  std::array<double, kPlaces> rest{1.0, 0.0, 0.0};  ///< 1 - at
  std::array<double, kPlaces> shares{};
  std::array<double, kPlaces> differences{};
};

constexpr Rule kRule = [] {
  Rule rule;
  for (std::size_t i = 0; i < kPlaces - kEnds; ++i) {
    const bool is_low = i < kKronrod21.size();
    const KronrodNode& node = kKronrod21[is_low ? i : kPlaces - kEnds - 1 - i];
    rule.at[kEnds + i] = is_low ? node.at : 1.0 - node.at;
    rule.rest[kEnds + i] = is_low ? 1.0 - node.at : node.at;
    rule.shares[kEnds + i] = node.kronrod;
    rule.differences[kEnds + i] = node.kronrod - node.gauss;
  }
  return rule;
}();

double ratio_of(double low, double high) {
  if (low > 0.0) return high / low;
  return high < 0.0 ? low / high : std::numeric_limits<double>::infinity();
}

/// Where the normals point between the corners; zero if they do not tell.
glm::dvec3 direction_of(const BernsteinNet<glm::dvec4>& net) {
  const auto corners = net.corners();
  std::array<glm::dvec3, 4> at;
  for (int i = 0; i < 4; ++i) at[i] = glm::dvec3(corners[i]) / corners[i].w;
  const glm::dvec3 normal = glm::cross(at[3] - at[0], at[1] - at[2]);
  const double length = glm::length(normal);
  return length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0);
}

/// What the largest of a piece's homogeneous points is worth where weights have both signs: there points may be far
/// larger than those that the piece is made of.
double reach_of(const SurfacePiece& piece) {
  double reach = 0.0;
  if (!piece.is_mixed) return reach;
  for (const glm::dvec4& p : piece.net.values) reach = std::max(reach, glm::length(glm::dvec3(p)));
  return reach;
}

}  // namespace

Unevenness SurfacePiece::unevenness(Axis axis) const {
  const bool is_u = axis == Axis::u;
  Unevenness most;
  for (std::size_t i = 0; i < (is_u ? net.columns : net.rows); ++i) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (std::size_t j = 0; j < net.count(axis); ++j) {
      const double w = is_u ? net.at(j, i).w : net.at(i, j).w;
      low = std::min(low, w);
      high = std::max(high, w);
    }
    most.ratio = std::max(most.ratio, ratio_of(low, high));
    most.spread = std::max(most.spread, high - low);
  }
  return most;
}

void SurfacePiece::halve(Axis axis, SurfacePiece& second) {
  second.origin = origin;
  second.extent = extent;
  second.is_mixed = is_mixed;
  net.halve(axis, second.net);
  normalize();
  second.normalize();
}

void SurfacePiece::normalize() {
  constexpr int kNear = 100;
  const auto [low, high] = net.range(&glm::dvec4::w);
  const double largest = std::max(-low, high);
  if (!(largest > 0.0) || std::ilogb(largest) > -kNear) return;
  const int exponent = -std::ilogb(largest);
  for (glm::dvec4& p : net.values) {
    for (int i = 0; i < 4; ++i) p[i] = std::scalbn(p[i], exponent);
  }
}

SurfaceIntegral::Functions::Functions(int degree)
    : values(kPlaces * (degree + 1)), slopes(values.size()), steps(kPlaces) {
  std::vector<double> own(degree + 1);
  std::vector<double> less(degree);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    bernstein(degree, kRule.at[i], kRule.rest[i], own);
    bernstein(degree - 1, kRule.at[i], kRule.rest[i], less);
    for (int k = 0; k <= degree; ++k) {
      const double slope = degree * ((k > 0 ? less[k - 1] : 0.0) - (k < degree ? less[k] : 0.0));
      values[k * kPlaces + i] = own[k];
      slopes[k * kPlaces + i] = slope;
      steps[i] += std::abs(slope);
    }
  }
}

SurfaceIntegral::SurfaceIntegral(int degree_u, int degree_v)
    : u_(degree_u), v_(degree_v), points_(degree_v + 1), slopes_(points_.size()) {}

void SurfaceIntegral::sum_line(const BernsteinNet<glm::dvec4>& net, std::size_t node) {
  std::ranges::fill(points_, glm::dvec4(0.0));
  std::ranges::fill(slopes_, glm::dvec4(0.0));
  for (std::size_t k = 0; k < net.rows; ++k) {
    const double value = u_.values[k * kPlaces + node];
    const double slope = u_.slopes[k * kPlaces + node];
    const glm::dvec4* const from = &net.at(k, 0);
    for (std::size_t j = 0; j < net.columns; ++j) {
      points_[j] += value * from[j];
      slopes_[j] += slope * from[j];
    }
  }
}

PieceIntegral SurfaceIntegral::operator()(const SurfacePiece& piece, Integrand integrand) {
  // As wide as what lies between an end and the nearest node: a fold there is seen by the ends alone.
  constexpr double kUnseen = kKronrod21[0].at;
  breathe(kPlaces * (8 * piece.net.values.size() + kPlaces * (12 * piece.net.columns + 60)));
  const SurfaceRule rule{.degree = piece.net.degree(Axis::v),
                         .nodes = kPlaces,
                         .values = v_.values.data(),
                         .slopes = v_.slopes.data(),
                         .steps = v_.steps.data(),
                         .shares = kRule.shares.data(),
                         .differences = kRule.differences.data()};
  const glm::dvec3 direction = direction_of(piece.net);
  const glm::dvec3& origin = piece.origin;
  const glm::dvec3& extent = piece.extent;
  SurfaceRow row{.points = &points_.front().x,
                 .slopes = &slopes_.front().x,
                 .step = 0.0,
                 .extent = {extent.x, extent.y, extent.z},
                 .reach = reach_of(piece),
                 .origin = {origin.x, origin.y, origin.z},
                 .direction = {direction.x, direction.y, direction.z}};
  PieceIntegral found;
  SurfaceSums sums;
  std::array<double, 2> against{};
  for (std::size_t i = 0; i < kPlaces; ++i) {
    if (i == kEnds - 1) continue;
    sum_line(piece.net, i);
    row.step = u_.steps[i];
    kernels().surface_sums(rule, row, &sums);
    const double(&line)[3] = integrand == Integrand::area ? sums.area : sums.volume;
    found.value += kRule.shares[i] * line[0];
    found.errors[0] += kRule.differences[i] * line[0];
    found.errors[1] += kRule.shares[i] * line[1];
    found.terms += kRule.shares[i] * line[2];
    if (i < kEnds) against[0] = std::max(against[0], sums.against);
    against[1] = std::max(against[1], sums.against_at_ends);
  }
  for (int axis = 0; axis < 2; ++axis) {
    found.errors[axis] = std::abs(found.errors[axis]);
    if (integrand == Integrand::area) found.errors[axis] += kUnseen * against[axis];
  }
  return found;
}

}  // namespace splinecore
