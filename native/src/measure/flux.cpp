#include "splinecore/measure/flux.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "adaptive_pieces.hpp"
#include "base/placement.hpp"
#include "closed_set.hpp"
#include "finite_weights.hpp"
#include "placed_patches.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "surface_nodes.hpp"

namespace splinecore {

namespace {

constexpr const char* kWhat = "the flux cannot be found";

/// The flux, and what flows through to either side.
constexpr std::size_t kFlows = 2;
using FlowPiece = MeasuredPiece<kFlows>;

std::string place_text(const glm::dvec3& p) {
  return "(" + text_of(p.x) + ", " + text_of(p.y) + ", " + text_of(p.z) + ")";
}

double sum_of_sizes(const glm::dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

/// Asks a field on pieces in their place.
class Flow {
 public:
  Flow(const VectorField& field, const Placement& placement, std::vector<SurfaceNodes> nodes)
      : field_(field), placement_(placement), nodes_(std::move(nodes)) {}

  void measure(std::span<FlowPiece> pieces) {
    constexpr std::size_t kAtOnce = 64;
    for (std::size_t first = 0; first < pieces.size(); first += kAtOnce) {
      const auto some = pieces.subspan(first, std::min(kAtOnce, pieces.size() - first));
      ask(some);
      for (std::size_t k = 0; k < some.size(); ++k) some[k].found = sums(k * kGridNodes * kGridNodes);
    }
  }

 private:
  /// How a surface lies at a node: its normal, as long as it is wide, and how long that might have been.
  struct Way {
    glm::dvec3 normal;
    double size;
  };

  void ask(std::span<const FlowPiece> pieces) {
    points_.clear();
    ways_.clear();
    for (const FlowPiece& piece : pieces) {
      for (std::size_t i = 0; i < kGridNodes; ++i) {
        for (std::size_t j = 0; j < kGridNodes; ++j) {
          const SurfacePlace place = nodes_[piece.patch].at(piece.piece.net, i, j);
          points_.push_back(given_point(place.point, placement_));
          ways_.push_back({glm::cross(place.along_u, place.along_v), glm::length(place.along_u) * glm::length(place.along_v)});
        }
      }
    }
    vectors_.assign(points_.size(), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    field_(points_, vectors_);
    for (std::size_t i = 0; i < points_.size(); ++i) require_number(i);
  }

  void require_number(std::size_t i) const {
    constexpr double kMost = 1e290;
    const glm::dvec3& vector = vectors_[i];
    if (sum_of_sizes(vector) <= kMost) return;
    const bool is_large = std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
    throw InvalidShape("the field is " + place_text(vector) + " at the point " + place_text(points_[i]) +
                       (is_large ? ": too large for its flux" : ": it is not finite there"));
  }

  /// Of the piece whose nodes begin there.
  IntegralSums<kFlows> sums(std::size_t first) const {
    return grid_sums<kFlows>([&](std::size_t i, std::size_t j) {
      const std::size_t at = first + i * kGridNodes + j;
      const glm::dvec3& vector = vectors_[at];
      const double through = glm::dot(vector, ways_[at].normal);
      const double terms = (sum_of_sizes(vector) + (j > 0 ? slip(at) : 0.0)) * ways_[at].size;
      return Integrands<kFlows>{{through, std::abs(through)}, {terms, terms}};
    });
  }

  /// What the field would change by if a point were as far off as it is from the origin: in proportion, that is what
  /// rounding of the point's coordinates does to it.
  double slip(std::size_t at) const {
    const double step = sum_of_sizes(points_[at] - points_[at - 1]);
    const double slope = sum_of_sizes(vectors_[at] - vectors_[at - 1]) / step;
    return step > 0.0 ? slope * sum_of_sizes(points_[at]) : 0.0;
  }

  const VectorField& field_;
  const Placement& placement_;
  std::vector<SurfaceNodes> nodes_;
  std::vector<glm::dvec3> points_;
  std::vector<glm::dvec3> vectors_;
  std::vector<Way> ways_;
};

Approximation<double> flux_through(std::span<const NurbsPatch* const> patches, const Placement& placement,
                                   const VectorField& field, double tolerance) {
  for (const NurbsPatch* patch : patches) require_finite_points(*patch);
  const std::vector<NurbsPatch> placed = placed_patches(patches, placement);
  Flow flow(field, placement, nodes_of(placed));
  AdaptivePieces<kFlows> adaptive(kWhat, [&](std::span<FlowPiece> pieces) { flow.measure(pieces); });
  for (const NurbsPatch& patch : placed) adaptive.add(patch);
  const auto allowed = [&](const IntegralSums<kFlows>& sums) { return tolerance * sums.values[1]; };
  const auto [sums, excess] = adaptive.found([&](const IntegralSums<kFlows>& found) {
    return Integrals<kFlows>{allowed(found), std::numeric_limits<double>::infinity()};
  });
  if (excess > 1.0) {
    throw ToleranceNotReached(kWhat, given_size(allowed(sums), 2, placement), given_size(sums.error(0), 2, placement));
  }
  const double error = sums.error(0) + sums.rounding(0);
  return {finite_size(sums.values[0], 2, placement, "flux"), given_size(error, 2, placement)};
}

}  // namespace

Approximation<double> flux(const NurbsPatch& patch, const VectorField& field, double tolerance) {
  require_relative(tolerance);
  const NurbsPatch* one = &patch;
  return flux_through({&one, 1}, placement_of(patch.points()), field, tolerance);
}

Approximation<double> flux(const PatchSet& set, const VectorField& field, double tolerance) {
  require_relative(tolerance);
  return flux_through(patches_of(set), placement_of(set.points()), field, tolerance);
}

}  // namespace splinecore
