#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "base/length.hpp"
#include "patch/tolerance.hpp"
#include "patch_march.hpp"
#include "patch_pairs.hpp"
#include "patch_touching.hpp"
#include "plane_patch.hpp"
#include "section_curve.hpp"
#include "splinecore/meet/sections.hpp"

namespace splinecore {

namespace {

/// Places in which a pair of places is the same one: in the pieces beyond sides that it is on.
std::vector<PatchSpot> twins_of(const PatchPieces& pieces, const PatchSpot& spot) {
  std::vector<PatchSpot> twins{spot};
  for (const Axis axis : {Axis::u, Axis::v}) {
    const std::size_t k = axis == Axis::u ? 0 : 1;
    const std::size_t count = twins.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const bool is_end : {false, true}) {
        if (std::abs(twins[i].at[k] - (is_end ? 1.0 : 0.0)) > kOnSide) continue;
        const auto next = pieces.beyond(twins[i].piece, {axis, is_end});
        if (!next) continue;
        PatchSpot twin{*next, twins[i].at};
        twin.at[k] = is_end ? 0.0 : 1.0;
        twins.push_back(twin);
      }
    }
  }
  return twins;
}

/// How far curves may be from the patches, in their space.
double section_tolerance(const NearSpace& space, std::optional<double> tolerance) {
  require_tolerance(tolerance);
  constexpr double kOfSize = 0x1p-20;
  constexpr double kRounding = 0x1p-36;
  return std::max(tolerance ? *tolerance / space.length(1.0) : kOfSize, kRounding + 4.0 * space.rounding());
}

/// Two patches in a space of their own, and the tolerance there.
class SectionSearch {
 public:
  SectionSearch(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance)
      : space_(together(a.points(), b.points())), a_(a, space_), b_(b, space_),
        tolerance_(section_tolerance(space_, tolerance)), touching_({a_, b_}, tolerance_) {}

  Sections found() {
    constexpr double kRounding = 0x1p-48;
    constexpr double kSmallest = 0x1p-26;
    constexpr double kOfTolerance = 0x1p-4;  // a loop ten tolerances wide is told from a point
    const IsPairKnown is_known = [&](const PatchPart& a, const PatchPart& b) { return touching_.knows(a, b); };
    const PatchPairFindings pairs = find_pairs(patches(), std::max(kOfTolerance * tolerance_, kSmallest),
                                               kRounding + 2.0 * space_.rounding(), is_known);
    for (const PatchSpots& middle : pairs.touching) touch(middle);
    for (const PatchSpots& middle : pairs.crossing) trace(middle);
    Sections found;
    found.are_one = touching_.are_one();
    put(traces_, SectionKind::crossing, found);
    put(touching_.traces(), SectionKind::touching, found);
    put(touching_.borders(), SectionKind::border, found);
    for (const SectionTouch& touch : near_touches_) add_lonely(touch, found);
    return found;
  }

 private:
  struct StepOfTrace {
    std::size_t trace;
    std::size_t step;
  };

  TwoPatches patches() const { return {a_, b_}; }

  static double length_of(const SectionTrace& trace) {
    double length = 0.0;
    for (std::size_t i = 1; i < trace.places.size(); ++i) {
      length += glm::distance(trace.places[i].point, trace.places[i - 1].point);
    }
    return length;
  }

  void put(const std::vector<SectionTrace>& traces, SectionKind kind, Sections& found) const {
    for (const SectionTrace& trace : traces) {
      if (!(length_of(trace) > tolerance_)) continue;
      found.curves.push_back(section_curve(trace, patches(), space_));
      found.curves.back().kind = kind;
    }
  }

  void trace(const PatchSpots& middle) {
    const std::optional<SectionPlace> seed = seed_near(middle);
    if (!seed || touching_.is_near(seed->point, 4.0 * tolerance_) || is_traced(*seed)) return;
    traces_.push_back(traced(patches(), *seed, {{}, touches_, 0.5 * tolerance_}));
    const std::vector<SectionPlace>& places = traces_.back().places;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (!places[i].has_pieces_of(places[i + 1])) continue;
      steps_[{places[i].at.a.piece, places[i].at.b.piece}].push_back({traces_.size() - 1, i});
    }
  }

  /// The place of both patches nearest to the middles of parts, in their pieces; where it lies beyond, on their sides.
  std::optional<SectionPlace> seed_near(const PatchSpots& middle) const {
    const PatchMeeting there = meeting_at(patches(), middle);
    const double sine = glm::length(there.along);
    if (!(sine > 0.0)) return {};
    const InPlane plane{there.a.point + 0.5 * there.b.offset, there.along / sine};
    std::optional<PatchSpots> at = place_near(patches(), middle, plane);
    if (!at) return {};
    if (enters(*at)) return section_place(patches(), *at);
    for (std::size_t i = 0; i < 4; ++i) {
      if ((*at)[i] >= 0.0 && (*at)[i] <= 1.0) continue;
      auto on_side = place_near(patches(), *at, OnFace{i, (*at)[i] > 1.0 ? 1.0 : 0.0});
      if (on_side && enters(*on_side)) return section_place(patches(), *on_side);
    }
    return {};
  }

  bool is_traced(const SectionPlace& seed) const {
    // Nothing is to be told of what lies so near to a place where the patches touch, or to a pole.
    constexpr double kNear = 0x1p-14;
    const double near = std::max(kNear, 16.0 * tolerance_);
    const auto is_near = [&](const SectionTouch& touch) { return glm::distance(touch.point, seed.point) <= near; };
    if (std::ranges::any_of(near_touches_, is_near)) return true;
    for (const PatchSpot& in_a : twins_of(a_, seed.at.a)) {
      for (const PatchSpot& in_b : twins_of(b_, seed.at.b)) {
        const auto steps = steps_.find({in_a.piece, in_b.piece});
        if (steps == steps_.end()) continue;
        if (std::ranges::any_of(steps->second, [&](const StepOfTrace& step) { return is_on(step, seed); })) return true;
      }
    }
    return false;
  }

  /// Whether Newton's method comes to a place from the step of a trace beside it: where surfaces cross at a small angle a
  /// step may be far from the place, within the tolerance of both.
  bool is_on(const StepOfTrace& which, const SectionPlace& place) const {
    const SectionTrace& trace = traces_[which.trace];
    const SectionStep step(trace.places[which.step], trace.places[which.step + 1]);
    const glm::dvec3 chord = step.to.point - step.from.point;
    const double square = glm::dot(chord, chord);
    if (!(square > 0.0)) return false;
    const double s = glm::dot(place.point - step.from.point, chord) / square;
    const double beyond = 1e-6 + tolerance_ / step.length;
    if (s < -beyond || s > 1.0 + beyond) return false;
    constexpr double kBeside = 0.25;
    const glm::dvec3 beside = step.point(std::clamp(s, 0.0, 1.0));
    if (glm::distance(beside, place.point) > kBeside * step.length + tolerance_) return false;
    const std::optional<PatchSpots> at =
        place_near(patches(), step.spots(std::clamp(s, 0.0, 1.0)), InPlane{place.point, place.tangent});
    if (!at) return false;
    constexpr double kSame = 0x1p-26;
    constexpr double kRounding = 0x1p-44;
    const double sine = glm::length(meeting_at(patches(), place.at).along);
    return glm::distance(a_.at(at->a).point, place.point) <= kSame * step.length + kRounding / sine;
  }

  /// Notes where patches touch in parts, or may do: at a pole nothing tells where normals are parallel.
  void touch(const PatchSpots& middle) {
    std::optional<PatchSpots> at = touch_near(patches(), middle);
    const bool is_exact = at && enters(*at);
    if (!is_exact) at = middle;
    const PatchMeeting there = meeting_at(patches(), *at);
    constexpr double kNoGap = 0x1p-40;
    if (there.distance() > (is_exact ? kNoGap + 0.01 * tolerance_ * tolerance_ : tolerance_)) return;
    const glm::dvec3 point = there.a.point + 0.5 * there.b.offset;
    const auto is_here = [&](const SectionTouch& other) { return glm::distance(other.point, point) <= tolerance_; };
    const auto known = std::ranges::find_if(near_touches_, is_here);
    if (known == near_touches_.end()) {
      near_touches_.push_back({*at, point});
    } else if (is_exact) {
      *known = {*at, point};
    }
    if (!is_exact) return;
    for (const PatchSpot& in_a : twins_of(a_, at->a)) {
      for (const PatchSpot& in_b : twins_of(b_, at->b)) {
        const PatchSpots twin{in_a, in_b};
        const auto is_this = [&](const SectionTouch& other) {
          return other.at.a.piece == in_a.piece && other.at.b.piece == in_b.piece && is_here(other);
        };
        if (std::ranges::none_of(touches_, is_this)) touches_.push_back({twin, point});
      }
    }
  }

  /// A place where the patches touch, if no curve ends there.
  void add_lonely(const SectionTouch& touch, Sections& found) const {
    const auto is_here = [&](const SectionPlace& place) {
      return glm::distance(place.point, touch.point) <= 4.0 * tolerance_;
    };
    const bool is_on_curve = std::ranges::any_of(traces_, [&](const SectionTrace& trace) {
      return std::ranges::any_of(trace.places, is_here);
    });
    if (is_on_curve || touching_.is_near(touch.point, 4.0 * tolerance_)) return;
    const glm::dvec3 out = space_.leave(touch.point);
    const double near = 4.0 * space_.length(tolerance_);
    const auto is_known = [&](const SectionPoint& other) { return distance_of(other.point, out) <= near; };
    if (std::ranges::any_of(found.points, is_known)) return;
    found.points.push_back({a_.parameters(touch.at.a), b_.parameters(touch.at.b), out});
  }

  NearSpace space_;
  PatchPieces a_;
  PatchPieces b_;
  double tolerance_;
  TouchingCurves touching_;
  std::vector<SectionTouch> near_touches_;  ///< where the patches touch, or a pole is
  std::vector<SectionTouch> touches_;       ///< where normals are parallel, in every piece
  std::vector<SectionTrace> traces_;
  std::map<std::array<std::size_t, 2>, std::vector<StepOfTrace>> steps_;
};

}  // namespace

Sections sections(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance) {
  return SectionSearch(a, b, tolerance).found();
}

Sections sections(const NurbsPatch& patch, const Plane& plane, std::optional<double> tolerance) {
  return SectionSearch(patch, plane_about(patch.points(), plane), tolerance).found();
}

}  // namespace splinecore
