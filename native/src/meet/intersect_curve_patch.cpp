#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "base/sort_by.hpp"
#include "curve_patch_pairs.hpp"
#include "near_space.hpp"
#include "patch_foot.hpp"
#include "patch_sheet.hpp"
#include "plane_patch.hpp"
#include "splinecore/meet/intersections.hpp"
#include "zero_between.hpp"

namespace splinecore {

namespace {

/// They are looked at within so many tolerances: what rounding parts at the edge of the tolerance hangs together so.
/// What stays farther apart than the tolerance is left out in the end.
constexpr double kWide = 1.25;
/// So many places of a cluster are looked at.
constexpr std::size_t kCount = 33;

/// What a curve and a patch have in common that hangs together, as places of the curve, and places of the patch there.
struct Cluster {
  Interval along;
  Interval wide;  ///< with those around that may be within the tolerance
  std::vector<std::pair<double, PatchSpot>> feet;
  std::vector<PierceSpot> crossings;
  bool has_stretches = false;
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
      : space_(together(curve.points(), patch.points())), curve_(curve, space_), patch_(patch, space_),
        domain_(curve.domain()) {
    tolerance_ = place_tolerance(space_, tolerance);
    wide_ = kWide * tolerance_;
  }

  PatchIntersections found() const {
    const PiercePairFindings pairs = find_pairs(shapes(), wide_);
    PatchIntersections found;
    std::vector<Place> places;
    for (const Cluster& cluster : clusters_of(pairs)) add(cluster, found, places);
    found.places = once_each(std::move(places));
    found.overlaps = united(std::move(found.overlaps));
    return found;
  }

 private:
  struct Place {
    PierceSpot at;
    bool touches;
  };

  CurveAndPatch shapes() const { return {curve_, patch_}; }

  Cluster cluster_of(const CurveOnPatch& s) const {
    const Interval own{curve_.place({s.piece, s.range.start}), curve_.place({s.piece, s.range.end})};
    const Interval wide{own.start - curve_.reach(own.start, -1.0, wide_),
                        own.end + curve_.reach(own.end, 1.0, wide_)};
    return {own, wide, {{own.middle(), s.patch}}, {}, true};
  }

  /// Where a curve goes through it is within the tolerance as far as a straight line is.
  Cluster cluster_of(const PierceSpot& at) const {
    constexpr double kMost = 0.5;
    const double place = curve_.place(at.curve);
    const Slopes<1> c = curve_.at(at.curve);
    const Slopes<2> s = patch_.at(at.patch);
    const glm::dvec3 normal = glm::cross(s.first[0], s.first[1]);
    const double rise = std::abs(glm::dot(c.first[0], normal));
    const double far = rise > 0.0 ? std::min(wide_ * glm::length(normal) / rise, kMost) : kMost;
    return {{place, place}, {place - far, place + far}, {{place, at.patch}}, {at}, false};
  }

  /// Along the curve each finding joins those that it hangs together with.
  std::vector<Cluster> clusters_of(const PiercePairFindings& pairs) const {
    std::vector<Cluster> parts;
    for (const CurveOnPatch& stretch : pairs.stretches) parts.push_back(cluster_of(stretch));
    for (const PierceSpot& crossing : pairs.crossings) parts.push_back(cluster_of(crossing));
    sort_by(parts, [](const Cluster& part) { return SortKey{part.wide.start, part.along.start}; });
    std::vector<Cluster> clusters;
    std::vector<Cluster> open;
    for (Cluster& part : parts) {
      const auto behind = std::stable_partition(open.begin(), open.end(), [&](const Cluster& other) {
        return other.wide.end >= part.wide.start;
      });
      std::move(behind, open.end(), std::back_inserter(clusters));
      open.erase(behind, open.end());
      std::vector<Cluster> rest;
      for (Cluster& other : open) {
        if (are_joined(other, part)) {
          join(part, other);
        } else {
          rest.push_back(std::move(other));
        }
      }
      open = std::move(rest);
      open.push_back(std::move(part));
    }
    std::move(open.begin(), open.end(), std::back_inserter(clusters));
    join_at_seam(clusters);
    return clusters;
  }

  /// Of a closed curve what begins at its start goes on from what ends at its end.
  void join_at_seam(std::vector<Cluster>& clusters) const {
    if (!curve_.is_closed()) return;
    const double turn = curve_.turn();
    std::vector<Cluster> starts;
    std::erase_if(clusters, [&](Cluster& cluster) {
      const bool is_start = cluster.wide.start <= 0.0 && cluster.wide.end < turn;
      if (is_start) starts.push_back(further(std::move(cluster), turn));
      return is_start;
    });
    for (Cluster& start : starts) {
      const auto before = std::ranges::find_if(clusters, [&](const Cluster& other) {
        return other.wide.end >= start.wide.start && are_joined(other, start);
      });
      if (before == clusters.end()) {
        clusters.push_back(further(std::move(start), -turn));
      } else {
        join(*before, start);
      }
    }
  }

  static Cluster further(Cluster cluster, double turn) {
    for (Interval* in : {&cluster.along, &cluster.wide}) *in = {in->start + turn, in->end + turn};
    for (auto& foot : cluster.feet) foot.first += turn;
    return cluster;
  }

  static void join(Cluster& into, const Cluster& other) {
    const auto both = [](const Interval& a, const Interval& b) {
      return Interval{std::min(a.start, b.start), std::max(a.end, b.end)};
    };
    into.along = both(into.along, other.along);
    into.wide = both(into.wide, other.wide);
    into.feet.insert(into.feet.end(), other.feet.begin(), other.feet.end());
    into.crossings.insert(into.crossings.end(), other.crossings.begin(), other.crossings.end());
    into.has_stretches = into.has_stretches || other.has_stretches;
  }

  /// Whether the curve stays within the tolerance of the patch, or of a place, from one to the other, on one sheet.
  bool are_joined(const Cluster& one, const Cluster& other) const {
    const double before = std::min(one.along.end, other.along.end);
    const double behind = std::max(one.along.start, other.along.start);
    if (!are_on_one_sheet(one, other, 0.5 * (before + behind))) return false;
    if (behind <= before || behind - before <= curve_.reach(before, 1.0, wide_)) return true;
    constexpr int kPlaces = 16;
    for (int i = 1; i < kPlaces; ++i) {
      const double place = before + (behind - before) * i / kPlaces;
      const auto is_near = [&](const Cluster& from) { return shapes().distance(beside(from, place).at) <= wide_; };
      if (!is_near(one) && !is_near(other)) return false;
    }
    return true;
  }

  /// Whether the places of the patch that two clusters are beside, where these are next to each other, are not two of a
  /// patch that crosses itself.
  bool are_on_one_sheet(const Cluster& one, const Cluster& other, double place) const {
    const PierceSpot on_one = beside(one, place).at;
    const PierceSpot on_other = beside(other, place).at;
    if (std::max(shapes().distance(on_one), shapes().distance(on_other)) > wide_) return true;
    return are_one(on_one, on_other);
  }

  bool are_one(const PierceSpot& one, const PierceSpot& other) const {
    constexpr double kClearly = 64.0;
    const glm::dvec3 point = curve_.at(one.curve).point;
    return splinecore::are_on_one_sheet(patch_, one.patch, other.patch, point, kClearly * tolerance_);
  }

  Beside beside(const Cluster& cluster, double place) const {
    const CurveSpot spot = curve_.spot(place);
    const Slopes<1> c = curve_.at(spot);
    const auto from = [&](const auto& foot) { return std::abs(foot.first - place); };
    const PatchSpot foot = patch_foot(patch_, std::ranges::min_element(cluster.feet, {}, from)->second, c.point);
    const Slopes<2> s = patch_.at(foot, c.point);
    const glm::dvec3 normal = normal_at(foot, s);
    const double length = glm::length(normal);
    const double speed = glm::length(c.first[0]);
    if (!(length > 0.0 && speed > 0.0)) return {{spot, foot}, 0.0, 1.0};
    return {{spot, foot}, -glm::dot(s.offset, normal) / length, glm::dot(c.first[0], normal) / (length * speed)};
  }

  /// At a pole, where the patch stands still along an axis, the normal a little inside.
  glm::dvec3 normal_at(const PatchSpot& foot, const Slopes<2>& there) const {
    constexpr double kStill = 0x1p-30;
    constexpr double kInside = 0x1p-26;
    const double u = glm::length(there.first[0]);
    const double v = glm::length(there.first[1]);
    if (std::min(u, v) > kStill * std::max(u, v)) return glm::cross(there.first[0], there.first[1]);
    PatchSpot inside = foot;
    for (double& t : inside.at) t += kInside * (0.5 - t);
    const Slopes<2> s = patch_.at(inside);
    return glm::cross(s.first[0], s.first[1]);
  }

  static std::array<double, kCount> places_of(const Interval& along) {
    std::array<double, kCount> places{};
    for (std::size_t i = 0; i < kCount; ++i) {
      places[i] = std::lerp(along.start, along.end, static_cast<double>(i) / (kCount - 1));
    }
    return places;
  }

  /// Of a cluster the places from the first to the last one within the tolerance; all where none is seen to be.
  Interval within(const Cluster& cluster) const {
    const auto places = places_of(cluster.along);
    const auto is_near = [&](double place) { return shapes().distance(beside(cluster, place).at) <= tolerance_; };
    const auto first = std::ranges::find_if(places, is_near);
    if (first == places.end()) return cluster.along;
    const auto last = std::ranges::find_if(places.rbegin(), places.rend(), is_near);
    const auto edge = [&](double near, double far) {
      constexpr int kHalvings = 52;
      for (int i = 0; i < kHalvings; ++i) (is_near(0.5 * (near + far)) ? near : far) = 0.5 * (near + far);
      return near;
    };
    return {first == places.begin() ? *first : edge(*first, *std::prev(first)),
            last == places.rbegin() ? *last : edge(*last, *std::prev(last))};
  }

  /// Most of the length of the curve there, whatever its pace: looked at in each of some stretches, too.
  bool is_overlap(const Cluster& cluster, const Interval& along) const {
    // Curves that only touch are nearly a tolerance apart along most of a cluster.
    const double one = distance_of_one(tolerance_, space_.rounding());
    constexpr std::size_t kMost = 64;
    const auto uniform = places_of(along);
    std::vector<double> places(uniform.begin(), uniform.end());
    const std::size_t step = cluster.feet.size() / kMost + 1;
    for (std::size_t i = 0; i < cluster.feet.size(); i += step) {
      places.push_back(std::clamp(cluster.feet[i].first, along.start, along.end));
    }
    std::ranges::sort(places);
    double near = 0.0;
    double length = 0.0;
    bool was_near = false;
    glm::dvec3 before(0.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const PierceSpot at = beside(cluster, places[i]).at;
      const glm::dvec3 point = curve_.at(at.curve).point;
      const double chord = i > 0 ? glm::distance(point, before) : 0.0;
      const bool is_near = shapes().distance(at) <= one;
      length += chord;
      if (is_near && was_near) near += chord;
      was_near = is_near;
      before = point;
    }
    return length > 8.0 * tolerance_ && 4.0 * near >= 3.0 * length;
  }

  /// An overlap, or the place where a curve touches the patch or goes through it at a small angle.
  void add(const Cluster& cluster, PatchIntersections& found, std::vector<Place>& places) const {
    if (!cluster.has_stretches) return add_crossing(cluster, places);
    const Interval along = within(cluster);
    if (is_overlap(cluster, along)) {
      found.overlaps.push_back(overlap(along));
      return;
    }
    const auto at = places_of(along);
    std::array<double, kCount> distances{};
    for (std::size_t i = 0; i < kCount; ++i) distances[i] = shapes().distance(beside(cluster, at[i]).at);
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
    if (shapes().distance(there.at) > tolerance_) {
      if (!cluster.crossings.empty()) return add_crossing(cluster, places);
      const std::optional<Beside> nearest = nearest_of(cluster);
      if (!nearest) return;
      there = *nearest;
    }
    constexpr double kParallel = 1e-6;
    const double at_ends = std::max(std::abs(slope(at.front())), std::abs(slope(at.back())));
    places.push_back({there.at, std::abs(there.slope) <= std::max(0.5 * at_ends, kParallel)});
  }

  /// A place within the tolerance in any of the stretches of a cluster, each looked at by thirds; none if none has one.
  std::optional<Beside> nearest_of(const Cluster& cluster) const {
    constexpr int kThirds = 48;
    for (const auto& [place, spot] : cluster.feet) {
      const auto far = [&](double at) { return shapes().distance(beside(cluster, at).at); };
      Interval in{place - curve_.reach(place, -1.0, tolerance_), place + curve_.reach(place, 1.0, tolerance_)};
      for (int i = 0; i < kThirds; ++i) {
        const double first = in.start + in.length() / 3.0;
        const double second = in.end - in.length() / 3.0;
        if (far(first) < far(second)) {
          in.end = second;
        } else {
          in.start = first;
        }
      }
      const Beside there = beside(cluster, in.middle());
      if (shapes().distance(there.at) <= tolerance_) return there;
    }
    return {};
  }

  void add_crossing(const Cluster& cluster, std::vector<Place>& places) const {
    const auto distance = [&](const PierceSpot& at) { return shapes().distance(at); };
    const PierceSpot nearest = *std::ranges::min_element(cluster.crossings, {}, distance);
    if (distance(nearest) <= tolerance_) places.push_back({nearest, false});
  }

  /// Of a closed curve the end may be a turn further.
  Interval overlap(const Interval& along) const {
    const bool is_beyond = curve_.is_closed() && along.end > curve_.turn();
    return {parameter(along.start), is_beyond ? parameter(along.end) + domain_.length() : parameter(along.end)};
  }

  /// In order; what lies on several sheets is one where they overlap.
  static std::vector<Interval> united(std::vector<Interval> overlaps) {
    sort_by(overlaps, [](const Interval& overlap) { return overlap.start; });
    std::vector<Interval> found;
    for (const Interval& overlap : overlaps) {
      if (found.empty() || overlap.start >= found.back().end) {
        found.push_back(overlap);
      } else {
        found.back().end = std::max(found.back().end, overlap.end);
      }
    }
    return found;
  }

  double parameter(double place) const { return curve_.parameter(curve_.spot(place)); }

  std::vector<PatchIntersection> once_each(std::vector<Place> places) const {
    sort_by(places, [&](const Place& p) { return SortKey{p.touches ? 0.0 : 1.0, shapes().distance(p.at)}; });
    std::vector<PierceSpot> known;
    std::vector<PatchIntersection> found;
    for (const Place& place : places) {
      const glm::dvec3 on_curve = curve_.at(place.at.curve).point;
      const bool is_known = std::ranges::any_of(known, [&](const PierceSpot& other) {
        return curve_.are_one(place.at.curve, other.curve, tolerance_) && are_one(place.at, other);
      });
      if (is_known) continue;
      known.push_back(place.at);
      const glm::dvec3 gap = patch_.at(place.at.patch, on_curve).offset;
      const double t = curve_.parameter(place.at.curve);
      found.push_back({curve_.is_closed() && t >= domain_.end ? domain_.start : t, patch_.parameters(place.at.patch),
                       space_.leave(on_curve + 0.5 * gap), space_.length(glm::length(gap)), place.touches});
    }
    sort_by(found, [](const PatchIntersection& place) { return SortKey{place.t, place.parameters[0]}; });
    return found;
  }

  NearSpace space_;
  CurvePieces curve_;
  PatchPieces patch_;
  Interval domain_;
  double tolerance_;
  double wide_;
};

}  // namespace

PatchIntersections intersections(const NurbsCurve& curve, const NurbsPatch& patch, std::optional<double> tolerance) {
  return PierceOutcome(curve, patch, tolerance).found();
}

PatchIntersections intersections(const NurbsCurve& curve, const Plane& plane, std::optional<double> tolerance) {
  // How large the part of the plane is that is looked at decides nothing.
  const double within = tolerance.value_or(default_place_tolerance(curve.points()));
  return PierceOutcome(curve, plane_about(curve.points(), plane), within).found();
}

}  // namespace splinecore
