#include "matched_borders.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "side_places.hpp"

namespace splinecore {

namespace {

class MatchedSides {
 public:
  MatchedSides(const TwoPatches& patches, const std::array<AxisMatch, 2>& axes,
               const std::array<std::vector<MatchedSpan>, 2>& spans, double tolerance)
      : patches_(patches), axes_(axes), spans_(spans), tolerance_(tolerance) {}

  std::vector<SectionTrace> borders() const {
    std::vector<SectionTrace> found;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      for (const bool is_end : {false, true}) {
        if (is_border(k, is_end)) found.push_back(side(k, is_end));
      }
    }
    return found;
  }

 private:
  const MatchedSpan& outermost(std::size_t k, bool is_end) const { return is_end ? spans_[k].back() : spans_[k].front(); }
  std::size_t own_axis(std::size_t k) const { return axes_[k].axis == Axis::u ? 0 : 1; }

  /// A place of the side at an end of axis k, by a share of a stretch of the other axis.
  PatchSpots spots(std::size_t k, bool is_end, const MatchedSpan& along, double share) const {
    const MatchedSpan& across = outermost(k, is_end);
    const double end = is_end ? 1.0 : 0.0;
    const bool is_exchanged = axes_[0].axis == Axis::v;
    return k == 0 ? matched_spots(patches_, is_exchanged, {across, along}, {end, share})
                  : matched_spots(patches_, is_exchanged, {along, across}, {share, end});
  }

  static bool ends_at(const PatchPieces& patch, const PatchSpot& spot, std::size_t axis) {
    const double t = spot.at[axis];
    if (t != 0.0 && t != 1.0) return false;
    return !patch.beyond(spot.piece, {axis == 0 ? Axis::u : Axis::v, t == 1.0});
  }

  static bool is_at_pole(const PatchPieces& patch, const PatchSpot& spot, std::size_t axis) {
    const double t = spot.at[axis];
    return (t == 0.0 || t == 1.0) && patch.is_pole(spot.piece, {axis == 0 ? Axis::u : Axis::v, t == 1.0});
  }

  bool is_border(std::size_t k, bool is_end) const {
    const auto is_pole = [&](const MatchedSpan& along) {
      const PatchSpots at = spots(k, is_end, along, 0.5);
      return is_at_pole(patches_.a, at.a, k) || is_at_pole(patches_.b, at.b, own_axis(k));
    };
    if (std::ranges::all_of(spans_[1 - k], is_pole)) return false;
    const PatchSpots at = spots(k, is_end, spans_[1 - k].front(), 0.5);
    return ends_at(patches_.a, at.a, k) || ends_at(patches_.b, at.b, own_axis(k));
  }

  SectionPlace place(std::size_t k, bool is_end, const MatchedSpan& along, double share) const {
    const PatchSpots at = spots(k, is_end, along, share);
    const PatchMeeting here = meeting_at(patches_, at);
    SectionPlace found{at, here.a.point + 0.5 * here.b.offset, glm::dvec3(0.0), {}};
    const glm::dvec3& slope = here.a.first[1 - k];
    const double speed = glm::length(slope);
    if (!(speed > 0.0)) return found;
    found.tangent = slope / speed;
    found.slopes[1 - k] = 1.0 / speed;
    found.slopes[2 + (1 - own_axis(k))] = (along.is_reversed ? -1.0 : 1.0) * along.b.length() / along.a.length() / speed;
    return found;
  }

  SectionTrace side(std::size_t k, bool is_end) const {
    SectionTrace trace{{}, false};
    for (const MatchedSpan& along : spans_[1 - k]) {
      add_places(trace, patches_, [&](double share) { return place(k, is_end, along, share); }, tolerance_);
    }
    constexpr double kSame = 0x1p-36;
    trace.is_closed = glm::distance(trace.places.front().point, trace.places.back().point) <= kSame;
    return trace;
  }

  TwoPatches patches_;
  const std::array<AxisMatch, 2>& axes_;
  const std::array<std::vector<MatchedSpan>, 2>& spans_;
  double tolerance_;
};

}  // namespace

std::vector<SectionTrace> matched_borders(const TwoPatches& patches, const std::array<AxisMatch, 2>& axes,
                                          const std::array<std::vector<MatchedSpan>, 2>& spans, double tolerance) {
  return MatchedSides(patches, axes, spans, tolerance).borders();
}

}  // namespace splinecore
