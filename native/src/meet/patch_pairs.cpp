#include "patch_pairs.hpp"

#include <algorithm>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

/// So narrow parts with weights of both signs, by their parameter, which run to infinity, are not halved.
constexpr double kNarrowAtInfinity = 0x1p-10;
constexpr std::size_t kMostPairs = std::size_t{1} << 20;
constexpr std::size_t kMostTouching = std::size_t{1} << 13;
constexpr std::size_t kMostCrossing = std::size_t{1} << 18;

class PatchPairSearch {
 public:
  PatchPairSearch(const TwoPatches& patches, double smallest, double rounding, const IsPairKnown& is_known)
      : patches_(patches), smallest_(smallest), slack_(rounding), is_known_(is_known) {}

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
    if (is_lost(a) || is_lost(b) || are_apart(a, b, slack_)) return;
    if (const auto crossing = crossing_part(a, b)) {
      if (found_.crossing.size() == kMostCrossing) refuse();
      return found_.crossing.push_back({a.piece, a.range, b.piece, b.range, crossing->signs, crossing->lead});
    }
    if (a.is_boxed && b.is_boxed && is_known_(a, b)) return;
    if (a.is_boxed && b.is_boxed && std::max(a.largest_size(), b.largest_size()) <= smallest_) {
      found_.touching.push_back({{a.piece, a.middle()}, {b.piece, b.middle()}});
      if (found_.touching.size() > kMostTouching) refuse();
      return;
    }
    const bool halves_a = a.is_boxed == b.is_boxed ? a.largest_size() >= b.largest_size() : !a.is_boxed;
    const auto [first, second] = (halves_a ? a : b).halves();
    halves_a ? pair(first, b) : pair(a, first);
    halves_a ? pair(second, b) : pair(a, second);
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
  const IsPairKnown& is_known_;
  std::size_t pairs_ = 0;
  PatchPairFindings found_;
};

}  // namespace

PatchPairFindings find_pairs(const TwoPatches& patches, double smallest, double rounding,
                             const IsPairKnown& is_known) {
  return PatchPairSearch(patches, smallest, rounding, is_known).found();
}

}  // namespace splinecore
