#include "hole_side.hpp"

#include <algorithm>
#include <cmath>
#include <array>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "end_scale.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/join.hpp"
#include "turned_alike.hpp"

namespace splinecore {

namespace {

/// Each as long as lets speeds along them agree where they meet.
std::vector<PlacedPiece> placed(std::vector<SidePiece> pieces) {
  std::vector<double> ends{1.0};
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const double before = ends.size() > 1 ? ends[k - 1] - ends[k - 2] : ends[0];
    const double pace = length_of(pieces[k].place(0.0).along) / length_of(pieces[k - 1].place(1.0).along);
    ends.push_back(ends.back() + before * pace);
  }
  std::vector<PlacedPiece> found;
  double from = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const double end = k + 1 == pieces.size() ? 1.0 : ends[k] / ends.back();
    if (!(end > from)) throw InvalidShape(pieces[k].name() + " is too short beside the side that continues it");
    found.push_back({std::move(pieces[k]), from, end});
    from = end;
  }
  return found;
}

/// At its joints at most continuously differentiable, as what leaves it is.
NurbsCurve whole_curve(const std::vector<PlacedPiece>& pieces) {
  const auto curve_of = [](const PlacedPiece& one) { return with_domain(one.piece.curve(), {one.from, one.to}); };
  NurbsCurve whole = curve_of(pieces.front());
  if (pieces.size() == 1) return whole;
  for (std::size_t k = 1; k < pieces.size(); ++k) whole = joined(whole, curve_of(pieces[k]), Smoothness::c0).value;
  whole = elevated(with_domain(whole, {0.0, 1.0}), std::max(0, 2 - whole.degree()));
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const int missing = whole.degree() - 1 - multiplicity(whole.knot_vector(), pieces[k].from);
    if (missing > 0) whole = insert_knot(whole, pieces[k].from, missing);
  }
  return whole;
}

std::vector<HolePlace> places_of(const PlacedPiece& one, std::span<const double> inside) {
  std::vector<HolePlace> places = one.piece.places(inside);
  for (HolePlace& place : places) {
    place.along /= one.length();
    place.along_2 /= one.length() * one.length();
    place.out_along /= one.length();
  }
  return places;
}

/// How a filling leaves a place: D and D2.
struct Leaving {
  glm::dvec3 first;
  glm::dvec3 second;
};

/// The part in the neighbor's plane of what D alone makes of D2.
glm::dvec3 sliding(SidePiece piece, bool is_end, const glm::dvec3& across) {
  piece.set_end(is_end, across, glm::dvec3(0.0));
  const auto [c, d] = piece.second_parts(is_end);
  const std::array<glm::dvec3, 2> directions = piece.directions(is_end);
  return -c * directions[0] - d * directions[1];
}

/// Along the line between neighbors: both turn alike along that.
Leaving leaving_between(const SidePiece& before, const SidePiece& behind, double length) {
  const glm::dvec3 a = before.directions(true)[0];
  const glm::dvec3 b = behind.directions(false)[0];
  const glm::dvec3 across = length * glm::normalize(glm::normalize(a) + glm::normalize(b));
  return {across, 0.5 * (sliding(before, true, across) + sliding(behind, false, across))};
}

}  // namespace

HoleSide::HoleSide(std::vector<SidePiece> pieces, SideNumbers numbers)
    : pieces_(placed(std::move(pieces))), numbers_(numbers), curve_(whole_curve(pieces_)) {}

int HoleSide::continuity() const {
  int most = 0;
  for (const PlacedPiece& one : pieces_) most = std::max(most, one.piece.continuity());
  return most;
}

int HoleSide::least_degree() const { return curve_.degree() + (EndScale::of(curve_).is_level() ? 0 : 1); }

std::vector<double> HoleSide::joints() const {
  std::vector<double> found;
  for (std::size_t k = 1; k < pieces_.size(); ++k) found.push_back(pieces_[k].from);
  return found;
}

template <class Value, class Given>
std::vector<Value> HoleSide::gathered(std::span<const double> s, const Given& given) const {
  std::vector<Value> found(s.size());
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const PlacedPiece& one = pieces_[k];
    std::vector<std::size_t> numbers;
    std::vector<double> inside;
    for (std::size_t i = 0; i < s.size(); ++i) {
      const bool is_here = (k == 0 || s[i] >= one.from) && (k + 1 == pieces_.size() || s[i] < one.to);
      if (!is_here) continue;
      numbers.push_back(i);
      inside.push_back((s[i] - one.from) / one.length());
    }
    if (numbers.empty()) continue;
    const std::vector<Value> values = given(one, inside);
    for (std::size_t i = 0; i < numbers.size(); ++i) found[numbers[i]] = values[i];
  }
  return found;
}

std::vector<HolePlace> HoleSide::places(std::span<const double> s) const { return gathered<HolePlace>(s, places_of); }

std::vector<glm::dvec3> HoleSide::points(std::span<const double> s) const {
  return gathered<glm::dvec3>(s, [](const PlacedPiece& one, std::span<const double> inside) { return one.piece.points(inside); });
}

std::vector<glm::dvec3> HoleSide::across(std::span<const double> s, int order) const {
  std::vector<glm::dvec3> found = gathered<glm::dvec3>(
      s, [&](const PlacedPiece& one, std::span<const double> inside) { return one.piece.across(inside, order); });
  const double start[] = {0.0};
  const double end[] = {1.0};
  for (std::size_t k = 1; k < pieces_.size(); ++k) {
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (std::abs(s[i] - pieces_[k].from) > kRoundingOfShape) continue;
      found[i] = 0.5 * (pieces_[k - 1].piece.across(end, order).front() + pieces_[k].piece.across(start, order).front());
    }
  }
  return found;
}

void HoleSide::set_end(bool is_end, const glm::dvec3& across, const glm::dvec3& across_2) {
  piece_at(is_end).piece.set_end(is_end, across, across_2);
}

void HoleSide::agree_at_joints(std::span<const double> lengths) {
  if (pieces_.size() == 1) return;
  const double ends[] = {0.0, 1.0};
  const std::vector<glm::dvec3> outer = across(ends, 1);
  for (std::size_t k = 1; k < pieces_.size(); ++k) {
    SidePiece& before = pieces_[k - 1].piece;
    SidePiece& behind = pieces_[k].piece;
    const double s = pieces_[k].from;
    const double length = lengths.empty() ? (1.0 - s) * length_of(outer[0]) + s * length_of(outer[1]) : lengths[k - 1];
    const Leaving leaving = leaving_between(before, behind, length);
    before.set_end(true, leaving.first, leaving.second);
    behind.set_end(false, leaving.first, leaving.second);
  }
  for (std::size_t k = 1; k < pieces_.size(); ++k) turn_alike(pieces_[k - 1].piece, pieces_[k].piece);
}

void HoleSide::bulge_towards(const Wanted& wanted, int order, int power) {
  constexpr int kPlaces = 17;
  if (continuity() < order) return;
  for (PlacedPiece& one : pieces_) {
    std::vector<double> inside;
    std::vector<double> s;
    for (int k = 1; k + 1 < kPlaces; ++k) {
      inside.push_back(static_cast<double>(k) / (kPlaces - 1));
      s.push_back(one.from + inside.back() * one.length());
    }
    one.piece.bulge_towards(inside, wanted(s), order, power);
  }
}

void HoleSide::bend_onward(double least) {
  for (PlacedPiece& one : pieces_) {
    const double left = one.piece.bend_onward();
    if (left > 0.0 && left >= least) continue;
    const bool is_at_start = !one.piece.leaves_onward(false);
    const std::string why = is_at_start                        ? " at its start, for the side before it runs on the neighbor's side there"
                            : !one.piece.leaves_onward(true) ? " at its end, for the side behind it runs on the neighbor's side there"
                                                             : ", for it turns too much or changes its pace too fast";
    throw InvalidShape("what leaves " + one.piece.name() + " turns back over its neighbor" + why +
                       ": every surface there would fold");
  }
}

AcrossJet HoleSide::jet(bool is_end) const {
  const PlacedPiece& one = piece_at(is_end);
  AcrossJet jet = one.piece.jet(is_end);
  double rate = 1.0;
  for (std::size_t order = 0; order < jet.first.size(); ++order) {
    jet.first[order] *= rate;
    jet.second[order] *= rate;
    rate /= one.length();
  }
  return jet;
}

std::array<glm::dvec3, 2> HoleSide::directions(bool is_end) const {
  const PlacedPiece& one = piece_at(is_end);
  const std::array<glm::dvec3, 2> inside = one.piece.directions(is_end);
  return {inside[0] / one.length(), inside[1] / (one.length() * one.length())};
}

void HoleSide::bend_first(bool is_end, double a, double b) {
  PlacedPiece& one = piece_at(is_end);
  one.piece.bend_first(is_end, a, b / one.length());
}

void HoleSide::bend_second(bool is_end, int order, double c, double d) {
  PlacedPiece& one = piece_at(is_end);
  const double rate = order == 1 ? 1.0 : one.length();
  one.piece.bend_second(is_end, order, c * rate, d * rate / one.length());
}

const PlacedPiece& HoleSide::piece_between(double from, double to) const {
  const double middle = 0.5 * (from + to);
  return *std::ranges::find_if(pieces_, [&](const PlacedPiece& one) { return middle < one.to; });
}

std::optional<NurbsPatch> HoleSide::neighbor_part(double from, double to) const {
  const PlacedPiece& one = piece_between(from, to);
  const auto inside = [&](double s) { return std::clamp((s - one.from) / one.length(), 0.0, 1.0); };
  return one.piece.neighbor_part(inside(from), inside(to));
}

}  // namespace splinecore
