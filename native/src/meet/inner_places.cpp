#include <algorithm>
#include <cmath>
#include <functional>
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

  bool is_limited() const noexcept { return std::isfinite(squared_); }

  bool operator()(const PlaneRange& range) {
    if (!is_limited()) return false;
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

/// By what factor weights of neighbors differ at most along an axis.
double weight_change(const Net& net, Axis axis) {
  const std::size_t step = axis == Axis::u ? net.columns : 1;
  double most = 1.0;
  for (std::size_t i = 0; i + step < net.values.size(); ++i) {
    if (axis == Axis::v && (i + 1) % net.columns == 0) continue;
    const double ratio = net.values[i].w / net.values[i + step].w;
    most = std::max({most, ratio, 1.0 / ratio});
  }
  return most;
}

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

using Add = std::function<void(const PlaneRange&, const PlaneZeros&)>;

/// Uneven weights are evened by halving, so that each part has a noise of its own.
void search_even_parts(const NearPatch& patch, Net part, const PlaneRange& range, int depth, Farther& is_out,
                       const Add& add) {
  constexpr int kDeepest = 40;
  scale_weights(part);
  if (depth == kDeepest || !is_uneven(part)) {
    const PieceForms forms = forms_of(part, range, patch.point(), patch.rounding());
    const auto is_part_out = [&](const PlaneRange& inner) {
      PlaneRange whole;
      for (std::size_t k = 0; k < 2; ++k) {
        whole[k] = {std::lerp(range[k].start, range[k].end, inner[k].start),
                    std::lerp(range[k].start, range[k].end, inner[k].end)};
      }
      return is_out(whole);
    };
    const auto found = is_out.is_limited() ? plane_zeros(forms.u, forms.v, is_part_out)
                                           : plane_zeros(forms.u, forms.v, {});
    return add(range, found);
  }
  const Axis axis = weight_change(part, Axis::v) > weight_change(part, Axis::u) ? Axis::v : Axis::u;
  const auto k = static_cast<std::size_t>(axis);
  Net after;
  part.halve(axis, after);
  PlaneRange half = range;
  half[k].end = range[k].middle();
  search_even_parts(patch, std::move(part), half, depth + 1, is_out, add);
  half[k] = {range[k].middle(), range[k].end};
  search_even_parts(patch, std::move(after), half, depth + 1, is_out, add);
}

void add_places_of(PatchPlaces& places, const std::array<std::size_t, 2>& piece) {
  const NearPatch& patch = places.patch();
  const Net& net = patch.net(piece);
  if (std::ranges::none_of(net.values, [](const glm::dvec4& h) { return h.w != 0.0; })) return;
  Farther is_out(net, patch.point(), places.near_limit());
  if (is_out({})) return;
  constexpr double kLeastReach = 0x1p-34;
  const auto add = [&](const PlaneRange& range, const PlaneZeros& found) {
    const auto place_at = [&](const std::array<double, 2>& at) {
      return PiecePlace{piece, {std::lerp(range[0].start, range[0].end, at[0]),
                                std::lerp(range[1].start, range[1].end, at[1])}};
    };
    if (found.curve) places.refuse_curve(place_at(*found.curve));
    for (const PlaneZero& zero : found.zeros) {
      PiecePlace place = place_at(zero.at);
      if (!is_finite_at(net, patch, place)) continue;
      if (zero.is_single) place = refined(patch, place);
      places.add_inner(place, std::max(zero.reach * std::max(range[0].length(), range[1].length()), kLeastReach));
    }
  };
  search_even_parts(patch, net, {}, 0, is_out, add);
}

}  // namespace

void add_inner_places(PatchPlaces& places) {
  const NearPatch& patch = places.patch();
  for (std::size_t i = 0; i < patch.spans(Axis::u); ++i) {
    for (std::size_t j = 0; j < patch.spans(Axis::v); ++j) add_places_of(places, {i, j});
  }
}

}  // namespace splinecore
