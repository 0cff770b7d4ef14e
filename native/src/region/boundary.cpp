#include "boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "arrangement.hpp"
#include "base/placement.hpp"
#include "edge_groups.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/measure/bounding_box.hpp"
#include "splinecore/measure/plane_curve.hpp"
#include "splinecore/meet/nearest.hpp"
#include "traced_loops.hpp"

namespace splinecore {

namespace {

/// By halves: to put one behind the other would copy all before it each time.
NurbsCurve put_together(std::span<const NurbsCurve> curves) {
  if (curves.size() == 1) return curves.front();
  const std::size_t middle = curves.size() / 2;
  const NurbsCurve before = put_together(curves.first(middle));
  const NurbsCurve behind = put_together(curves.subspan(middle));
  const double start = before.domain().end;
  return joined(before, with_domain(behind, {start, start + behind.domain().length()}), Smoothness::c0).value;
}

/// The curve of edges that go round: that which all of them were, if it is one.
NurbsCurve curve_of(const Arrangement& all, std::span<const NurbsCurve> given, const std::vector<GroupedEdge>& loop) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::vector<std::size_t>& own = all.outlines[i];
    const bool is_reversed = loop[0].is_reversed;
    const bool is_whole = own.size() == loop.size() && std::ranges::all_of(loop, [&](const GroupedEdge& one) {
      return one.is_reversed == is_reversed && std::ranges::find(own, one.edge) != own.end();
    });
    if (is_whole) return is_reversed ? reversed(given[i]) : given[i];
  }
  std::vector<NurbsCurve> curves;
  for (const GroupedEdge& one : loop) {
    const NurbsCurve& curve = all.edges[one.edge].curve;
    curves.push_back(one.is_reversed ? reversed(curve) : curve);
  }
  return put_together(curves);
}

/// Windings of places beside edges.
class Windings {
 public:
  Windings(const OwnedLoops& loops, const glm::dvec3& normal, double tolerance)
      : loops_(loops), normal_(normal), tolerance_(tolerance) {
    for (const NurbsCurve& curve : loops.curves) {
      boxes_.push_back(bounding_box(curve));
      runs_left_.push_back(signed_area(curve, normal).value > 0.0);
    }
  }

  /// To the left and to the right of the first edge of a group.
  std::array<std::vector<int>, 2> beside(const Arrangement& all, const EdgeGroup& group, const std::vector<std::size_t>& loop_of) const {
    std::vector<int> left(loops_.owner_count, 0);
    std::vector<int> right = left;
    std::vector<bool> is_done(loops_.curves.size(), false);
    for (const GroupedEdge& one : group) {
      const std::size_t loop = loop_of[one.edge];
      const int turn = runs_left_[loop] ? 1 : -1;
      (runs_left_[loop] != one.is_reversed ? left : right)[loops_.owners[loop]] += turn;
      is_done[loop] = true;
    }
    const std::vector<glm::dvec3> places = places_along(all.edges[group[0].edge].curve, kPlaces);
    for (std::size_t j = 0; j < loops_.curves.size(); ++j) {
      if (is_done[j]) continue;
      const int turns = winding(places, j);
      left[loops_.owners[j]] += turns;
      right[loops_.owners[j]] += turns;
    }
    return {left, right};
  }

 private:
  static constexpr int kPlaces = 8;

  bool is_in_box(const glm::dvec3& place, const Box& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (place[axis] < box.low[axis] - tolerance_ || place[axis] > box.high[axis] + tolerance_) return false;
    }
    return true;
  }

  /// Of the place that is farthest from the loop.
  int winding(const std::vector<glm::dvec3>& places, std::size_t loop) const {
    if (!std::ranges::all_of(places, [&](const glm::dvec3& p) { return is_in_box(p, boxes_[loop]); })) return 0;
    std::vector<NearestOnCurve> found(places.size());
    nearest(loops_.curves[loop], places, found, 1);
    const auto farthest = std::ranges::max_element(found, {}, &NearestOnCurve::distance);
    if (!(farthest->distance > tolerance_)) {
      throw InvalidShape("outlines run along each other within the tolerance, but not as one: another tolerance may tell them apart");
    }
    return winding_number(loops_.curves[loop], places[farthest - found.begin()], normal_);
  }

  const OwnedLoops& loops_;
  glm::dvec3 normal_;
  double tolerance_;
  std::vector<Box> boxes_;
  std::vector<bool> runs_left_;
};

std::vector<std::size_t> loops_of_edges(const Arrangement& all) {
  std::vector<std::size_t> loop_of(all.edges.size());
  for (std::size_t i = 0; i < all.outlines.size(); ++i) {
    for (const std::size_t edge : all.outlines[i]) loop_of[edge] = i;
  }
  return loop_of;
}

/// Lengths as parts of a power of two, so that no square leaves the numbers: exact, there and back.
class UnitScale {
 public:
  explicit UnitScale(std::span<const NurbsCurve> curves) {
    double largest = 0.0;
    for (const NurbsCurve& curve : curves) largest = std::max(largest, largest_coordinate(curve.points()));
    if (largest > 0.0) exponent_ = std::ilogb(largest);
  }

  double in(double length) const { return std::ldexp(length, -exponent_); }
  std::vector<NurbsCurve> in(std::span<const NurbsCurve> curves) const { return scaled(curves, exponent_); }
  std::vector<NurbsCurve> out(std::span<const NurbsCurve> curves) const { return scaled(curves, -exponent_); }

 private:
  static std::vector<NurbsCurve> scaled(std::span<const NurbsCurve> curves, int exponent) {
    std::vector<NurbsCurve> found;
    for (const NurbsCurve& curve : curves) found.push_back(placed(curve, {glm::dvec3(0.0), exponent}));
    return found;
  }

  int exponent_ = 0;
};

std::vector<NurbsCurve> boundary_there(const OwnedLoops& loops, const WindingRule& is_inside, const glm::dvec3& normal, double tolerance) {
  const Arrangement all = arranged(loops.curves, loops.owners, tolerance);
  const Windings windings(loops, normal, tolerance);
  const std::vector<std::size_t> loop_of = loops_of_edges(all);
  std::vector<GroupedEdge> border;
  for (const EdgeGroup& group : edge_groups(all, tolerance)) {
    breathe(loops.curves.size());
    const auto [left, right] = windings.beside(all, group, loop_of);
    const bool is_left = is_inside(left);
    if (is_left != is_inside(right)) border.push_back({group[0].edge, !is_left});
  }
  std::vector<NurbsCurve> found;
  for (const auto& loop : traced_loops(all, border, normal)) found.push_back(curve_of(all, loops.curves, loop));
  return found;
}

/// A closed curve, cut into those that do not meet themselves: without what it goes to and fro.
std::vector<NurbsCurve> simple_loops(const NurbsCurve& curve, double tolerance) {
  const Arrangement all = arranged_with_itself(curve, tolerance);
  std::vector<GroupedEdge> round;
  for (const std::size_t edge : all.outlines[0]) round.push_back({edge, false});
  std::vector<std::size_t> group_of(all.edges.size());
  const std::vector<EdgeGroup> groups = edge_groups(all, tolerance);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const GroupedEdge& one : groups[g]) group_of[one.edge] = g;
  }
  std::vector<NurbsCurve> found;
  for (const auto& loop : cut_at_repeated_vertices(all, round)) {
    const bool is_nothing = loop.size() == 2 && group_of[loop[0].edge] == group_of[loop[1].edge];
    if (!is_nothing) found.push_back(curve_of(all, {&curve, 1}, loop));
  }
  return found;
}

}  // namespace

std::vector<NurbsCurve> boundary_of(const OwnedLoops& loops, const WindingRule& is_inside, const glm::dvec3& normal, double tolerance) {
  const UnitScale scale(loops.curves);
  return scale.out(boundary_there({scale.in(loops.curves), loops.owners, loops.owner_count}, is_inside, normal, scale.in(tolerance)));
}

WoundCurves wound_by(std::span<const NurbsCurve> curves, const std::function<bool(int turns)>& is_inside, const glm::dvec3& normal,
                     double tolerance) {
  const UnitScale scale(curves);
  OwnedLoops loops;
  WoundCurves found;
  std::size_t number = 0;
  for (const NurbsCurve& curve : scale.in(curves)) {
    std::vector<NurbsCurve> simple = simple_loops(curve, scale.in(tolerance));
    if (simple.empty()) found.nothing.push_back(number);
    ++number;
    std::ranges::move(simple, std::back_inserter(loops.curves));
  }
  loops.owner_count = loops.curves.size();
  loops.owners.resize(loops.owner_count);
  std::iota(loops.owners.begin(), loops.owners.end(), std::size_t{0});
  const auto is_in = [&](std::span<const int> windings) { return is_inside(std::accumulate(windings.begin(), windings.end(), 0)); };
  found.loops = scale.out(boundary_there(loops, is_in, normal, scale.in(tolerance)));
  return found;
}

}  // namespace splinecore
