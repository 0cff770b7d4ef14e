#include "network_curves.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/sort_by.hpp"
#include "curve/near_knot.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"

namespace splinecore {

namespace {

using Table = std::vector<std::vector<double>>;

/// Where each curve meets each other one, from both sides: [i][j] and [j][i].
struct NetworkCrossings {
  Table on_u;
  Table on_v;
  double missed = 0.0;
};

/// Of curves about 1 large: so near they meet, and where they are farther apart than this they only pass one another.
constexpr double kMet = 0x1p-30;

double least_distance(const NurbsCurve& a, const NurbsCurve& b) {
  constexpr int kPlaces = 257;
  const Interval domain = a.domain();
  std::vector<double> at(kPlaces);
  for (int k = 0; k < kPlaces; ++k) at[k] = k + 1 < kPlaces ? domain.start + domain.length() * k / (kPlaces - 1) : domain.end;
  std::vector<glm::dvec3> points(kPlaces);
  evaluate(a, at, {&points.front().x, 3 * points.size()});
  std::vector<NearestOnCurve> found(kPlaces);
  nearest(b, points, found);
  return std::ranges::min_element(found, {}, &NearestOnCurve::distance)->distance;
}

/// Where curves meet to the last digits, if that is in one place; else all places within the gap, which may be anywhere in what is so
/// near.
CurveIntersections meets_of(const NurbsCurve& a, const NurbsCurve& b, double gap) {
  if (gap > kMet) {
    CurveIntersections closely = intersections(a, b, kMet);
    if (closely.places.size() == 1 && closely.overlaps.empty()) return closely;
  }
  return intersections(a, b, gap);
}

std::string pair_text(std::size_t i, std::size_t j) { return "along_u" + index_text(i) + " and along_v" + index_text(j); }

std::vector<std::size_t> order_of(const std::vector<double>& parameters) {
  std::vector<std::size_t> order(parameters.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sort_by(order, [&](std::size_t i) { return parameters[i]; });
  return order;
}

void require_lengths(std::span<const NurbsCurve> curves, const char* name) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto points = curves[i].points();
    const auto is_first = [&](const glm::dvec4& p) { return distance_of(glm::dvec3(p), glm::dvec3(points.front())) <= kMet; };
    if (!std::ranges::all_of(points, is_first)) continue;
    throw InvalidShape(std::string(name) + index_text(i) + " is a point: curves of a network have a length");
  }
}

/// @param on  where each of the curves meets the others
void require_apart(std::span<const NurbsCurve> curves, const Table& on, const char* name, const char* others) {
  constexpr double kSame = 0x1p-40;
  for (std::size_t i = 0; i < on.size(); ++i) {
    const std::vector<std::size_t> order = order_of(on[i]);
    const double length = curves[i].domain().length();
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool is_last = k + 1 == order.size();
      if (is_last && !is_closed(curves[i])) continue;
      const std::size_t next = order[is_last ? 0 : k + 1];
      if (on[i][next] - on[i][order[k]] + (is_last ? length : 0.0) > kSame * length) continue;
      const auto [first, second] = std::minmax(order[k], next);
      throw InvalidShape(std::string(others) + index_text(first) + " and " + others + index_text(second) + " cross " + name +
                         index_text(i) + " in one place: they are to lie apart");
    }
  }
}

NetworkCrossings crossings_of(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v, double gap,
                              double unit) {
  NetworkCrossings found{Table(along_u.size(), std::vector<double>(along_v.size())),
                  Table(along_v.size(), std::vector<double>(along_u.size()))};
  for (std::size_t i = 0; i < along_u.size(); ++i) {
    for (std::size_t j = 0; j < along_v.size(); ++j) {
      const CurveIntersections meets = meets_of(along_u[i], along_v[j], gap);
      if (!meets.overlaps.empty()) throw InvalidShape(pair_text(i, j) + " lie on each other: they are to cross once");
      if (meets.places.empty()) {
        throw InvalidShape(pair_text(i, j) + " do not meet: they come to " +
                           text_of(unit * least_distance(along_u[i], along_v[j])) + " of each other, the gap that is allowed is " +
                           text_of(unit * gap));
      }
      const CurveIntersection& nearest_place = *std::ranges::min_element(meets.places, {}, &CurveIntersection::distance);
      const auto are_as_near = [&](const CurveIntersection& one) { return one.distance <= std::max(kMet, nearest_place.distance); };
      if (meets.places.size() > 1 && std::ranges::count_if(meets.places, are_as_near) != 1) {
        throw InvalidShape(pair_text(i, j) + " meet in " + std::to_string(meets.places.size()) +
                           " places: they are to cross once");
      }
      found.missed = std::max(found.missed, nearest_place.distance);
      found.on_u[i][j] = nearest_place.a;
      found.on_v[j][i] = nearest_place.b;
    }
  }
  return found;
}

template <class Item>
std::vector<Item> in_order(const std::vector<Item>& items, const std::vector<std::size_t>& order) {
  std::vector<Item> found;
  for (const std::size_t i : order) found.push_back(items[i]);
  return found;
}

bool are_all_closed(std::span<const NurbsCurve> curves) {
  return std::ranges::all_of(curves, [](const NurbsCurve& curve) { return is_closed(curve); });
}

/// How many steps round go up: of a closed curve all but one, if it runs in the order of the others.
std::size_t rises(const std::vector<double>& at) {
  std::size_t count = 0;
  for (std::size_t j = 0; j < at.size(); ++j) count += at[(j + 1) % at.size()] > at[j] ? 1 : 0;
  return count;
}

/// The other way round, over the same domain.
void turn(NurbsCurve& curve, std::vector<double>& at) {
  const Interval before = curve.domain();
  curve = with_domain(reversed(curve), before);
  for (double& u : at) u = before.start + (before.end - u);
}

/// The point half-way from the first crossing to the second, or from that on to the first again.
glm::dvec3 point_between(const NurbsCurve& curve, const std::vector<double>& at, bool is_second) {
  const Interval domain = curve.domain();
  const double period = domain.length();
  double from = is_second ? at[1] : at[0];
  double to = is_second ? at[0] : at[1];
  if (to < from) to += period;
  double middle = 0.5 * (from + to);
  if (middle > domain.end) middle -= period;
  glm::dvec3 point;
  evaluate(curve, {&middle, 1}, std::span(&point.x, 3));
  return point;
}

/// Whether a closed curve that two others cross runs against the one beside it.
bool runs_against(const NurbsCurve& curve, const std::vector<double>& at, const glm::dvec3& beside) {
  return distance_of(point_between(curve, at, true), beside) < distance_of(point_between(curve, at, false), beside);
}

/// From the first crossing on, once round, over one period that begins there.
FormerSeam begin_at_first(NurbsCurve& curve, std::vector<double>& at) {
  if (!curve.periodic()) curve = made_periodic(curve).value;
  const Interval before = curve.domain();
  const double period = before.length();
  constexpr double kSame = 0x1p-40;
  const double near = std::max(kSame, knot_rounding(curve.domain())) * period;
  const double start = curve.knot_vector().admit(near_knot(curve.knot_vector(), at.front(), near), Side::right);
  curve = with_seam_at(curve, start);
  for (double& u : at) {
    while (u < start) u += period;
    while (u >= start + period) u -= period;
  }
  at.front() = start;
  at.push_back(curve.domain().end);
  return {before.start < start ? before.start + period : before.start, before};
}

/// The length of the control polygon.
double polygon_length(const NurbsCurve& curve) {
  double sum = 0.0;
  const auto points = curve.points();
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance_of(glm::dvec3(points[i - 1]), glm::dvec3(points[i]));
  return sum;
}

/// Between the outermost crossings, or up to an end that lies less than a length beyond.
NurbsCurve without_ends(const NurbsCurve& curve, std::vector<double>& at, double length) {
  const Interval whole = curve.domain();
  const auto is_end = [&](double from, double to) { return !(from < to) || polygon_length(part(curve, from, to)) <= length; };
  if (is_end(whole.start, at.front())) at.front() = whole.start;
  if (is_end(at.back(), whole.end)) at.back() = whole.end;
  const bool is_whole = at.front() == whole.start && at.back() == whole.end;
  return clamped(is_whole ? curve : part(curve, at.front(), at.back()));
}

/// Brings the curves of a family into the order of the others, whose order stands.
/// @param order  numbers of the curves as they are given
/// @param name   of the family
/// @param length  ends that are not longer are not cut off
void run_along(NetworkFamily& family, const std::vector<std::size_t>& order, const char* name, double length) {
  family.order = order;
  std::optional<glm::dvec3> beside;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    NurbsCurve& curve = family.curves[i];
    std::vector<double>& at = family.crossings[i];
    const auto refuse = [&] {
      throw InvalidShape(std::string(name) + index_text(order[i]) + " crosses the others in another order than its neighbors");
    };
    if (family.is_closed) {
      if (at.size() > 2 && rises(at) != at.size() - 1) turn(curve, at);
      if (at.size() > 2 && rises(at) != at.size() - 1) refuse();
      if (at.size() == 2 && beside && runs_against(curve, at, *beside)) turn(curve, at);
      beside = point_between(curve, at, false);
      family.seams.push_back(begin_at_first(curve, at));
      continue;
    }
    if (at.front() > at.back()) turn(curve, at);
    if (!std::ranges::is_sorted(at)) refuse();
    curve = without_ends(curve, at, length);
    at.front() = curve.domain().start;
    at.back() = curve.domain().end;
  }
}

}  // namespace

NetworkCurves network_curves(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v, double gap,
                             double unit) {
  for (const auto& [family, name] : {std::pair{along_u, "along_u"}, std::pair{along_v, "along_v"}}) {
    if (family.size() < 2) throw InvalidShape(std::string(name) + " has fewer than two curves");
    require_lengths(family, name);
  }
  const NetworkCrossings found = crossings_of(along_u, along_v, gap, unit);
  require_apart(along_u, found.on_u, "along_u", "along_v");
  require_apart(along_v, found.on_v, "along_v", "along_u");
  const std::vector<std::size_t> order_u = order_of(found.on_v[0]);
  const std::vector<std::size_t> order_v = order_of(found.on_u[0]);
  NetworkCurves network;
  network.missed = found.missed;
  network.u.is_closed = are_all_closed(along_u);
  network.v.is_closed = are_all_closed(along_v);
  network.u.curves = in_order(std::vector(along_u.begin(), along_u.end()), order_u);
  network.v.curves = in_order(std::vector(along_v.begin(), along_v.end()), order_v);
  for (const std::size_t i : order_u) network.u.crossings.push_back(in_order(found.on_u[i], order_v));
  for (const std::size_t j : order_v) network.v.crossings.push_back(in_order(found.on_v[j], order_u));
  run_along(network.u, order_u, "along_u", gap);
  run_along(network.v, order_v, "along_v", gap);
  return network;
}

}  // namespace splinecore
