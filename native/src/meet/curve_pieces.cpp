#include "curve_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "base/rounding.hpp"
#include "piece_box.hpp"
#include "piece_side.hpp"

namespace splinecore {

namespace {

/// A piece whose control points are one has one point, whatever the weights, which would make rounding of it.
void stand_still(BernsteinNet<glm::dvec4>& piece, double rounding) {
  const glm::dvec4 first = piece.values.front();
  const auto is_first = [&](const glm::dvec4& h) { return are_one(h, first, rounding); };
  if (std::ranges::all_of(piece.values, is_first)) std::ranges::fill(piece.values, glm::dvec4(project(first), 1.0));
}

std::vector<glm::dvec4> absolute(std::vector<glm::dvec4> points) {
  for (glm::dvec4& h : points) h = {glm::length(glm::dvec3(h)), 0.0, 0.0, std::abs(h.w)};
  return points;
}

/// Of control points by how many of their absolute weights the speed may be rounded where the weight is 1.
double rounding_of_speed(const BernsteinNet<glm::dvec4>& piece) {
  double most = 0.0;
  for (const glm::dvec4& h : piece.values) most = std::max({most, glm::length(glm::dvec3(h)), std::abs(h.w)});
  return kRoundingOfStep * static_cast<double>(piece.rows) * most;
}

double least_weight(const BernsteinNet<glm::dvec4>& piece) {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec4& h : piece.values) least = std::min(least, std::abs(h.w));
  return has_one_sign(piece.values, &glm::dvec4::w) ? least : 0.0;
}

}  // namespace

double rounding_across(const glm::dvec4& h, const glm::dvec4& sums, const glm::dvec3& along) noexcept {
  const glm::dvec3 point = project(h);
  const double aside = glm::length(point - glm::dot(point, along) * along);
  return kRoundingOfStep * (sums.x + aside * sums.w) / std::abs(h.w);
}

CurvePieces::CurvePieces(const NurbsCurve& curve, const NearSpace& space)
    : kernels_(kernels()), knots_(curve.knot_vector()) {
  const auto homogeneous = curve.homogeneous_points();
  const auto own = space.homogeneous(curve.points(), homogeneous, curve.points().size(), homogeneous.size());
  const std::size_t count = knots_.spans().size();
  const bool is_endless = !has_one_sign(own, &glm::dvec4::w);
  const std::vector<glm::dvec4> own_sums = is_endless ? absolute(own) : std::vector<glm::dvec4>();
  sums_.resize(count);
  pieces_.reserve(count);
  std::vector<TreeBox> boxes;
  boxes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    pieces_.push_back(bezier_piece(knots_, static_cast<int>(i), own.data()));
    if (is_endless) sums_[i] = bezier_piece(knots_, static_cast<int>(i), own_sums.data());
    stand_still(pieces_.back(), space.rounding());
    most_still_.push_back(rounding_of_speed(pieces_.back()) / least_weight(pieces_.back()));
    boxes.push_back(box_of(pieces_.back()));
  }
  tree_.emplace(boxes);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec4& next = pieces_[(i + 1) % count].values.front();
    starts_.push_back(i == 0 ? 0.0 : starts_.back() + (goes_on_.back() ? 1.0 : 2.0));
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

double CurvePieces::rounding(const CurveSpot& spot, const Slopes<1>& here) const noexcept {
  const BernsteinNet<glm::dvec4>& sums = sums_[spot.piece];
  if (sums.values.empty()) return 0.0;
  const std::array<double, 1> at{spot.t};
  std::array<glm::dvec4, 3> of_sums;
  std::array<glm::dvec4, 3> h;
  const auto slopes = [&](const BernsteinNet<glm::dvec4>& net, std::array<glm::dvec4, 3>& into) {
    kernels_.piece_slopes({static_cast<int>(net.rows), 1, &net.values.front().x}, at.data(), &into[0].x);
  };
  slopes(sums, of_sums);
  slopes(pieces_[spot.piece], h);
  const double speed = glm::length(here.first[0]);
  return rounding_across(h[0], of_sums[0], speed > 0.0 ? here.first[0] / speed : glm::dvec3(0.0));
}

bool CurvePieces::is_rounding(double speed, const CurveSpot& spot) const noexcept {
  if (speed > most_still_[spot.piece]) return false;
  const BernsteinNet<glm::dvec4>& net = pieces_[spot.piece];
  std::array<glm::dvec4, 3> h;
  kernels_.piece_slopes({static_cast<int>(net.rows), 1, &net.values.front().x}, &spot.t, &h[0].x);
  return speed * std::abs(h[0].w) <= rounding_of_speed(net);
}

double CurvePieces::parameter(const CurveSpot& spot) const {
  return knots_.span_interval(static_cast<int>(spot.piece)).at(spot.t);
}

bool CurvePieces::are_one(const CurveSpot& a, const CurveSpot& b, double tolerance) const {
  if (!(glm::length(at(b, at(a).point).offset) <= tolerance)) return false;
  const double low = std::min(place(a), place(b));
  const double high = std::max(place(a), place(b));
  if (high - low <= reach(low, 1.0, tolerance)) return true;
  return is_closed() && low + turn() - high <= reach(high, 1.0, tolerance);
}

double CurvePieces::reach(double place, double way, double distance) const {
  constexpr double kShortest = 0x1p-48;
  const CurveSpot from = spot(place);
  const Slopes<1> here = at(from);
  const auto is_within = [&](double far) {
    return glm::length(at(spot(place + way * far), here.point).offset) <= distance;
  };
  double end = way > 0.0 ? 1.0 - from.t : from.t;  // of the pieces looked at
  double far = std::max(std::min(0.125 * distance / glm::length(here.first[0]), 0.125), kShortest);
  // Where the curve nearly stands still its speed says nothing.
  while (far > kShortest && (far >= end || !is_within(far))) far *= 0.5;
  std::size_t piece = from.piece;
  for (;; far *= 2.0) {
    while (far >= end) {
      const std::optional<std::size_t> next = way > 0.0 ? after(piece) : before(piece);
      if (!next || end >= turn()) return end;
      piece = *next;
      end += 1.0;
    }
    if (!is_within(far)) return far;
  }
}

bool CurvePieces::ends_near(double place, double distance) const {
  const CurveSpot first = spot(place - reach(place, -1.0, distance));
  const CurveSpot last = spot(place + reach(place, 1.0, distance));
  return (first.t == 0.0 && !before(first.piece)) || (last.t == 1.0 && !after(last.piece));
}

CurveSpot CurvePieces::spot(double place) const noexcept {
  if (is_closed() && (place < 0.0 || place > turn())) place -= std::floor(place / turn()) * turn();
  const auto behind = std::ranges::upper_bound(starts_, place);
  const std::size_t piece = behind == starts_.begin() ? 0 : static_cast<std::size_t>(behind - starts_.begin()) - 1;
  return {piece, std::clamp(place - starts_[piece], 0.0, 1.0)};
}

}  // namespace splinecore
