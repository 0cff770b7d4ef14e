#include "ray_search.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/one_sign.hpp"
#include "base/rounding.hpp"
#include "base/sort_by.hpp"
#include "slopes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"
#include "within_period.hpp"

namespace splinecore {

namespace {

/// As parts of a domain, parameters that are nearer to each other may be those of one place.
constexpr double kNear = 0x1p-24;

}  // namespace

RaySearch::RaySearch(const NurbsPatch& patch, std::size_t number)
    : patch_(patch), pieces_(boxed_pieces(patch)), number_(number) {
  for (SlopeForm* form : {&a_, &b_}) {
    form->net.rows = pieces_.rows();
    form->net.columns = pieces_.columns();
    form->net.values.resize(pieces_.rows() * pieces_.columns());
  }
}

const std::vector<RayHit>& RaySearch::all(const Ray& ray, std::size_t index, const Interval& limits) {
  hits_.clear();
  const NearRay near(ray, pieces_.space(), index);
  gather(near, limits);
  for (const BoxOnRay& part : parts_) {
    if (look_into(near, part.index, limits)) continue;
    intersect(ray, near, index, limits);
    break;
  }
  return hits_;
}

const std::vector<RayHit>& RaySearch::first(const Ray& ray, std::size_t index, const Interval& limits) {
  hits_.clear();
  const NearRay near(ray, pieces_.space(), index);
  gather(near, limits);
  for (const BoxOnRay& part : parts_) {
    if (!hits_.empty() && near.along(part.near) > hits_.front().along + near.slack()) break;
    const bool is_told = look_into(near, part.index, limits);
    if (!is_told) intersect(ray, near, index, limits);
    keep_first();
    if (!is_told) break;
  }
  return hits_;
}

void RaySearch::keep_first() {
  if (hits_.size() < 2) return;
  hits_.front() = *std::ranges::min_element(hits_, {}, [](const RayHit& hit) { return hit.along; });
  hits_.erase(hits_.begin() + 1, hits_.end());
}

void RaySearch::gather(const NearRay& ray, const Interval& limits) {
  const double slack = NearRay::kSlack * ray.noise;
  const Interval kept{ray.near(limits.start) - slack, ray.near(limits.end) + slack};
  const auto is_out = [&](const BoxOnRay& box) { return box.near > kept.end || box.far < kept.start; };
  add_leaves_on(ray, pieces_.tree(), waiting_, groups_);
  std::erase_if(groups_, is_out);
  parts_.clear();
  for (const BoxOnRay& group : groups_) {
    const std::size_t first = group.index * BoxedPieces::kGroup;
    add_boxes_on(ray, pieces_.groups()[group.index], first, pieces_.parts().size() - first, parts_);
  }
  std::erase_if(parts_, is_out);
  sort_by(parts_, [](const BoxOnRay& box) { return SortKey{box.near, static_cast<double>(box.index)}; });
}

bool RaySearch::look_into(const NearRay& ray, std::size_t part, const Interval& limits) {
  const glm::dvec4* net = pieces_.points(part);
  const std::size_t count = a_.net.values.size();
  double size = 0.0;
  double weight = 0.0;
  breathe(8 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 point(net[i]);
    const glm::dvec3 offset = point - net[i].w * ray.foot;
    a_.net.values[i] = glm::dot(offset, ray.across[0]);
    b_.net.values[i] = glm::dot(offset, ray.across[1]);
    size = std::max({size, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    weight = std::max(weight, std::abs(net[i].w));
  }
  a_.noise = b_.noise = kRoundingOfStep * size + ray.noise * weight;
  if (has_one_sign(a_.net.values, {}, a_.noise) || has_one_sign(b_.net.values, {}, b_.noise)) return true;
  const PlaneZeros found = plane_zeros(a_, b_, {});
  if (found.curve || !std::ranges::all_of(found.zeros, &PlaneZero::is_single)) return false;
  for (const PlaneZero& zero : found.zeros) offer(ray, part, zero.at, limits);
  return true;
}

void RaySearch::offer(const NearRay& ray, std::size_t part, Place at, const Interval& limits) {
  constexpr int kSteps = 2;
  const auto slopes = [&] {
    return slopes_of<2>(kernels_, pieces_.points(part), pieces_.rows(), pieces_.columns(), at, ray.foot);
  };
  Slopes<2> here = slopes();
  for (int step = 0; step < kSteps; ++step) {
    const auto along = [&](const glm::dvec3& v) { return glm::dvec2(glm::dot(v, ray.across[0]), glm::dot(v, ray.across[1])); };
    const glm::dvec2 x = along(here.offset);
    const glm::dvec2 u = along(here.first[0]);
    const glm::dvec2 v = along(here.first[1]);
    const double determinant = u.x * v.y - u.y * v.x;
    const Place to{std::clamp(at[0] - (x.x * v.y - x.y * v.x) / determinant, 0.0, 1.0),
                   std::clamp(at[1] - (u.x * x.y - u.y * x.x) / determinant, 0.0, 1.0)};
    if (!std::isfinite(to[0]) || !std::isfinite(to[1])) break;
    at = to;
    here = slopes();
  }
  const glm::dvec3 point = ray.foot + here.offset;
  if (!std::isfinite(glm::length(point))) return;  // at infinity nothing is met
  const PiecePart& of = pieces_.parts()[part];
  const auto parameter = [&](std::size_t k) {
    const double t = (1.0 - at[k]) * of.range[k].start + at[k] * of.range[k].end;
    return within_period(of.domain[k].at(t), patch_.knot_vector(k == 0 ? Axis::u : Axis::v));
  };
  const glm::dvec3 normal = glm::cross(here.first[0], here.first[1]);
  const double slope = std::abs(glm::dot(normal, ray.way)) / glm::length(normal);
  const double along = ray.along(ray.at(point));
  keep({along, along, number_, parameter(0), parameter(1), pieces_.space().leave(point), false},
       ray.slack() / std::max(slope, 0x1p-20), limits);
}

bool RaySearch::are_one(const RayHit& a, const RayHit& b, double slack) const {
  if (std::abs(a.along - b.along) > slack) return false;
  const auto is_one = [&](double s, double t, Axis axis) {
    const Interval domain = patch_.knot_vector(axis).domain();
    const double near = kNear * domain.length();
    return std::abs(s - t) <= near || std::abs(s - t) >= domain.length() - near;
  };
  return is_one(a.u, b.u, Axis::u) && is_one(a.v, b.v, Axis::v);
}

void RaySearch::keep(const RayHit& hit, double slack, const Interval& limits) {
  if (!(hit.along >= limits.start - slack && hit.along <= limits.end + slack)) return;
  RayHit kept = hit;
  kept.along = std::clamp(hit.along, limits.start, limits.end);
  kept.until = std::clamp(hit.until, kept.along, limits.end);
  const auto known = std::ranges::find_if(hits_, [&](const RayHit& other) { return are_one(kept, other, slack); });
  if (known == hits_.end()) {
    hits_.push_back(kept);
  } else if (kept.u < known->u || (kept.u == known->u && kept.v < known->v)) {
    *known = kept;
  }
}

void RaySearch::intersect(const Ray& ray, const NearRay& near, std::size_t index, const Interval& limits) {
  constexpr double kEverywhere = 0x1p400;
  const BoxTree& tree = pieces_.tree();
  const BoxTree::Group& root = tree.group(tree.levels() - 1, 0);
  double reach = 1.0;
  for (std::size_t i = 0; i < tree.count(tree.levels() - 1); ++i) {
    for (int axis = 0; axis < 3; ++axis) reach = std::max(reach, std::abs(root.middle[axis][i]) + root.half[axis][i]);
  }
  const std::string name = "origins" + index_text(index) + ": ";
  if (reach > kEverywhere) {
    throw InvalidShape(name + "where the ray meets a patch that runs through infinity cannot be told");
  }
  const double far = 4.0 * reach;
  const auto end = [&](double at) { return glm::dvec4(pieces_.space().leave(near.foot + at * near.way), 1.0); };
  const NurbsCurve line = NurbsCurve::make(KnotVector::make(1, {0, 0, 1, 1}, false), {end(-far), end(far)});
  const auto along = [&](double t) { return near.along(std::lerp(-far, far, t)); };
  PatchIntersections found;
  try {
    found = intersections(line, patch_);
  } catch (const InvalidShape& error) {
    throw InvalidShape(name + error.what());
  }
  hits_.clear();
  for (const PatchIntersection& place : found.places) {
    const double at = along(place.t);
    const double u = within_period(place.parameters[0], patch_.knot_vector(Axis::u));
    const double v = within_period(place.parameters[1], patch_.knot_vector(Axis::v));
    keep({at, at, number_, u, v, place.point, place.touches}, near.slack(), limits);
  }
  for (const Interval& stretch : found.overlaps) {
    const Interval on{std::max(along(stretch.start), limits.start), std::min(along(stretch.end), limits.end)};
    if (on.start > on.end + near.slack()) continue;
    const glm::dvec3 start = ray.origin + on.start * ray.direction;
    NearestOnPatch place;
    nearest(patch_, std::span(&start, 1), std::span(&place, 1), 1);
    hits_.push_back({on.start, std::max(on.start, on.end), number_, place.u, place.v, place.point, true});
  }
}

}  // namespace splinecore
