#include "curve_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "boxed_pieces.hpp"
#include "piece_side.hpp"

namespace splinecore {

CurvePieces::CurvePieces(const NurbsCurve& curve, const NearSpace& space)
    : kernels_(kernels()), knots_(curve.knot_vector()) {
  const auto homogeneous = curve.homogeneous_points();
  const auto own = space.homogeneous(curve.points(), homogeneous, curve.points().size(), homogeneous.size());
  const std::size_t count = knots_.spans().size();
  pieces_.reserve(count);
  std::vector<TreeBox> boxes;
  boxes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    pieces_.push_back(bezier_piece(knots_, static_cast<int>(i), own.data()));
    boxes.push_back(box_of(pieces_.back()));
  }
  tree_.emplace(boxes);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec4& next = pieces_[(i + 1) % count].values.front();
    goes_on_.push_back(splinecore::are_one(pieces_[i].values.back(), next, space.rounding()));
  }
}

std::optional<std::size_t> CurvePieces::after(std::size_t i) const noexcept {
  return goes_on_[i] ? std::optional((i + 1) % pieces_.size()) : std::nullopt;
}

std::optional<std::size_t> CurvePieces::before(std::size_t i) const noexcept {
  const std::size_t before = (i + pieces_.size() - 1) % pieces_.size();
  return goes_on_[before] ? std::optional(before) : std::nullopt;
}

double CurvePieces::parameter(const CurveSpot& spot) const {
  return parameter_at(knots_.span_interval(static_cast<int>(spot.piece)), spot.t);
}

bool CurvePieces::are_beside(const Interval& a, const Interval& b, double tolerance) const noexcept {
  const double before = std::min(a.end, b.end);
  const double behind = std::max(a.start, b.start);
  if (behind <= before) return true;
  constexpr double kNext = 0.5;  // of a piece
  if (behind - before > kNext) return false;
  return glm::length(at(spot(behind), at(spot(before)).point).offset) <= tolerance;
}

bool CurvePieces::are_one(const CurveSpot& a, const CurveSpot& b, double tolerance) const noexcept {
  constexpr double kNext = 0.25;  // of a piece
  double apart = std::abs(place(a) - place(b));
  if (is_closed()) apart = std::min(apart, std::abs(static_cast<double>(size()) - apart));
  return apart < kNext && glm::length(at(b, at(a).point).offset) <= tolerance;
}

CurveSpot CurvePieces::spot(double place) const noexcept {
  const auto turn = static_cast<double>(pieces_.size());
  if (is_closed() && (place < 0.0 || place > turn)) place -= std::floor(place / turn) * turn;
  const std::size_t piece = std::min(static_cast<std::size_t>(std::max(place, 0.0)), pieces_.size() - 1);
  return {piece, std::clamp(place - static_cast<double>(piece), 0.0, 1.0)};
}

}  // namespace splinecore
