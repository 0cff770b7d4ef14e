#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/sort_by.hpp"
#include "curve_patch_pairs.hpp"
#include "near_space.hpp"
#include "plane_patch.hpp"
#include "splinecore/meet/intersections.hpp"
#include "zero_between.hpp"

namespace splinecore {

namespace {

/// Stretches of a curve that follow each other, as places of it, and the patch beside their middles.
struct Cluster {
  Interval along;
  std::vector<std::pair<double, PatchSpot>> feet;
};

/// How a curve lies beside a patch.
struct Beside {
  PierceSpot at;
  double height;  ///< along the normal
  double slope;   ///< the sine of the angle to the tangent plane
};

class PierceOutcome {
 public:
  PierceOutcome(const NurbsCurve& curve, const NurbsPatch& patch, std::optional<double> tolerance)
      : space_(together(curve.points(), patch.points())), curve_(curve, space_), patch_(patch, space_), domain_(curve.domain()) {
    tolerance_ = place_tolerance(space_, tolerance);
  }

  PatchIntersections found() const {
    const PiercePairFindings pairs = find_pairs(shapes(), tolerance_);
    const std::vector<Cluster> clusters = clusters_of(pairs.stretches);
    PatchIntersections found;
    std::vector<Place> places;
    for (const Cluster& cluster : clusters) add(cluster, found, places);
    for (const PierceSpot& crossing : pairs.crossings) {
      const double at = curve_.place(crossing.curve);
      const bool is_known = std::ranges::any_of(clusters, [&](const Cluster& c) {
        return are_beside(c.along, {at, at});
      });
      if (!is_known) places.push_back({crossing, false});
    }
    found.places = once_each(std::move(places));
    return found;
  }

 private:
  struct Place {
    PierceSpot at;
    bool touches;
  };

  CurveAndPatch shapes() const { return {curve_, patch_}; }

  std::vector<Cluster> clusters_of(std::vector<CurveOnPatch> stretches) const {
    const auto along = [this](const CurveOnPatch& s) {
      return Interval{curve_.place({s.piece, s.range.start}), curve_.place({s.piece, s.range.end})};
    };
    sort_by(stretches, [&](const CurveOnPatch& s) { return along(s).start; });
    std::vector<Cluster> clusters;
    for (const CurveOnPatch& stretch : stretches) {
      const Interval own = along(stretch);
      if (clusters.empty() || !are_beside(clusters.back().along, own)) clusters.push_back({own, {}});
      clusters.back().along.end = std::max(clusters.back().along.end, own.end);
      clusters.back().feet.emplace_back(own.middle(), stretch.patch);
    }
    return clusters;
  }

  /// Whether the curve stays within the tolerance from one stretch to the other.
  bool are_beside(const Interval& one, const Interval& other) const {
    const double before = std::min(one.end, other.end);
    const double behind = std::max(one.start, other.start);
    return behind <= before || behind - before <= curve_.reach(before, 1.0, tolerance_);
  }

  Beside beside(const Cluster& cluster, double place) const {
    const CurveSpot spot = curve_.spot(place);
    const Slopes<1> c = curve_.at(spot);
    const auto from = [&](const auto& foot) { return std::abs(foot.first - place); };
    const PatchSpot foot = patch_foot(patch_, std::ranges::min_element(cluster.feet, {}, from)->second, c.point);
    const Slopes<2> s = patch_.at(foot, c.point);
    const glm::dvec3 normal = glm::cross(s.first[0], s.first[1]);
    const double length = glm::length(normal);
    const double speed = glm::length(c.first[0]);
    if (!(length > 0.0 && speed > 0.0)) return {{spot, foot}, 0.0, 1.0};
    return {{spot, foot}, -glm::dot(s.offset, normal) / length, glm::dot(c.first[0], normal) / (length * speed)};
  }

  /// An overlap, or the place where a curve touches the patch or goes through it at a small angle.
  void add(const Cluster& cluster, PatchIntersections& found, std::vector<Place>& places) const {
    constexpr std::size_t kCount = 33;
    // Curves that only touch are nearly a tolerance apart along most of a cluster.
    constexpr double kOne = 0x1p-6;
    std::array<double, kCount> at{};
    std::array<double, kCount> distances{};
    std::size_t near = 0;
    double length = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
      at[i] = cluster.along.start + cluster.along.length() * static_cast<double>(i) / (kCount - 1);
      distances[i] = shapes().distance(beside(cluster, at[i]).at);
      near += distances[i] <= kOne * tolerance_ ? 1 : 0;
      if (i > 0) length += glm::distance(curve_.at(curve_.spot(at[i])).point, curve_.at(curve_.spot(at[i - 1])).point);
    }
    if (length > 8.0 * tolerance_ && 4 * near >= 3 * kCount) {
      found.overlaps.push_back({parameter(cluster.along.start), parameter(cluster.along.end)});
      return;
    }
    const auto best = static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
    const auto height = [&](double place) { return beside(cluster, place).height; };
    const auto slope = [&](double place) { return beside(cluster, place).slope; };
    const Interval around{at[best == 0 ? 0 : best - 1], at[std::min(best + 1, kCount - 1)]};
    double place = at[best];
    if (height(at.front()) * height(at.back()) < 0.0) {
      place = zero_between({at.front(), at.back()}, height);
    } else if (slope(around.start) * slope(around.end) < 0.0) {
      place = zero_between(around, slope);
    }
    Beside there = beside(cluster, place);
    // Where the patch is but a line its normals are noise, and so are heights.
    if (shapes().distance(there.at) > tolerance_) there = beside(cluster, at[best]);
    if (shapes().distance(there.at) > tolerance_) return;
    constexpr double kParallel = 1e-6;
    const double at_ends = std::max(std::abs(slope(at.front())), std::abs(slope(at.back())));
    places.push_back({there.at, std::abs(there.slope) <= std::max(0.5 * at_ends, kParallel)});
  }

  double parameter(double place) const { return curve_.parameter(curve_.spot(place)); }

  std::vector<PatchIntersection> once_each(std::vector<Place> places) const {
    sort_by(places, [&](const Place& p) { return SortKey{p.touches ? 0.0 : 1.0, shapes().distance(p.at)}; });
    std::vector<PierceSpot> known;
    std::vector<PatchIntersection> found;
    for (const Place& place : places) {
      const glm::dvec3 on_curve = curve_.at(place.at.curve).point;
      const bool is_known = std::ranges::any_of(known, [&](const PierceSpot& other) {
        return curve_.are_one(place.at.curve, other.curve, tolerance_);
      });
      if (is_known) continue;
      known.push_back(place.at);
      const glm::dvec3 gap = patch_.at(place.at.patch, on_curve).offset;
      const double t = curve_.parameter(place.at.curve);
      found.push_back({curve_.is_closed() && t >= domain_.end ? domain_.start : t, patch_.parameters(place.at.patch),
                       space_.leave(on_curve + 0.5 * gap), space_.length(glm::length(gap)), place.touches});
    }
    sort_by(found, [](const PatchIntersection& place) { return place.t; });
    return found;
  }

  NearSpace space_;
  CurvePieces curve_;
  PatchPieces patch_;
  Interval domain_;
  double tolerance_;
};

}  // namespace

PatchIntersections intersections(const NurbsCurve& curve, const NurbsPatch& patch, std::optional<double> tolerance) {
  return PierceOutcome(curve, patch, tolerance).found();
}

PatchIntersections intersections(const NurbsCurve& curve, const Plane& plane, std::optional<double> tolerance) {
  return PierceOutcome(curve, plane_about(curve.points(), plane), tolerance).found();
}

}  // namespace splinecore
