#pragma once

#include <functional>

#include "crossing_part.hpp"
#include "traced_steps.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is to be done with a place that two patches have in common.
enum class SeedFate {
  traced,   ///< the curve through it is known from now on
  known,    ///< it was known before, or is not told from what is
};

/// Looks for all curves of parts of two patches that cross, until each part is proved to have no other.
///
/// In such a part there is one place at most for each value of the leading parameter. So what known curves leave of its
/// range is looked at: where hulls are apart there is nothing, where Newton's method finds a place there is a curve, and
/// what is neither is halved, down to a small part of the tolerance, where the patches are within it.
class BranchSearch {
 public:
  /// @param smallest  parts of that size are not halved
  BranchSearch(const TwoPatches& patches, const TracedSteps& traced, double smallest, double rounding)
      : patches_(patches), traced_(traced), smallest_(smallest), slack_(rounding) {}

  /// Called with places in no curve that is known.
  std::function<SeedFate(const SectionPlace&)> on_seed;
  /// Called with places where patches are within the smallest size, which no curve goes through that is known by then.
  std::function<void(const PatchSpots&)> on_contact;

  /// Whether all that parts may have in common is known, or all about a place, beside what curves tell.
  std::function<bool(const PatchPart&, const PatchPart&)> is_known_pair;
  std::function<bool(const PatchSpots&)> is_known_place;

  void explore(const CrossingPart& part);

 private:
  void search(const CrossingPart& part);
  bool are_heights_apart(const CrossingPart& part) const;
  void halve(const CrossingPart& part);
  bool is_known_all_along(const CrossingPart& part) const;
  std::optional<SectionPlace> place_near_part(const CrossingPart& part, double of_lead) const;

  TwoPatches patches_;
  const TracedSteps& traced_;
  double smallest_;
  double slack_;
  std::size_t looks_ = 0;
};

}  // namespace splinecore
#pragma GCC visibility pop
