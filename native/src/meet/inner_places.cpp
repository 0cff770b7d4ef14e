#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/one_sign.hpp"
#include "distance_form.hpp"
#include "patch_places.hpp"
#include "piece_side.hpp"
#include "plane_zeros.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using Net = BernsteinNet<glm::dvec4>;

Net part_of(const Net& net, const PlaneRange& range) {
  Net part = net;
  Net rest;
  for (const Axis axis : {Axis::u, Axis::v}) {
    const Interval& along = range[static_cast<std::size_t>(axis)];
    if (along.end < 1.0) part.cut(axis, along.end, rest);
    if (along.start == 0.0) continue;
    part.cut(axis, along.start / along.end, rest);
    std::swap(part, rest);
  }
  return part;
}

/// Parts of a piece that are farther from the point than a limit.
class Farther {
 public:
  Farther(const Net& net, const glm::dvec3& point, double limit)
      : net_(net), point_(point), squared_(limit * limit), form_(net.rows, net.columns) {}

  bool operator()(const PlaneRange& range) {
    if (!std::isfinite(squared_)) return false;
    breathe(4 * net_.values.size() * net_.values.size());
    const Net part = part_of(net_, range);
    form_.set(part.values.data(), point_);
    return form_.is_farther(squared_);
  }

 private:
  const Net& net_;
  glm::dvec3 point_;
  double squared_;
  DistanceForm form_;
};

/// One more step of Newton's method, on the distance itself.
PiecePlace refined(const NearPatch& patch, PiecePlace place) {
  constexpr double kLongest = 0x1p-24;
  constexpr double kAtEnd = 0x1p-44;  // nearer to a side it is there
  const Slopes<2> here = patch.slopes(place);
  const std::array slope{glm::dot(here.offset, here.first[0]), glm::dot(here.offset, here.first[1])};
  const auto bend = [&](int i, int j, int k) {
    return glm::dot(here.first[i], here.first[j]) + glm::dot(here.offset, here.second[k]);
  };
  const double uu = bend(0, 0, 0), vv = bend(1, 1, 1), uv = bend(0, 1, 2);
  const double determinant = uu * vv - uv * uv;
  const std::array step{(uv * slope[1] - vv * slope[0]) / determinant, (uv * slope[0] - uu * slope[1]) / determinant};
  if (!(std::abs(step[0]) <= kLongest && std::abs(step[1]) <= kLongest)) return place;
  for (std::size_t k = 0; k < 2; ++k) {
    const double at = place.at[k] + step[k];
    place.at[k] = at <= kAtEnd ? 0.0 : at >= 1.0 - kAtEnd ? 1.0 : at;
  }
  return place;
}

bool is_finite_at(const Net& net, const NearPatch& patch, const PiecePlace& place) {
  constexpr double kInfinite = 0x1p40;
  if (has_one_sign(net.values, &glm::dvec4::w)) return true;
  return glm::length(patch.slopes(place).point) < kInfinite;
}

void add_places_of(PatchPlaces& places, const std::array<std::size_t, 2>& piece) {
  const NearPatch& patch = places.patch();
  const Net& net = patch.net(piece);
  if (std::ranges::none_of(net.values, [](const glm::dvec4& h) { return h.w != 0.0; })) return;
  Farther is_out(net, patch.point(), places.near_limit());
  if (is_out({})) return;
  const PieceForms forms = forms_of(net, patch.point(), patch.rounding());
  const PlaneZeros found = plane_zeros(forms.u, forms.v, std::ref(is_out));
  if (found.curve) places.refuse_curve({piece, *found.curve});
  for (const PlaneZero& zero : found.zeros) {
    PiecePlace place{piece, zero.at};
    if (!is_finite_at(net, patch, place)) continue;
    if (zero.is_single) place = refined(patch, place);
    places.add_inner(place, zero.reach);
  }
}

}  // namespace

void add_inner_places(PatchPlaces& places) {
  const NearPatch& patch = places.patch();
  for (std::size_t i = 0; i < patch.spans(Axis::u); ++i) {
    for (std::size_t j = 0; j < patch.spans(Axis::v); ++j) add_places_of(places, {i, j});
  }
}

}  // namespace splinecore
