#include "rim_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>

#include "base/length.hpp"
#include "patch/lines.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

std::array<glm::dvec3, 2> jet_of(const NurbsCurve& curve, double at) {
  std::array<glm::dvec3, 2> jet;
  derivatives(curve, {&at, 1}, 1, std::span(&jet[0].x, 6));
  return jet;
}

/// A parameter that is a knot but for rounding is that knot.
double near_knot(const KnotVector& knots, double u) {
  constexpr double kSame = 0x1p-36;
  for (const double knot : knots.knots()) {
    if (std::abs(knot - u) <= kSame) return knot;
  }
  return u;
}

/// A patch that is periodic along u over [0, 1], begun at another u.
NurbsPatch begun_at(const NurbsPatch& patch, double u) {
  const double start = near_knot(patch.knot_vector(Axis::u), u - std::floor(u));
  if (start == 0.0 || start == 1.0) return patch;
  const NurbsPatch turned = along(patch, Axis::u, [&](const NurbsCurve& line) { return with_seam_at(line, start); });
  return with_domain(turned, Axis::u, {0.0, 1.0});
}

/// Whether the side v_end is a point.
bool ends_in_point(const NurbsPatch& patch, double tolerance) {
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  const auto points = patch.points();
  for (std::size_t i = count_v - 1; i < points.size(); i += count_v) {
    if (!(distance_of(glm::dvec3(points[i]), glm::dvec3(points[count_v - 1])) <= tolerance)) return false;
  }
  return true;
}

glm::dvec3 point_at(const NurbsCurve& curve, double u) { return jet_of(curve, u)[0]; }

double nearest_place(const NurbsCurve& curve, const glm::dvec3& point) {
  NearestOnCurve found;
  nearest(curve, {&point, 1}, {&found, 1});
  return found.parameter;
}

}  // namespace

bool is_closed(const NurbsPatch& patch) {
  constexpr double kSame = 0x1p-40;
  if (patch.knot_vector(Axis::u).periodic()) return true;
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  const auto points = patch.points();
  for (std::size_t j = 0; j < count_v; ++j) {
    if (!(distance_of(glm::dvec3(points[j]), glm::dvec3(points[points.size() - count_v + j])) <= kSame)) return false;
  }
  return true;
}

NurbsPatch closed_up(const NurbsPatch& patch) {
  return patch.knot_vector(Axis::u).periodic() ? patch : made_periodic(patch, Axis::u).value;
}

std::vector<double> places_along(const NurbsPatch& a, const NurbsPatch& b) {
  constexpr std::array kShares{0.0, 0.13, 0.31, 0.5, 0.72, 0.89};
  std::vector<double> places{1.0};
  for (const NurbsPatch* const patch : {&a, &b}) {
    const KnotVector& knots = patch->knot_vector(Axis::u);
    for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
      const Interval span = knots.span_interval(i);
      for (const double share : kShares) places.push_back(span.start + share * span.length());
    }
  }
  return places;
}

double gap_between(const NurbsPatch& a, const NurbsPatch& b) {
  const std::vector<double> u = places_along(a, b);
  const double start[] = {0.0};
  std::vector<glm::dvec3> on_a(u.size());
  std::vector<glm::dvec3> on_b(u.size());
  evaluate_grid(a, u, start, std::span(&on_a.front().x, 3 * on_a.size()));
  evaluate_grid(b, u, start, std::span(&on_b.front().x, 3 * on_b.size()));
  double gap = 0.0;
  for (std::size_t k = 0; k < u.size(); ++k) gap = std::max(gap, distance_of(on_a[k], on_b[k]));
  return gap;
}

RimPlaces::RimPlaces(NurbsCurve first, NurbsCurve second)
    : first_(std::move(first)), second_(std::move(second)), length_(length(first_, first_.domain()).value) {}

std::vector<double> RimPlaces::between(double from, double to, std::span<const double> shares) const {
  const double both[] = {from - std::floor(from), to - std::floor(to)};
  const std::vector<double> rest = lengths_at_parameters(first_, both);
  const double start = rest[0] + std::floor(from) * length_;
  const double end = rest[1] + std::floor(to) * length_;
  std::vector<double> found(shares.begin(), shares.end());
  for (double& share : found) share = std::lerp(start, end, share);
  return parameters_at_lengths(first_, found);
}

double RimPlaces::on_first(double u_of_second) const { return nearest_place(first_, point_at(second_, u_of_second)); }
double RimPlaces::on_second(double u_of_first) const { return nearest_place(second_, point_at(first_, u_of_first)); }

double RimPlaces::gap() const {
  constexpr int kPlaces = 97;
  double largest = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const double u = static_cast<double>(k) / kPlaces;
    const glm::dvec3 on_first = point_at(first_, u);
    const glm::dvec3 on_second = point_at(second_, u);
    largest = std::max({largest, distance_of(on_first, point_at(second_, nearest_place(second_, on_first))),
                        distance_of(on_second, point_at(first_, nearest_place(first_, on_second)))});
  }
  return largest;
}

std::optional<BesideEdge> beside_rim(const NurbsPatch& given_first, const NurbsPatch& given_second, double tolerance) {
  if (!is_closed(given_first) || !is_closed(given_second)) return {};
  const NurbsPatch first = closed_up(given_first);
  const NurbsPatch second = closed_up(given_second);
  const NurbsCurve rim = boundary(first, Border::v_start);
  const NurbsCurve own = boundary(second, Border::v_start);
  const auto [point, way] = jet_of(rim, 0.0);
  const bool is_reversed = glm::dot(jet_of(own, nearest_place(own, point))[1], way) < 0.0;
  const NurbsPatch turned = is_reversed ? reversed(second, Axis::u) : second;
  RimPlaces places(rim, boundary(turned, Border::v_start));
  if (!(places.gap() <= tolerance)) return {};
  if (ends_in_point(second, tolerance)) {
    const NurbsPatch begun = begun_at(turned, places.on_second(0.0));
    if (gap_between(first, begun) <= tolerance) return BesideEdge{first, begun, is_reversed, {}};
  }
  return BesideEdge{first, turned, is_reversed, std::move(places)};
}

}  // namespace splinecore
