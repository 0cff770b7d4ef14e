#include "level_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

#include "side_places.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::array<PieceSide, 4> kSides{{{Axis::u, false}, {Axis::u, true}, {Axis::v, false}, {Axis::v, true}}};

std::size_t number_of(Axis axis) { return axis == Axis::u ? 0 : 1; }
Axis other(Axis axis) { return axis == Axis::u ? Axis::v : Axis::u; }

/// How many lines of coefficients from a side on are zero.
std::size_t zero_lines(const BernsteinNet<double>& net, const PieceSide& side) {
  const std::size_t count = net.count(side.axis);
  const std::size_t along = net.count(other(side.axis));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t line = side.is_end ? count - 1 - i : i;
    for (std::size_t k = 0; k < along; ++k) {
      if ((side.axis == Axis::u ? net.at(line, k) : net.at(k, line)) != 0.0) return i;
    }
  }
  return count;
}

/// A polynomial that is zero on a side, divided by the parameter from there.
BernsteinNet<double> divided(const BernsteinNet<double>& net, const PieceSide& side) {
  const bool is_u = side.axis == Axis::u;
  BernsteinNet<double> found{net.rows - (is_u ? 1 : 0), net.columns - (is_u ? 0 : 1), {}};
  const std::size_t degree = net.count(side.axis) - 1;
  for (std::size_t i = 0; i < found.rows; ++i) {
    for (std::size_t j = 0; j < found.columns; ++j) {
      const std::size_t line = is_u ? i : j;
      const std::size_t from = side.is_end ? 0 : 1;
      const double value = is_u ? net.at(i + from, j) : net.at(i, j + from);
      const std::size_t choices = side.is_end ? degree - line : line + 1;
      found.values.push_back(value * static_cast<double>(degree) / static_cast<double>(choices));
    }
  }
  return found;
}

/// 1 or -1 if no coefficient is of the other sign, and some are not zero; otherwise 0.
int sign_of(const BernsteinNet<double>& net) {
  const auto [low, high] = net.range();
  return low >= 0.0 && high > 0.0 ? 1 : high <= 0.0 && low < 0.0 ? -1 : 0;
}

}  // namespace

LevelPieces::LevelPieces(const TwoPatches& patches, double rounding) : patches_(patches), rounding_(rounding) {
  const Slopes<2> middle = patches.b.at({0, {0.5, 0.5}});
  origin_ = middle.point;
  normal_ = glm::normalize(glm::cross(middle.first[0], middle.first[1]));
  for (std::size_t i = 0; i < patches.a.size(); ++i) level_.push_back(is_in_plane(i));
  if (std::ranges::none_of(level_, std::identity{})) return;
  for (std::size_t i = 0; i < level_.size(); ++i) heights_.push_back(heights_of(i));
  is_told_ = level_;
  for (std::size_t i = 0; i < level_.size(); ++i) {
    if (level_[i] || std::ranges::none_of(heights_[i].values, [](double height) { return height == 0.0; })) continue;
    is_told_[i] = is_met_by_sides_alone(i);
    if (is_told_[i] || !is_beside_level(i)) continue;
    is_told_.clear();
    return;
  }
}

bool LevelPieces::is_in_plane(std::size_t piece) const {
  breathe(16);
  return std::ranges::all_of(patches_.a.piece(piece).values, [&](const glm::dvec4& h) {
    return std::abs(glm::dot(normal_, glm::dvec3(h) - h.w * origin_)) <= rounding_ * std::abs(h.w);
  });
}

/// Times weights, which have one sign.
BernsteinNet<double> LevelPieces::heights_of(std::size_t piece) const {
  const BernsteinNet<glm::dvec4>& net = patches_.a.piece(piece);
  BernsteinNet<double> found{net.rows, net.columns, {}};
  for (const glm::dvec4& h : net.values) {
    const double height = glm::dot(normal_, glm::dvec3(h) - h.w * origin_);
    found.values.push_back(std::abs(height) > rounding_ * std::abs(h.w) ? height : 0.0);
  }
  return found;
}

bool LevelPieces::is_level_at_corner(std::size_t piece, bool is_end_u, bool is_end_v) const {
  for (const auto& [first, second] : {std::pair{PieceSide{Axis::u, is_end_u}, PieceSide{Axis::v, is_end_v}},
                                      std::pair{PieceSide{Axis::v, is_end_v}, PieceSide{Axis::u, is_end_u}}}) {
    const auto beside = patches_.a.beyond(piece, first);
    if (is_level(beside) || (beside && is_level(patches_.a.beyond(*beside, second)))) return true;
  }
  return false;
}

/// Whether a piece, whose heights are divided by powers of the parameters from sides in the plane, is on one side of it; its corners in
/// the plane are those of level pieces, and it is told how the patch goes on beyond its sides.
bool LevelPieces::is_met_by_sides_alone(std::size_t piece) const {
  breathe(64);
  const auto [low, high] = patches_.a.piece(piece).range([](const glm::dvec4& h) { return h.w; });
  if (!(low > 0.0 || high < 0.0)) return false;
  BernsteinNet<double> net = heights_[piece];
  for (const PieceSide& side : kSides) {
    const std::size_t lines = zero_lines(net, side);
    const auto beside = patches_.a.beyond(piece, side);
    if (!is_level(beside) && lines > 0 && beside && line_at(piece, side) == 0) return false;
    for (std::size_t i = 0; i < lines; ++i) net = divided(net, side);
  }
  for (const bool is_end_u : {false, true}) {
    for (const bool is_end_v : {false, true}) {
      const std::size_t i = is_end_u ? net.rows - 1 : 0;
      const std::size_t j = is_end_v ? net.columns - 1 : 0;
      if (net.at(i, j) == 0.0 && !is_level_at_corner(piece, is_end_u, is_end_v)) return false;
    }
  }
  return sign_of(net) != 0;
}

bool LevelPieces::is_beside_level(std::size_t piece) const {
  for (const bool is_end_u : {false, true}) {
    if (is_level_at_corner(piece, is_end_u, false) || is_level_at_corner(piece, is_end_u, true)) return true;
  }
  return false;
}

/// The sign of heights beside a side that lies in the plane; 0 if there are both.
int LevelPieces::sign_beside(std::size_t piece, const PieceSide& side) const {
  BernsteinNet<double> net = heights_[piece];
  for (std::size_t i = zero_lines(net, side); i > 0; --i) net = divided(net, side);
  return sign_of(side_of(net, side));
}

/// Of a side in the plane between pieces that are not: 1 where the patch goes through the plane, -1 where it touches it; 0 where that
/// is not told, or there is none.
int LevelPieces::line_at(std::size_t piece, const PieceSide& side) const {
  const auto beside = patches_.a.beyond(piece, side);
  if (!beside || level_[piece] || level_[*beside] || zero_lines(heights_[piece], side) == 0) return 0;
  return -sign_beside(piece, side) * sign_beside(*beside, {side.axis, !side.is_end});
}

bool LevelPieces::is_border(std::size_t piece, const PieceSide& side) const {
  return level_[piece] && !patches_.a.is_pole(piece, side) && !is_level(patches_.a.beyond(piece, side));
}

glm::dvec3 LevelPieces::point_on(std::size_t piece, const PieceSide& side, double share) const {
  PatchSpot spot{piece, {share, share}};
  spot.at[number_of(side.axis)] = side.is_end ? 1.0 : 0.0;
  return patches_.a.at(spot).point;
}

void LevelPieces::add_side(SectionTrace& trace, std::size_t piece, const PieceSide& side, double tolerance) const {
  const std::size_t across = number_of(side.axis);
  const std::size_t along = 1 - across;
  add_places(trace, patches_, [&](double share) {
    PatchSpots at{{piece, {}}, {0, {0.5, 0.5}}};
    at.a.at[across] = side.is_end ? 1.0 : 0.0;
    at.a.at[along] = share;
    if (const auto foot = foot_near(patches_, at)) at.b = foot->b;
    const PatchMeeting here = meeting_at(patches_, at);
    const double speed = glm::length(here.a.first[along]);
    SectionPlace place{at, here.a.point, glm::dvec3(0.0), {}};
    if (!(speed > 0.0)) return place;
    place.tangent = here.a.first[along] / speed;
    place.slopes = slopes_along(here, place.tangent);
    place.slopes[across] = 0.0;
    return place;
  }, tolerance);
}

/// Runs of sides of pieces along lines of knots.
template <class IsThere>
std::vector<SectionTrace> LevelPieces::sides(const PieceSide& side, double tolerance, IsThere is_there) const {
  constexpr double kSame = 0x1p-36;
  std::vector<SectionTrace> found;
  const std::size_t lines = patches_.a.knots(side.axis).spans().size();
  const std::size_t length = patches_.a.knots(other(side.axis)).spans().size();
  for (std::size_t i = 0; i < lines; ++i) {
    bool goes_on = false;
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t piece = side.axis == Axis::u ? patches_.a.piece_in(i, k) : patches_.a.piece_in(k, i);
      if (!std::exchange(goes_on, is_there(piece)) && goes_on) found.push_back({{}, false});
      if (goes_on) add_side(found.back(), piece, side, tolerance);
    }
  }
  for (SectionTrace& trace : found) {
    trace.is_closed = glm::distance(trace.places.front().point, trace.places.back().point) <= kSame;
  }
  return found;
}

std::vector<SectionTrace> LevelPieces::borders(double tolerance, const std::function<bool(const glm::dvec3&)>& is_known) const {
  std::vector<SectionTrace> found;
  if (!any()) return found;
  for (const PieceSide& side : kSides) {
    const auto is_new = [&](std::size_t piece) {
      return is_border(piece, side) && !std::ranges::all_of(std::array{0.1, 0.37, 0.5, 0.8}, [&](double share) {
        return is_known(point_on(piece, side, share));
      });
    };
    for (SectionTrace& trace : sides(side, tolerance, is_new)) found.push_back(std::move(trace));
  }
  return found;
}

std::vector<LevelLine> LevelPieces::lines(double tolerance) const {
  std::vector<LevelLine> found;
  if (!are_told()) return found;
  for (const Axis axis : {Axis::u, Axis::v}) {
    const PieceSide side{axis, true};
    for (const int kind : {1, -1}) {
      const auto is_there = [&](std::size_t piece) {
        return line_at(piece, side) == kind && (is_told_[piece] || is_told_[*patches_.a.beyond(piece, side)]);
      };
      for (SectionTrace& trace : sides(side, tolerance, is_there)) found.push_back({std::move(trace), kind > 0});
    }
  }
  return found;
}

}  // namespace splinecore
