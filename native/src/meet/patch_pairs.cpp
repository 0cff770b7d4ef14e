#include "patch_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "matched_parts.hpp"
#include "section_place.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

/// So narrow parts with weights of both signs, by their parameter, which run to infinity, are not halved: they are proved to
/// be outside, or refused.
constexpr double kNarrowAtInfinity = 0x1p-10;
/// Of so small parts that cross in one line at most nobody asks whether they are one.
constexpr double kSmallCrossing = 0x1p-8;
constexpr std::size_t kMostPairs = std::size_t{1} << 20;
constexpr std::size_t kPointsOfLowDegree = 64;
constexpr std::size_t kMostWork = std::size_t{1} << 25;  ///< control points of all pairs together
constexpr std::size_t kMostTouching = std::size_t{1} << 13;
constexpr std::size_t kMostCrossing = std::size_t{1} << 18;

class PatchPairSearch {
 public:
  PatchPairSearch(const TwoPatches& patches, const PairLimits& limits, const IsPairKnown& is_known)
      : patches_(patches), smallest_(limits.smallest), slack_(limits.rounding), tolerance_(limits.tolerance),
        is_known_(is_known) {}

  PatchPairFindings found() {
    for_near_pairs(patches_.a.tree(), patches_.b.tree(), slack_, [&](std::size_t i, std::size_t j) {
      pair(PatchPart(i, {}, patches_.a.piece(i)), PatchPart(j, {}, patches_.b.piece(j)));
    });
    return std::move(found_);
  }

 private:
  static bool is_lost(const PatchPart& part) {
    return !part.is_boxed && std::max(part.range[0].length(), part.range[1].length()) <= kNarrowAtInfinity;
  }

  void pair(const PatchPart& a, const PatchPart& b) {
    breathe(64 * (a.net.values.size() + b.net.values.size()));
    if (++pairs_ > kMostPairs) refuse();
    work_ += a.net.values.size() + b.net.values.size();
    if (work_ > kMostWork) refuse_degree(std::max(a.net.values.size(), b.net.values.size()));
    if (are_apart(a, b, slack_)) return;
    if (is_lost(a) || is_lost(b)) refuse();
    if (const auto crossing = crossing_part(a, b)) return add(*crossing);
    const std::optional<MatchedParts> matched = matched_parts(a, b, slack_);
    if (matched && (matched->are_beside || matched->difference.are_apart(slack_))) return;
    if (matched && is_on_side(patches_.a, a, matched->of_a) && is_on_side(patches_.b, b, matched->of_b)) return;
    if (matched && is_less(matched->of_a, a.range, matched->of_b, b.range) && !is_thin(a, matched->of_a) &&
        !is_thin(b, matched->of_b)) {
      return narrow(a, b, *matched);
    }
    const std::optional<HeightDifference> difference =
        matched ? std::optional(matched->difference) : height_difference(a, b, slack_);
    if (difference && difference->are_apart(slack_)) return;
    const auto crossing = difference ? crossing_part(a, b, *difference) : std::nullopt;
    if (crossing && is_deep(*difference)) return add(*crossing);
    if (a.is_boxed && b.is_boxed && is_known_(a, b)) return;
    const double size = std::max(a.largest_size(), b.largest_size());
    if (crossing && size <= kLargestOfTouch && difference->bend > kOneBend * tolerance_) return add(*crossing);
    if (crossing && size <= kSmallCrossing) return add(*crossing);
    if (a.is_boxed && b.is_boxed && size <= smallest_size(difference, size)) {
      found_.touching.push_back({{a.piece, a.middle()}, {b.piece, b.middle()}});
      if (found_.touching.size() > kMostTouching) refuse();
      return;
    }
    const bool halves_a = a.is_boxed == b.is_boxed ? a.largest_size() >= b.largest_size() : !a.is_boxed;
    const auto [first, second] = (halves_a ? a : b).halves();
    halves_a ? pair(first, b) : pair(a, first);
    halves_a ? pair(second, b) : pair(a, second);
  }

  /// Whether what may be in common is so much less than the parts.
  static bool is_less(const RangesOfTwo& of_a, const RangesOfTwo& a, const RangesOfTwo& of_b, const RangesOfTwo& b) {
    constexpr double kLess = 0.5;
    for (std::size_t k = 0; k < 2; ++k) {
      if (of_a[k].length() < kLess * a[k].length() || of_b[k].length() < kLess * b[k].length()) return true;
    }
    return false;
  }

  void narrow(const PatchPart& a, const PatchPart& b, const MatchedParts& matched) {
    pair(a.within(Axis::u, matched.of_a[0]).within(Axis::v, matched.of_a[1]),
         b.within(Axis::u, matched.of_b[0]).within(Axis::v, matched.of_b[1]));
  }

  /// Whether all that counts of a part is a line, up to rounding.
  bool is_thin(const PatchPart& part, const RangesOfTwo& kept, std::size_t k) const {
    constexpr double kRoundings = 16.0;
    constexpr double kLess = 0x1p-8;
    const double share = kept[k].length() / part.range[k].length();
    return share < kLess && share * part.size[k] <= kRoundings * slack_;
  }
  bool is_thin(const PatchPart& part, const RangesOfTwo& kept) const { return is_thin(part, kept, 0) || is_thin(part, kept, 1); }

  /// Whether it is a side beyond which the patch goes on: then what is there is found beyond it, too.
  bool is_on_side(const PatchPieces& pieces, const PatchPart& part, const RangesOfTwo& kept) const {
    for (const Axis axis : {Axis::u, Axis::v}) {
      const std::size_t k = axis == Axis::u ? 0 : 1;
      if (!is_thin(part, kept, k)) continue;
      for (const bool is_end : {false, true}) {
        const double side = is_end ? part.range[k].end : part.range[k].start;
        const double rest = std::abs((is_end ? kept[k].end : kept[k].start) - side);
        if (rest <= kOnSide && goes_on(pieces, part, axis, is_end)) return true;
      }
    }
    return false;
  }

  static bool goes_on(const PatchPieces& pieces, const PatchPart& part, Axis axis, bool is_end) {
    const std::size_t k = axis == Axis::u ? 0 : 1;
    const double side = is_end ? part.range[k].end : part.range[k].start;
    if (side > 0.0 && side < 1.0) return true;
    const auto next = pieces.beyond(part.piece, {axis, is_end});
    if (!next) return false;
    PatchSpot here{part.piece, part.middle()};
    PatchSpot there{*next, part.middle()};
    here.at[k] = side;
    there.at[k] = 1.0 - side;
    constexpr double kFolded = -0.5;
    const glm::dvec3 before = pieces.at(here).first[k];
    const glm::dvec3 behind = pieces.at(there).first[k];
    return glm::dot(before, behind) > kFolded * glm::length(before) * glm::length(behind);
  }

  /// Whether surfaces cross at an angle that such that touch, or are one, within the tolerance have nowhere.
  bool is_deep(const HeightDifference& difference) const {
    const double of_touch = std::sqrt(difference.bend * tolerance_);
    return difference.least_slope > std::max(kOneSlope * tolerance_, of_touch);
  }

  /// Of parts that touch, and whose distance is rounding all over, smaller ones tell no more.
  double smallest_size(const std::optional<HeightDifference>& difference, double size) const {
    constexpr double kRoundings = 4.0;
    constexpr double kLargest = 0x1p-10;
    if (!difference || !difference->are_within(kRoundings * slack_)) return smallest_;
    const bool is_bent = difference->bend > kOneBend * tolerance_ && difference->bend * size * size > slack_;
    return is_bent ? std::max(smallest_, kLargest) : smallest_;
  }

  void add(const CrossingPart& part) {
    if (found_.crossing.size() == kMostCrossing) refuse();
    found_.crossing.push_back({part.a.piece, part.a.range, part.b.piece, part.b.range, part.signs, part.lead});
  }

  [[noreturn]] void refuse_degree(std::size_t points) const {
    if (points <= kPointsOfLowDegree) refuse();
    throw InvalidShape("the shapes have pieces of degrees so high, of up to " + std::to_string(points) +
                       " control points, that telling which parts cross takes too long: approximate them by lower degrees");
  }

  [[noreturn]] void refuse() const {
    const auto is_unbounded = [](const PatchPieces& pieces) {
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!PatchPart(i, {}, pieces.piece(i)).is_boxed) return true;
      }
      return false;
    };
    const std::string pairs = ": more than " + std::to_string(pairs_ - 1) + " pairs of parts are not apart";
    if (is_unbounded(patches_.a) || is_unbounded(patches_.b)) {
      throw InvalidShape("a shape has weights of both signs and may run through infinity where the other one is" + pairs);
    }
    throw InvalidShape("the shapes nearly touch along a curve, or are nearly one in a part" + pairs);
  }

  TwoPatches patches_;
  double smallest_;
  double slack_;
  double tolerance_;
  const IsPairKnown& is_known_;
  std::size_t pairs_ = 0;
  std::size_t work_ = 0;
  PatchPairFindings found_;
};

}  // namespace

PatchPairFindings find_pairs(const TwoPatches& patches, const PairLimits& limits, const IsPairKnown& is_known) {
  return PatchPairSearch(patches, limits, is_known).found();
}

}  // namespace splinecore
