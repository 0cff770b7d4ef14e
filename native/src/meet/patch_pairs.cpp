#include "patch_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "section_place.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

/// So narrow parts with weights of both signs, by their parameter, which run to infinity, are not halved: they are proved to
/// be outside, or refused.
constexpr double kNarrowAtInfinity = 0x1p-10;
constexpr std::size_t kMostPairs = std::size_t{3} << 17;
constexpr std::size_t kPointsOfLowDegree = 64;
constexpr std::size_t kMostWork = std::size_t{1} << 24;  ///< control points of all pairs together
constexpr std::size_t kMostTouching = std::size_t{1} << 13;
constexpr std::size_t kMostCrossing = std::size_t{1} << 18;

class PatchPairSearch {
 public:
  PatchPairSearch(const TwoPatches& patches, const PairLimits& limits, const IsPairKnown& is_matched,
                  const IsPairKnown& is_known)
      : patches_(patches), smallest_(limits.smallest), slack_(limits.rounding), tolerance_(limits.tolerance),
        gap_(limits.gap_of_copies),
        is_matched_(is_matched), is_known_(is_known) {}

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
    if (is_matched_(a, b)) return;
    if (const auto crossing = crossing_part(a, b, slack_)) return add(*crossing);
    const std::optional<HeightDifference> difference = height_difference(a, b, slack_);
    if (difference && difference->are_apart(slack_)) return;
    const auto crossing = difference ? crossing_part(a, b, *difference) : std::nullopt;
    if (crossing && is_deep(*difference)) return add(*crossing);
    if (a.is_boxed && b.is_boxed && is_known_(a, b)) return;
    const double size = std::max(a.largest_size(), b.largest_size());
    if (crossing && size <= kLargestOfTouch && difference->bend > kOneBend * tolerance_) return add(*crossing);
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
    if (!gap_.empty()) {
      throw InvalidShape("the shapes are nearly copies of each other, which part by " + gap_ +
                         " at most: a tolerance above that takes them as one; where they cross is not told" + pairs);
    }
    throw InvalidShape("the shapes nearly touch along a curve, or are nearly one in a part" + pairs);
  }

  TwoPatches patches_;
  double smallest_;
  double slack_;
  double tolerance_;
  std::string gap_;
  const IsPairKnown& is_matched_;
  const IsPairKnown& is_known_;
  std::size_t pairs_ = 0;
  std::size_t work_ = 0;
  PatchPairFindings found_;
};

}  // namespace

PatchPairFindings find_pairs(const TwoPatches& patches, const PairLimits& limits, const IsPairKnown& is_matched,
                             const IsPairKnown& is_known) {
  return PatchPairSearch(patches, limits, is_matched, is_known).found();
}

}  // namespace splinecore
