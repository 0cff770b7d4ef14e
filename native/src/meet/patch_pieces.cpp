#include "patch_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "piece_box.hpp"

namespace splinecore {

PatchPieces::PatchPieces(const NurbsPatch& patch, const NearSpace& space)
    : kernels_(kernels()), u_(patch.knot_vector(Axis::u)), v_(patch.knot_vector(Axis::v)) {
  const auto own = space.homogeneous(patch.points(), patch.homogeneous_points(), static_cast<std::size_t>(v_.count()),
                                     static_cast<std::size_t>(v_.unrolled_count()));
  std::vector<TreeBox> boxes;
  for (std::size_t i = 0; i < spans(Axis::u); ++i) {
    for (std::size_t j = 0; j < spans(Axis::v); ++j) {
      pieces_.push_back(bezier_piece(u_, static_cast<int>(i), v_, static_cast<int>(j), own.data()));
      boxes.push_back(box_of(pieces_.back()));
    }
  }
  tree_.emplace(boxes);
  const TreeBox all = around(boxes);
  extent_ = std::max({all.high.x - all.low.x, all.high.y - all.low.y, all.high.z - all.low.z});
  for (std::size_t i = 0; i < size(); ++i) {
    for (const Axis axis : {Axis::u, Axis::v}) {
      const std::size_t step = axis == Axis::u ? spans(Axis::v) : 1;
      const bool is_last = span(i, axis) + 1 == spans(axis);
      const std::size_t next = is_last ? i - step * (spans(axis) - 1) : i + step;
      goes_on_.push_back(are_joined(i, next, axis, space.rounding()));
      for (const bool is_end : {false, true}) poles_.push_back(is_point(pieces_[i], {axis, is_end}, space.rounding()));
    }
  }
}

bool PatchPieces::are_joined(std::size_t before, std::size_t behind, Axis axis, double rounding) const {
  const auto end = side_of(pieces_[before], {axis, true}).values;
  const auto start = side_of(pieces_[behind], {axis, false}).values;
  for (std::size_t k = 0; k < end.size(); ++k) {
    if (!are_one(end[k], start[k], rounding)) return false;
  }
  return true;
}

std::optional<std::size_t> PatchPieces::beyond(std::size_t piece, const PieceSide& side) const noexcept {
  if (is_pole(piece, side)) return {};
  const std::size_t step = side.axis == Axis::u ? spans(Axis::v) : 1;
  const std::size_t count = spans(side.axis);
  const std::size_t at = span(piece, side.axis);
  const std::size_t which = side.axis == Axis::u ? 0 : 1;
  if (side.is_end) {
    const std::size_t next = at + 1 == count ? piece - step * at : piece + step;
    return goes_on_[2 * piece + which] ? std::optional(next) : std::nullopt;
  }
  const std::size_t before = at == 0 ? piece + step * (count - 1) : piece - step;
  return goes_on_[2 * before + which] ? std::optional(before) : std::nullopt;
}

std::vector<PatchSpot> PatchPieces::twins(const PatchSpot& spot, double near) const {
  std::vector<PatchSpot> twins{spot};
  for (const Axis axis : {Axis::u, Axis::v}) {
    const std::size_t k = axis == Axis::u ? 0 : 1;
    const std::size_t count = twins.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const bool is_end : {false, true}) {
        if (std::abs(twins[i].at[k] - (is_end ? 1.0 : 0.0)) > near) continue;
        const auto next = beyond(twins[i].piece, {axis, is_end});
        if (!next) continue;
        PatchSpot twin{*next, twins[i].at};
        twin.at[k] = is_end ? 0.0 : 1.0;
        twins.push_back(twin);
      }
    }
  }
  return twins;
}

std::array<double, 2> PatchPieces::parameters(const PatchSpot& spot) const {
  const auto along = [&](Axis axis, double t) {
    return knots(axis).span_interval(static_cast<int>(span(spot.piece, axis))).at(t);
  };
  return {along(Axis::u, spot.at[0]), along(Axis::v, spot.at[1])};
}

PatchSpot PatchPieces::spot(const std::array<double, 2>& parameters) const {
  PatchSpot found{0, {}};
  std::array<std::size_t, 2> spans{};
  for (std::size_t k = 0; k < 2; ++k) {
    const KnotVector& own = knots(k == 0 ? Axis::u : Axis::v);
    const Interval domain = own.domain();
    const double t = std::clamp(parameters[k], domain.start, domain.end);
    const int span = own.span_of(t, Side::right);
    const Interval range = own.span_interval(span);
    spans[k] = static_cast<std::size_t>(span);
    found.at[k] = std::clamp((t - range.start) / range.length(), 0.0, 1.0);
  }
  found.piece = piece_in(spans[0], spans[1]);
  return found;
}

double PatchPieces::span_length(std::size_t piece, Axis axis) const {
  return knots(axis).span_interval(static_cast<int>(span(piece, axis))).length();
}

}  // namespace splinecore
