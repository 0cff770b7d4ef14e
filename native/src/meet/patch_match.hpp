#pragma once

#include <array>
#include <optional>
#include <vector>

#include "patch_part.hpp"
#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where a parameter of one patch goes from `from.start` to `from.end` the matching one of the other goes from `start` to
/// `end`, evenly.
struct AxisMatch {
  Axis axis;      ///< of the other patch
  Interval from;  ///< as far as both go
  double start;
  double end;

  double to(double t) const noexcept { return start + (t - from.start) / from.length() * (end - start); }
  double back(double s) const noexcept { return from.start + (s - start) / (end - start) * from.length(); }
  Interval back(const Interval& range) const noexcept {
    const double one = back(range.start);
    const double other = back(range.end);
    return one < other ? Interval{one, other} : Interval{other, one};
  }
};

/// A stretch of a parameter that is in one span of both patches, as ranges in [0, 1] of these.
struct MatchedSpan {
  std::size_t span_a;
  Interval a;
  std::size_t span_b;
  Interval b;
  bool is_reversed;

  double b_at(double share) const noexcept {
    return is_reversed ? b.end - share * b.length() : b.start + share * b.length();
  }
};

/// A place of both patches, by shares of a stretch of each parameter of the first one.
PatchSpots matched_spots(const TwoPatches& patches, bool is_exchanged, const std::array<MatchedSpan, 2>& spans,
                         const std::array<double, 2>& shares);

/// What of two patches is one surface by parameters that match: copies, however refined, reversed or written, and parts of
/// them. It is proved over all of a rectangle by control points.
class PatchMatch {
 public:
  /// @param tolerance  how far matching places are apart at most
  static std::optional<PatchMatch> of(const TwoPatches& patches, double tolerance);

  /// Whether parts have no place in common but such as match, or such as lie so near to them: both are in one sheet that
  /// nowhere turns over.
  bool explains(const PatchPart& a, const PatchPart& b) const;

  /// How far the patches part across, as far as places all over tell.
  double largest_gap() const;

  /// Whether both places are in what is one.
  bool holds(const PatchSpots& at) const { return is_within(at, 0x1p-40); }

  /// The same, or but a little beyond it.
  bool is_about(const PatchSpots& at) const { return is_within(at, 0x1p-10); }

  /// Whether the places match, nearly.
  bool joins(const PatchSpots& at) const;

  /// The sides of what is one beyond which one of the patches does not go on.
  std::vector<SectionTrace> borders() const;

 private:
  PatchMatch(const TwoPatches& patches, const std::array<AxisMatch, 2>& axes, double tolerance)
      : patches_(patches), axes_(axes), tolerance_(tolerance) {}

  bool is_within(const PatchSpots& at, double slack) const;
  bool is_near_at_places() const;
  bool is_near_all_over() const;
  bool is_exchanged() const noexcept { return axes_[0].axis == Axis::v; }
  std::vector<MatchedSpan> spans_along(std::size_t k) const;
  std::array<Interval, 2> range_of(const PatchPart& b) const;
  bool goes_on_over_end(std::size_t k) const;

  TwoPatches patches_;
  std::array<AxisMatch, 2> axes_;  ///< of parameters of the first patch
  double tolerance_;
};

}  // namespace splinecore
#pragma GCC visibility pop
