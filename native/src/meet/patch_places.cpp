#include "base/sort_by.hpp"
#include "patch_places.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "stationary_line.hpp"

namespace splinecore {

namespace {

/// Places of one piece are nearer than that only if they are one.
constexpr double kReach = 0x1p-28;

/// By distances a little away, of a place where second derivatives do not tell.
Stationary kind_around(const NearPatch& patch, const PiecePlace& place) {
  constexpr int kWays = 24;
  constexpr double kRadius = 0x1p-9;
  constexpr double kRounding = 0x1p-47;
  const Slopes<2> here = patch.slopes(place);
  bool is_more = false;
  bool is_less = false;
  for (int i = 0; i < kWays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kWays;
    PiecePlace there = place;
    there.at[0] = std::clamp(place.at[0] + kRadius * std::cos(angle), 0.0, 1.0);
    there.at[1] = std::clamp(place.at[1] + kRadius * std::sin(angle), 0.0, 1.0);
    const Slopes<2> beside = patch.slopes(there);
    const glm::dvec3 sum = here.offset + beside.offset;
    const double change = glm::dot(beside.point - here.point, sum);
    const double wrong = kRounding * glm::length(sum);
    is_more = is_more || change > wrong;
    is_less = is_less || change < -wrong;
  }
  return kind_of(is_less ? 1 : -1, is_more ? 1 : -1);
}

Stationary kind_at(const NearPatch& patch, const PiecePlace& place) {
  constexpr double kFlat = 0x1p-24;
  const Slopes<2> here = patch.slopes(place);
  std::array<double, 3> bend;
  std::array<double, 2> size;
  for (std::size_t k = 0; k < 2; ++k) {
    const double square = glm::dot(here.first[k], here.first[k]);
    bend[k] = square + glm::dot(here.offset, here.second[k]);
    size[k] = square + glm::length(here.offset) * glm::length(here.second[k]);
  }
  bend[2] = glm::dot(here.first[0], here.first[1]) + glm::dot(here.offset, here.second[2]);
  const double determinant = bend[0] * bend[1] - bend[2] * bend[2];
  const double wrong = kFlat * size[0] * size[1] + kRoundingOfShape * glm::length(here.offset) * (size[0] + size[1]);
  if (!(std::abs(determinant) > wrong)) return kind_around(patch, place);
  if (determinant < 0.0) return Stationary::saddle;
  return bend[0] > 0.0 ? Stationary::minimum : Stationary::maximum;
}

}  // namespace

PatchPlaces::PatchPlaces(const NearPatch& patch, double limit)
    : patch_(patch), limit_(limit), near_limit_(patch.near_length(limit)) {}

void PatchPlaces::add_inner(const PiecePlace& place, double reach) {
  add(place_of(place, reach, kind_at(patch_, place), true));
}

void PatchPlaces::add_pole(Axis axis, const PiecePlace& place, std::optional<Stationary> kind) {
  poles_.push_back({axis, place_of(place, kReach, kind.value_or(Stationary::saddle), false), kind.has_value()});
}

void PatchPlaces::add_outer(const PiecePlace& place, Stationary kind) {
  add(place_of(place, kReach, kind, false));
}

PatchPlaces::Place PatchPlaces::place_of(const PiecePlace& place, double reach, Stationary kind,
                                         bool is_inner) const {
  Place made{patch_.parameters(place), {}, patch_.slopes(place).point, kind, is_inner};
  for (const Axis axis : {Axis::u, Axis::v}) {
    const auto k = static_cast<std::size_t>(axis);
    const Interval domain = patch_.knots(axis).domain();
    if (patch_.is_closed(axis) && made.parameters[k] == domain.end) made.parameters[k] = domain.start;
    made.reach[k] = reach * patch_.span(axis, place.piece[k]).length();
  }
  return made;
}

void PatchPlaces::add(const Place& made) {
  if (!std::isfinite(glm::length(made.point))) return;
  if (is_in_pole(made)) return;
  const auto other = std::ranges::find_if(places_, [&](const Place& one) { return are_one(one, made); });
  if (other == places_.end()) {
    places_.push_back(made);
  } else if (made.is_inner && other->is_inner && other->kind != made.kind) {
    other->kind = Stationary::saddle;
  }
}

/// An inner place that rounding does not tell from a pole is the pole.
bool PatchPlaces::is_in_pole(const Place& made) {
  for (Pole& pole : poles_) {
    const auto k = static_cast<std::size_t>(pole.axis);
    if (std::abs(made.parameters[k] - pole.place.parameters[k]) > made.reach[k]) continue;
    if (made.is_inner && !pole.counts) pole.place.kind = made.kind;
    pole.counts = pole.counts || made.is_inner;
    return true;
  }
  return false;
}

bool PatchPlaces::are_one(const Place& a, const Place& b) const noexcept {
  constexpr double kNear = 0x1p-14;
  for (const Axis axis : {Axis::u, Axis::v}) {
    const auto k = static_cast<std::size_t>(axis);
    const Interval domain = patch_.knots(axis).domain();
    const double apart = std::abs(a.parameters[k] - b.parameters[k]);
    const double around = patch_.is_closed(axis) ? domain.length() - apart : apart;
    if (std::min(apart, around) > std::max(a.reach[k], b.reach[k])) return false;
  }
  return glm::length(a.point - b.point) <= kNear;
}

std::vector<StationaryOnPatch> PatchPlaces::found() const {
  std::vector<Place> all = places_;
  for (const Pole& pole : poles_) {
    if (pole.counts) all.push_back(pole.place);
  }
  std::vector<StationaryOnPatch> found;
  for (const Place& place : all) {
    found.push_back({place.parameters[0], place.parameters[1], patch_.origin().leave(place.point),
                     patch_.origin().distance_to(place.point), place.kind});
  }
  sort_by(found, [](const StationaryOnPatch& place) { return SortKey{place.u, place.v}; });
  return found;
}

bool PatchPlaces::is_too_far(const PiecePlace& place) const {
  return patch_.origin().distance_to(patch_.slopes(place).point) > limit_;
}

void PatchPlaces::refuse_curve(const PiecePlace& near) const {
  const auto [u, v] = patch_.parameters(near);
  throw InvalidShape("the distance from the point is stationary on a curve of places or more, about u = " +
                     text_of(u) + ", v = " + text_of(v) + ", or too nearly so to tell them apart");
}

}  // namespace splinecore
