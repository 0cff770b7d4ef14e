#include "arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "base/sort_by.hpp"
#include "build/curve_parts.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/measure/bounding_box.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"

namespace splinecore {

namespace {

/// Where a curve is to be cut.
struct OutlineCut {
  std::size_t outline;
  double at;
  glm::dvec3 point;
  bool is_knot = false;
  std::size_t vertex = 0;
};

glm::dvec3 place_on(const NurbsCurve& curve, double at) {
  glm::dvec3 point;
  evaluate(curve, {&at, 1}, std::span(&point.x, 3));
  return point;
}

/// From one parameter on to another one, over the end of the curve where that is not behind it. A turn added to a parameter and taken
/// away again would leave it beside a knot by rounding.
NurbsCurve stretch_of(const NurbsCurve& curve, double from, double to) {
  if (to > from) return part(curve, from, to);
  const Interval domain = curve.domain();
  const NurbsCurve before = part(curve, from, domain.end);
  if (to == domain.start) return before;
  const NurbsCurve behind = part(curve, domain.start, to);
  return joined(before, with_domain(behind, {domain.end, domain.end + behind.domain().length()}), Smoothness::c0).value;
}

bool do_meet(const Box& a, const Box& b, double room) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] > b.high[axis] + room || b.low[axis] > a.high[axis] + room) return false;
  }
  return true;
}

/// Finds cuts and vertices of plain closed curves, and makes edges of them.
class Arranger {
 public:
  Arranger(std::span<const NurbsCurve> curves, double tolerance) : tolerance_(tolerance) {
    for (const NurbsCurve& curve : curves) {
      curves_.push_back(clamped(curve));
      boxes_.push_back(bounding_box(curves_.back()));
    }
  }

  void cut_pairs(std::span<const std::size_t> owners) {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      for (std::size_t j = i + 1; j < curves_.size(); ++j) {
        if (owners[i] == owners[j] || !do_meet(boxes_[i], boxes_[j], tolerance_)) continue;
        add(i, j, intersections(curves_[i], curves_[j], tolerance_));
      }
    }
  }

  void cut_itself() { add(0, 0, self_intersections(curves_[0], tolerance_)); }

  Arrangement made() && {
    find_vertices();
    cut_at_vertices_of_others();
    for (std::size_t i = 0; i < curves_.size(); ++i) add_edges(i);
    return std::move(made_);
  }

 private:
  void add(std::size_t i, std::size_t j, const CurveIntersections& found) {
    for (const CurveIntersection& place : found.places) {
      add_cut(i, place.a, place.point);
      add_cut(j, place.b, place.point);
    }
    for (const CurveOverlap& overlap : found.overlaps) {
      for (const bool is_end : {false, true}) {
        const double a = inside(i, is_end ? overlap.a.end : overlap.a.start);
        const double b = inside(j, is_end != overlap.is_reversed ? overlap.b.end : overlap.b.start);
        const glm::dvec3 point = place_on(curves_[i], a);
        add_cut(i, a, point);
        add_cut(j, b, point);
      }
    }
  }

  double inside(std::size_t i, double at) const {
    const Interval domain = curves_[i].domain();
    return at >= domain.end ? std::clamp(at - domain.length(), domain.start, domain.end) : at;
  }

  /// At a knot that is next to the place: no span is left that is nothing but rounding.
  void add_cut(std::size_t i, double given, const glm::dvec3& point) {
    const Interval domain = curves_[i].domain();
    const double at = inside(i, given);
    const auto knots = curves_[i].knot_vector().knots();
    const auto behind = std::ranges::lower_bound(knots, at);
    for (const auto knot : {behind, behind == knots.begin() ? behind : behind - 1}) {
      if (knot == knots.end() || *knot < domain.start || *knot > domain.end) continue;
      const glm::dvec3 place = place_on(curves_[i], *knot);
      if (glm::distance(place, point) > kVertex * tolerance_) continue;
      cuts_.push_back({i, inside(i, *knot), place, true});
      return;
    }
    cuts_.push_back({i, at, point});
  }

  /// Of cuts that are near each other; at knots where there are some.
  void find_vertices() {
    std::vector<std::size_t> order(cuts_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    sort_by(order, [&](std::size_t i) { return cuts_[i].point.x; });
    std::vector<std::size_t> first(cuts_.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
      while (first[i] != i) i = first[i] = first[first[i]];
      return i;
    };
    const double near = kVertex * tolerance_;
    for (auto a = order.begin(); a != order.end(); ++a) {
      for (auto b = a + 1; b != order.end() && cuts_[*b].point.x - cuts_[*a].point.x <= near; ++b) {
        if (glm::distance(cuts_[*a].point, cuts_[*b].point) <= near) first[root(*b)] = root(*a);
      }
    }
    std::vector<std::optional<std::size_t>> numbers(cuts_.size());
    for (const bool of_knots : {true, false}) {
      for (std::size_t i = 0; i < cuts_.size(); ++i) {
        std::optional<std::size_t>& number = numbers[root(i)];
        if (number || cuts_[i].is_knot != of_knots) continue;
        number = made_.vertices.size();
        made_.vertices.push_back(cuts_[i].point);
      }
    }
    for (std::size_t i = 0; i < cuts_.size(); ++i) cuts_[i].vertex = *numbers[root(i)];
  }

  /// Of three curves that run along each other one may meet the others where it is not cut.
  void cut_at_vertices_of_others() {
    const std::size_t known = cuts_.size();
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      std::vector<bool> is_cut(made_.vertices.size(), false);
      for (std::size_t k = 0; k < known; ++k) {
        if (cuts_[k].outline == i) is_cut[cuts_[k].vertex] = true;
      }
      std::vector<std::size_t> numbers;
      std::vector<glm::dvec3> points;
      for (std::size_t v = 0; v < made_.vertices.size(); ++v) {
        const glm::dvec3& point = made_.vertices[v];
        if (is_cut[v] || !do_meet({point, point}, boxes_[i], 2.0 * tolerance_)) continue;
        numbers.push_back(v);
        points.push_back(point);
      }
      std::vector<NearestOnCurve> found(points.size());
      nearest(curves_[i], points, found, 1);
      for (std::size_t k = 0; k < found.size(); ++k) {
        if (found[k].distance > 2.0 * tolerance_) continue;
        add_cut(i, found[k].parameter, points[k]);
        cuts_.back().vertex = numbers[k];
      }
    }
  }

  void add_edges(std::size_t i) {
    made_.outlines.emplace_back();
    std::vector<OutlineCut> own;
    std::ranges::copy_if(cuts_, std::back_inserter(own), [&](const OutlineCut& cut) { return cut.outline == i; });
    std::ranges::stable_sort(own, {}, &OutlineCut::at);
    const Interval domain = curves_[i].domain();
    const auto is_same = [&](const OutlineCut& a, const OutlineCut& b) { return b.at - a.at <= kSame * domain.length(); };
    own.erase(std::unique(own.begin(), own.end(), is_same), own.end());
    if (own.empty()) {
      own.push_back({i, domain.start, {}, true, made_.vertices.size()});
      made_.vertices.push_back(place_on(curves_[i], own[0].at));
    }
    for (std::size_t k = 0; k < own.size(); ++k) {
      const OutlineCut& next = own[k + 1 == own.size() ? 0 : k + 1];
      const NurbsCurve stretch = stretch_of(curves_[i], own[k].at, next.at);
      if (own[k].vertex == next.vertex && own.size() > 1 && is_speck(stretch, made_.vertices[next.vertex])) continue;
      made_.outlines[i].push_back(made_.edges.size());
      made_.edges.push_back({between(stretch, own[k].vertex, next.vertex), own[k].vertex, next.vertex});
    }
  }

  bool is_speck(const NurbsCurve& curve, const glm::dvec3& vertex) const {
    return std::ranges::all_of(samples_of(curve), [&](const glm::dvec3& p) {
      return glm::distance(p, vertex) <= 2.0 * kVertex * tolerance_;
    });
  }

  NurbsCurve between(const NurbsCurve& curve, std::size_t from, std::size_t to) const {
    std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
    points.front() = glm::dvec4(made_.vertices[from], points.front().w);
    points.back() = glm::dvec4(made_.vertices[to], points.back().w);
    const bool is_standard = points.front().w == 1.0 && points.back().w == 1.0;
    NurbsCurve made = curve.with_points(std::move(points));
    return is_standard ? made : standard_form(made);
  }

  static constexpr double kSame = 0x1p-40;  ///< parameters so near, by the length of a domain, are one

  double tolerance_;
  std::vector<NurbsCurve> curves_;
  std::vector<Box> boxes_;
  std::vector<OutlineCut> cuts_;
  Arrangement made_;
};

}  // namespace

Arrangement arranged(std::span<const NurbsCurve> curves, std::span<const std::size_t> owners, double tolerance) {
  Arranger arranger(curves, tolerance);
  arranger.cut_pairs(owners);
  return std::move(arranger).made();
}

Arrangement arranged_with_itself(const NurbsCurve& curve, double tolerance) {
  Arranger arranger({&curve, 1}, tolerance);
  arranger.cut_itself();
  return std::move(arranger).made();
}

std::vector<glm::dvec3> places_along(const NurbsCurve& curve, int count) {
  const Interval domain = curve.domain();
  std::vector<double> at;
  for (int k = 0; k < count; ++k) at.push_back(std::lerp(domain.start, domain.end, (k + 0.5) / count));
  std::vector<glm::dvec3> points(at.size());
  evaluate(curve, at, std::span(&points[0].x, 3 * points.size()));
  return points;
}

}  // namespace splinecore
