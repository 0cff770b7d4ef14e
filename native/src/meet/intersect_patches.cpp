#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "base/printable.hpp"
#include "base/require.hpp"
#include "base/rounding.hpp"
#include "branch_search.hpp"
#include "joined_traces.hpp"
#include "level_pieces.hpp"
#include "operand_order.hpp"
#include "patch_march.hpp"
#include "patch_match.hpp"
#include "patch_pairs.hpp"
#include "patch_touching.hpp"
#include "plane_patch.hpp"
#include "ridge_traces.hpp"
#include "section_curve.hpp"
#include "shared_edges.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/meet/sections.hpp"
#include "traced_steps.hpp"

namespace splinecore {

namespace {

/// How far curves may be from the patches, in their space.
double section_tolerance(const NearSpace& space, std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  constexpr double kOfSize = 0x1p-20;
  constexpr double kRounding = 0x1p-36;
  return std::max(tolerance ? *tolerance / space.length(1.0) : kOfSize, kRounding + 4.0 * space.rounding());
}

/// So many tolerances from where patches touch a place is told from it.
constexpr double kTolerancesOfTouch = 16.0;

Sections exchanged(Sections found) {
  for (SectionCurve& curve : found.curves) std::swap(curve.on_a, curve.on_b);
  for (SectionPoint& point : found.points) std::swap(point.a, point.b);
  return found;
}

/// Two patches in a space of their own, and the tolerance there.
class SectionSearch {
 public:
  /// @param is_plane  whether the second one is flat, and reaches beyond the first one
  SectionSearch(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance, bool is_plane = false)
      : space_(NearSpace(together(a.points(), b.points())).of_size_one()), a_(a, space_), b_(b, space_),
        tolerance_(section_tolerance(space_, tolerance)), match_(found_match()),
        touching_({a_, b_}, tolerance_), crossing_({a_, b_}, tolerance_) {
    if (is_plane && !match_) level_.emplace(patches(), rounding());
  }

  Sections found() {
    constexpr double kSmallest = 0x1p-26;
    constexpr double kOfTolerance = 0x1p-4;  // a loop ten tolerances wide is told from a point
    const IsPairKnown is_matched = [&](const PatchPart& a, const PatchPart& b) {
      return (match_ && match_->explains(a, b)) || (level_ && level_->explains(a));
    };
    const IsPairKnown is_known = [&](const PatchPart& a, const PatchPart& b) { return touching_.knows(a, b); };
    const double smallest = std::max(kOfTolerance * tolerance_, kSmallest);
    if (level_ && level_->are_told()) take_level();
    if (match_) {
      touching_.is_known_place = [&](const PatchSpots& at) { return match_->is_about(at); };
      for (SectionTrace& border : match_->borders()) touching_.add_border(std::move(border));
    }
    for (const SectionTouch& turn : follow_shared_edges()) note(turn, true);
    touching_.is_crossing = [&](const glm::dvec3& point) { return crossing_.are_near(point, tolerance_); };
    const PatchPairFindings pairs = find_pairs(patches(), {smallest, rounding(), tolerance_, gap_of_copies_}, is_matched,
                                                 is_known);
    touching_.follow_borders();
    if (const auto place = touching_.lost_border()) {
      throw InvalidShape("the border of what the shapes have in common cannot be followed beyond " +
                         place_text(space_.leave(*place)) + ": one of them may be folded there");
    }
    for (const PatchSpots& middle : pairs.touching) touch(middle);
    for (const SectionTrace& trace : touching_.traces()) end_at_changes(trace);
    BranchSearch search(patches(), crossing_, smallest, rounding());
    search.on_seed = [&](const SectionPlace& seed) { return trace(seed); };
    search.is_known_pair = is_matched;
    search.is_known_place = [&](const PatchSpots& at) { return match_ && match_->joins(at); };
    search.on_contact = [&](const PatchSpots& at) { contacts_.push_back({at, a_.at(at.a).point}); };
    for (const CrossingRanges& ranges : pairs.crossing) search.explore(ranges.of(patches()));
    if (level_ && level_->any() && !level_->are_told()) {
      add_level_borders([&](const glm::dvec3& point) { return is_on_curve(point); });
    }
    const auto is_end = [&](const glm::dvec3& point) { return is_touch_near(point); };
    const SortedTraces sorted = without_ridges(patches(), crossing_.traces(), tolerance_);
    const std::vector<SectionTrace> crossing = joined_traces(patches(), sorted.crossing, is_end, tolerance_);
    Sections found;
    found.are_one = match_ || (touching_.are_one() && (gap_of_copies_.empty() || !touching_.borders().empty()));
    put(crossing, SectionKind::crossing, found);
    put(touching_.traces(), SectionKind::touching, found);
    put(level_touches_, SectionKind::touching, found);
    put(joined_traces(patches(), sorted.ridges, is_end, tolerance_), SectionKind::touching, found);
    put(touching_.borders(), SectionKind::border, found);
    for (const SectionTouch& touch : near_touches_) add_lonely(touch, found);
    for (const SectionTrace& trace : crossing) {
      if (is_point(trace)) add_lonely({trace.places.front().at, trace.places.front().point}, found);
    }
    for (const SectionTouch& contact : contacts_) {
      if (!crossing_.are_near(contact.point, 4.0 * smallest)) add_lonely(contact, found);
    }
    return found;
  }

 private:
  TwoPatches patches() const { return {a_, b_}; }

  double rounding() const {
    return kRoundingOfSum + 2.0 * space_.rounding();
  }

  /// What is one by parameters that match. Copies that part a little farther than the tolerance are looked at by a smaller one,
  /// of which where they cross they part plainly.
  std::optional<PatchMatch> found_match() {
    constexpr double kPlainly = 128.0;
    constexpr double kRounding = 0x1p-36;
    if (auto match = PatchMatch::of(patches(), tolerance_)) return match;
    auto nearly = PatchMatch::of(patches(), kPlainly * tolerance_);
    if (!nearly) return {};
    const double gap = nearly->largest_gap();
    if (gap <= tolerance_) return nearly;
    tolerance_ = std::max(gap / kPlainly, kRounding + 4.0 * space_.rounding());
    gap_of_copies_ = text_of(space_.length(gap));
    return {};
  }

  static double length_of(const SectionTrace& trace) {
    double length = 0.0;
    for (std::size_t i = 1; i < trace.places.size(); ++i) {
      length += glm::distance(trace.places[i].point, trace.places[i - 1].point);
    }
    return length;
  }

  bool is_point(const SectionTrace& trace) const { return !(length_of(trace) > tolerance_); }

  void put(const std::vector<SectionTrace>& traces, SectionKind kind, Sections& found) const {
    for (const SectionTrace& trace : traces) {
      if (is_point(trace) || (kind == SectionKind::touching && (is_in_match(trace) || is_at_crossing(trace)))) continue;
      found.curves.push_back(section_curve(trace, patches(), space_));
      found.curves.back().kind = kind;
    }
  }

  void add_level_borders(const std::function<bool(const glm::dvec3&)>& is_known) {
    for (SectionTrace& border : level_->borders(0.5 * tolerance_, is_known)) touching_.add_border(std::move(border), true);
  }

  /// Takes what pieces that lie in the plane say of how the patch leaves it.
  void take_level() {
    add_level_borders([](const glm::dvec3&) { return false; });
    for (LevelLine& line : level_->lines(0.5 * tolerance_)) {
      if (line.is_crossing) {
        crossing_.add(std::move(line.trace));
      } else {
        level_touches_.push_back(std::move(line.trace));
      }
    }
  }

  /// Whether all of it is in what is one, where creases and poles look like curves of touch.
  bool is_in_match(const SectionTrace& trace) const {
    return match_ && std::ranges::all_of(trace.places, [&](const SectionPlace& place) { return match_->holds(place.at); });
  }

  /// Whether a curve of touch is so short that it is but the place, as a pole is, that a curve along which they cross comes to.
  bool is_at_crossing(const SectionTrace& trace) const {
    const double near = kTolerancesOfTouch * tolerance_;
    const glm::dvec3& first = trace.places.front().point;
    const auto is_near = [&](const SectionPlace& place) { return glm::distance(place.point, first) <= near; };
    return std::ranges::all_of(trace.places, is_near) && crossing_.are_near(first, near);
  }

  SeedFate trace(const SectionPlace& seed) {
    if (touching_.is_near(seed.point, 4.0 * tolerance_) || touching_.runs_by(seed)) return SeedFate::known;
    if (is_near_touch(seed) || (match_ && match_->joins(seed.at))) return SeedFate::known;
    const auto is_known = [&](const SectionPlace& place) { return crossing_.holds_along(place); };
    SectionTrace found = traced(patches(), seed, {{}, touches_, 0.5 * tolerance_, is_known});
    found = crossing_.without_known_ends(std::move(found));
    if (found.places.empty()) return SeedFate::known;
    crossing_.add(std::move(found));
    return SeedFate::traced;
  }

  bool is_on_curve(const glm::dvec3& point) const {
    return crossing_.are_near(point, 4.0 * tolerance_) || touching_.is_near(point, 4.0 * tolerance_);
  }

  /// Whether patches touch near a point.
  bool is_touch_near(const glm::dvec3& point) const {
    const double near = kTolerancesOfTouch * tolerance_;
    const auto is_here = [&](const SectionTouch& touch) { return glm::distance(touch.point, point) <= near; };
    return touching_.is_near(point, near) || std::ranges::any_of(touches_, is_here);
  }

  /// Whether a place is so near to where the patches touch, or to a pole, that they are within the tolerance on the way there.
  bool is_near_touch(const SectionPlace& place) const {
    constexpr double kNear = 0x1p-14;
    constexpr double kTolerances = 4.0;
    const double sine = glm::length(meeting_at(patches(), place.at).along);
    return std::ranges::any_of(near_touches_, [&](const SectionTouch& touch) {
      const double far = glm::distance(touch.point, place.point);
      return far <= kTolerancesOfTouch * tolerance_ || (far <= kNear && sine * far <= kTolerances * tolerance_);
    });
  }

  /// Whether between two such places patches are within the tolerance, where rounding does not tell which it is.
  bool are_one_touch(const SectionTouch& one, const SectionTouch& other) const {
    constexpr double kNear = 0x1p-10;
    const double far = glm::distance(one.point, other.point);
    const auto sine = [&](const SectionTouch& touch) { return glm::length(meeting_at(patches(), touch.at).along); };
    return far <= kNear && std::max(sine(one), sine(other)) * far <= tolerance_;
  }

  /// Notes where patches touch in parts, or may do: at a pole nothing tells where normals are parallel.
  void touch(const PatchSpots& middle) {
    std::optional<PatchSpots> at = touch_near(patches(), middle);
    const bool is_exact = at && enters(*at);
    if (!is_exact) at = middle;
    const PatchMeeting there = meeting_at(patches(), *at);
    constexpr double kNoGap = 0x1p-40;
    if (there.distance() > (is_exact ? kNoGap + 0.01 * tolerance_ * tolerance_ : tolerance_)) return;
    note({*at, there.a.point + 0.5 * there.b.offset}, is_exact);
  }

  /// How patches that touch along a curve part across it.
  double parted(const PatchSpots& at) const {
    const std::optional<Parting> parting = parting_at(meeting_at(patches(), at));
    return parting ? parting->along + parting->across : 0.0;
  }

  /// Where patches that touch along a curve part to the other side from there on: a curve along which they cross comes to it.
  void end_at_changes(const SectionTrace& trace) {
    constexpr double kNothing = 0x1p-30;
    const std::vector<SectionPlace>& places = trace.places;
    std::vector<double> values;
    for (const SectionPlace& place : places) values.push_back(parted(place.at));
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::abs(value));
    const auto tells = [&](std::size_t i) { return std::abs(values[i]) > kNothing * most; };
    std::size_t before = 0;
    while (before < places.size() && !tells(before)) ++before;
    const std::size_t count = places.size();
    const std::size_t end = trace.is_closed ? count + before : count - 1;
    for (std::size_t k = before + 1; k <= end && before < count; ++k) {
      const std::size_t i = k % count;
      if (!tells(i)) continue;
      const std::size_t last = std::exchange(before, i);
      if ((values[i] < 0.0) == (values[last] < 0.0)) continue;
      const SectionPlace& from = places[last];
      const SectionPlace& to = places[(last + 1) % count];
      note((last + 1) % count == i && from.has_pieces_of(to) ? change(from, to) : SectionTouch{to.at, to.point}, true);
    }
  }

  /// The place between two others where patches that touch part to neither side.
  SectionTouch change(const SectionPlace& from, const SectionPlace& to) const {
    constexpr int kHalvings = 40;
    const SectionStep step(from, to);
    const bool is_below = parted(from.at) < 0.0;
    Interval range{0.0, 1.0};
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = range.middle();
      ((parted(step.spots(middle)) < 0.0) == is_below ? range.start : range.end) = middle;
    }
    return {step.spots(range.middle()), step.point(range.middle())};
  }

  /// Borders of one patch that lie on the other one. @returns where patches that have such a border in common touch
  std::vector<SectionTouch> follow_shared_edges() {
    constexpr double kRounding = 0x1p-36;
    if (match_) return {};
    SharedEdges edges = shared_edges(patches(), tolerance_, kRounding + 4.0 * space_.rounding());
    for (SectionTrace& edge : edges.traces) crossing_.add(std::move(edge));
    return std::move(edges.turns);
  }

  /// Keeps a place where patches touch. is_exact: whether it is known to be one, so that curves end there.
  void note(const SectionTouch& touch, bool is_exact) {
    const auto is_here = [&](const SectionTouch& other) { return glm::distance(other.point, touch.point) <= tolerance_; };
    const auto known = std::ranges::find_if(near_touches_, is_here);
    if (known == near_touches_.end()) {
      near_touches_.push_back(touch);
    } else if (is_exact) {
      *known = touch;
    }
    if (!is_exact) return;
    for (const PatchSpot& in_a : a_.twins(touch.at.a, kOnSide)) {
      for (const PatchSpot& in_b : b_.twins(touch.at.b, kOnSide)) {
        const PatchSpots twin{in_a, in_b};
        const auto is_this = [&](const SectionTouch& other) {
          return other.at.a.piece == in_a.piece && other.at.b.piece == in_b.piece && is_here(other);
        };
        if (std::ranges::none_of(touches_, is_this)) touches_.push_back({twin, touch.point});
      }
    }
  }

  /// A place that is all that the patches have in common there, if no curve goes by.
  void add_lonely(const SectionTouch& touch, Sections& found) {
    if (match_ && match_->holds(touch.at)) return;
    const auto is_here = [&](const SectionPlace& place) {
      return glm::distance(place.point, touch.point) <= 4.0 * tolerance_;
    };
    const bool is_on_curve = std::ranges::any_of(crossing_.traces(), [&](const SectionTrace& trace) {
      return !is_point(trace) && std::ranges::any_of(trace.places, is_here);
    });
    if (is_on_curve || touching_.is_near(touch.point, kTolerancesOfTouch * tolerance_)) return;
    const glm::dvec3 out = space_.leave(touch.point);
    const double near = 4.0 * space_.length(tolerance_);
    const auto is_known = [&](const SectionPoint& other) { return distance_of(other.point, out) <= near; };
    if (std::ranges::any_of(found.points, is_known)) return;
    if (std::ranges::any_of(lonely_, [&](const SectionTouch& other) { return are_one_touch(other, touch); })) return;
    lonely_.push_back(touch);
    found.points.push_back({a_.parameters(touch.at.a), b_.parameters(touch.at.b), out});
  }

  NearSpace space_;
  PatchPieces a_;
  PatchPieces b_;
  double tolerance_;
  std::string gap_of_copies_;  ///< of such that part by more than the tolerance, but not much
  std::optional<PatchMatch> match_;
  std::optional<LevelPieces> level_;
  std::vector<SectionTrace> level_touches_;
  TouchingCurves touching_;
  std::vector<SectionTouch> near_touches_;  ///< where the patches touch, or a pole is
  std::vector<SectionTouch> touches_;       ///< where normals are parallel, in every piece
  std::vector<SectionTouch> contacts_;      ///< where patches that cross have but a point in common
  std::vector<SectionTouch> lonely_;        ///< in points that were found
  TracedSteps crossing_;
};

}  // namespace

Sections sections(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance) {
  if (are_exchanged(a, b)) return exchanged(SectionSearch(b, a, tolerance).found());
  return SectionSearch(a, b, tolerance).found();
}

Sections sections(const NurbsPatch& patch, const Plane& plane, std::optional<double> tolerance) {
  return SectionSearch(patch, plane_about(patch.points(), plane), tolerance, true).found();
}

}  // namespace splinecore
