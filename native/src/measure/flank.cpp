#include "flank.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <utility>

#include "base/quotient.hpp"
#include "base/rounding.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/measure/patch_curvature.hpp"
#include "tangent_rounding.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The normal curvature in the tangent plane, at right angles to a direction in it.
double curvature_beside(const SurfaceCurvature& found, const glm::dvec3& direction, const glm::dvec3& normal) {
  const glm::dvec3 way = glm::normalize(glm::cross(normal, direction));
  const double x = glm::dot(way, found.directions[0]);
  const double y = glm::dot(way, found.directions[1]);
  return found.principal[0] * x * x + found.principal[1] * y * y;
}

}  // namespace

Flank::Flank(NurbsPatch patch, Border side, Role role, bool is_reversed)
    : patch_(std::move(patch)), side_(side), way_(is_at_end(side) == (role == Role::first) ? 1.0 : -1.0),
      turn_(is_reversed ? -1.0 : 1.0) {
  constexpr double kRounding = 1e-12;
  const double size = extent(patch_.points());
  negligible_ = kRounding * (size / along().domain().length()) * (size / across().domain().length());
  for (int i = 0; i < static_cast<int>(along().spans().size()); ++i) {
    const double knot = along().span_interval(i).start;
    knots_.push_back({share_of(knot), knot});
  }
  if (is_reversed) std::ranges::reverse(knots_);
}

double Flank::share_of(double knot) const {
  const Interval domain = along().domain();
  return (turn_ < 0.0 ? domain.end - knot : knot - domain.start) / domain.length();
}

std::vector<double> Flank::inner_knots() const {
  std::vector<double> shares;
  for (const SharedKnot& knot : knots_) {
    if (knot.knot != along().domain().start) shares.push_back(knot.share);
  }
  return shares;
}

double Flank::parameter_at(double share) const {
  // A knot is met exactly, or the other side of it would be looked at.
  const auto near = std::ranges::lower_bound(knots_, share - kSameShare, {}, &SharedKnot::share);
  if (near != knots_.end() && near->share <= share + kSameShare) return near->knot;
  const Interval domain = along().domain();
  const double from_start = turn_ < 0.0 ? 1.0 - share : share;
  return from_start < 1.0 ? std::min(domain.start + from_start * domain.length(), domain.end) : domain.end;
}

double Flank::room(const SeamPlace& place) const {
  if (place.side == Side::right) {
    const auto end = std::ranges::upper_bound(knots_, place.share + kSameShare, {}, &SharedKnot::share);
    return (end == knots_.end() ? 1.0 : end->share) - place.share;
  }
  const auto end = std::ranges::lower_bound(knots_, place.share - kSameShare, {}, &SharedKnot::share);
  return place.share - (end == knots_.begin() ? 0.0 : std::prev(end)->share);
}

double Flank::weight_spread(double share) const {
  constexpr double kMost = 1e12;
  if (!patch_.rational()) return 1.0;
  const bool is_u = axis_of(side_) == Axis::u;
  const KnotVector& knots = along();
  const int first = knots.spans()[static_cast<std::size_t>(knots.span_of(parameter_at(share), Side::right))] - knots.degree();
  const int across_count = across().count();
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (int k = 0; k <= knots.degree(); ++k) {
    const int line = (first + k) % knots.count();
    for (int i = 0; i < across_count; ++i) {
      const int at = is_u ? i * knots.count() + line : line * across_count + i;
      const double weight = std::abs(patch_.points()[static_cast<std::size_t>(at)].w);
      least = std::min(least, weight);
      most = std::max(most, weight);
    }
  }
  return least * kMost > most ? most / least : kMost;
}

std::vector<SeamJet> Flank::jets(std::span<const SeamPlace> places, SeamDepth depth) const {
  std::vector<SeamJet> found(places.size());
  add(places, Side::right, depth, found);
  add(places, Side::left, depth, found);
  return found;
}

void Flank::add(std::span<const SeamPlace> places, Side side, SeamDepth depth, std::span<SeamJet> jets) const {
  const bool is_u = axis_of(side_) == Axis::u;
  std::vector<double> there;
  for (const SeamPlace& place : places) {
    if (place.side != side) continue;
    breathe(64);
    there.push_back(parameter_at(place.share));
  }
  const std::size_t count = there.size();
  const std::vector<double> edges(count, edge());
  const std::vector<double>& u = is_u ? edges : there;
  const std::vector<double>& v = is_u ? there : edges;
  const Side onward = (side == Side::right) == (turn_ < 0.0) ? Side::left : Side::right;
  const PatchOptions options{is_u ? inward() : onward, is_u ? onward : inward(), AtInfinity::nan};
  if (count == 0) return;
  const bool is_deep = depth == SeamDepth::curvatures;
  const std::size_t width = is_deep ? 9 : 3;  // derivatives() has them by v first
  const std::size_t by_u = is_deep ? 3 : 1;
  const std::size_t by_v = is_deep ? 1 : 2;
  std::vector<glm::dvec3> values(width * count);
  const std::span out(&values[0].x, 3 * values.size());
  is_deep ? derivatives(patch_, u, v, 2, out, options) : first_derivatives(patch_, u, v, out, options);
  std::vector<glm::dvec3> points(count);
  std::vector<glm::dvec3> normals(count);
  evaluate_with_normals(patch_, u, v, std::span(&points[0].x, 3 * count), std::span(&normals[0].x, 3 * count), options);
  std::vector<SurfaceCurvature> bends(is_deep ? count : 0);
  if (is_deep) curvatures(patch_, u, v, bends, options);
  for (std::size_t i = 0, next = 0; i < places.size(); ++i) {
    if (places[i].side != side) continue;
    const glm::dvec3* const at = &values[width * next];
    SeamJet& jet = jets[i];
    jet = jet_of(at[0], at[by_u], at[by_v], normals[next]);
    if (!jet.is_regular && is_finite(jet.point)) {
      jet.is_regular = is_product_known(patch_, u[next], v[next], {at[0], at[by_u], at[by_v]}, options);
    }
    if (is_deep) {
      jet.second_across = at[is_u ? 6 : 2];
      if (glm::length(jet.along) > 0.0) jet.curvature = facing() * curvature_beside(bends[next], jet.along, jet.normal);
    }
    ++next;
  }
}

SeamJet Flank::jet_of(const glm::dvec3& point, const glm::dvec3& by_u, const glm::dvec3& by_v, const glm::dvec3& normal) const {
  const bool is_u = axis_of(side_) == Axis::u;
  SeamJet jet{point, turn_ * (is_u ? by_v : by_u), way_ * (is_u ? by_u : by_v), glm::dvec3(0.0), glm::dvec3(kNan), kNan, false, 0.0};
  const double area = glm::length(glm::cross(jet.across, jet.along));
  jet.is_regular = area > negligible_;
  jet.rise = area / glm::length(jet.along);
  if (is_finite(jet.point) && normal != glm::dvec3(0.0)) jet.normal = facing() * normal;
  return jet;
}

std::array<double, 3> Flank::rounding(double pace) const {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const glm::dvec4& p : patch_.points()) {
    if (p.w != 0.0) least = std::min(least, std::abs(p.w));
    most = std::max(most, std::abs(p.w));
  }
  Stencil stencil(across(), 2);
  stencil.move_to(edge(), inward());
  const Interval domain = along().domain();
  std::array<double, 3> found{kRoundingOfShape * std::max(std::abs(domain.start), std::abs(domain.end)) * pace, 0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (const double weight : stencil.weights(k)) sum += std::abs(weight);
    found[k] += kRoundingOfShape * sum * std::max(1.0, largest_coordinate(patch_.points())) * most / least;
  }
  return found;
}

}  // namespace splinecore
