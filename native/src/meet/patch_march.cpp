#include "patch_march.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <span>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "touching_place.hpp"

namespace splinecore {

namespace {

/// The cosine of the angle by which a step may turn.
constexpr double kTurn = 0.9;
constexpr double kFirstStep = 0x1p-7;
constexpr double kLeastStep = 0x1p-40;
constexpr double kLeastSine = 0x1p-5;  ///< of the angle by which they cross plainly
/// Places so near are one.
constexpr double kSame = 0x1p-36;
constexpr std::size_t kMostPlaces = std::size_t{1} << 18;

/// One way along a curve.
class March {
 public:
  March(const TwoPatches& patches, const SectionPlace& seed, double way, const MarchLimits& limits)
      : patches_(patches), way_(way), contact_(limits.contact), touches_(limits.touches),
        tolerance_(limits.tolerance), is_known_(limits.is_known) {
    trace_.places.push_back(turned(seed));
  }

  SectionTrace done() {
    while (step()) {
      if (trace_.places.size() > kMostPlaces) {
        throw InvalidShape("the curve that the shapes have in common has more than " + std::to_string(kMostPlaces) +
                           " places within the tolerance: it is too small");
      }
    }
    trace_.is_lost[1] = is_lost_ && !parts(last().at);
    return std::move(trace_);
  }

 private:
  /// Where the curve came into a pair of pieces.
  struct Visit {
    std::size_t place;
    double traveled;
  };

  const SectionPlace& last() const { return trace_.places.back(); }

  SectionPlace turned(const SectionPlace& place) const { return way_ > 0.0 ? place : place.backwards(); }

  std::optional<SectionPlace> place(const PatchSpots& at) const {
    if (contact_.kind != PatchContact::Kind::crossing) {
      return touching_place(patches_, at, contact_, last().tangent, tolerance_);
    }
    auto found = section_place(patches_, at);
    if (found) found = turned(*found);
    return found;
  }

  /// The place of a face that a curve of touch comes to going straight on, if patches are within the tolerance there.
  std::optional<PatchSpots> straight_on(const PatchSpots& start, std::size_t i) const {
    if (contact_.kind != PatchContact::Kind::grazing) return {};
    if (i < 2) return foot_near(patches_, start);
    const auto foot = foot_near({patches_.b, patches_.a}, {start.b, start.a});
    return foot ? std::optional(PatchSpots{foot->b, foot->a}) : std::nullopt;
  }

  PatchSpots ahead(double length) const {
    PatchSpots at = last().at;
    for (std::size_t i = 0; i < 4; ++i) at[i] += length * last().slopes[i];
    return at;
  }

  /// By how much a step leaves the patches.
  double error(const SectionStep& step) const {
    double most = 0.0;
    for (const double s : {0.15, 0.33, 0.5, 0.67, 0.85}) {
      const glm::dvec3 point = step.point(s);
      const PatchSpots at = step.spots(s);
      most = std::max({most, glm::length(patches_.a.at(at.a, point).offset),
                       glm::length(patches_.b.at(at.b, point).offset)});
    }
    return most;
  }

  /// Whether between its ends a step is beyond a side of its pieces by more than the tolerance.
  bool bulges_out(const SectionStep& step) const {
    for (const double s : {0.125, 0.25, 0.5, 0.75, 0.875}) {
      const PatchSpots at = step.spots(s);
      for (std::size_t i = 0; i < 4; ++i) {
        const double out = std::max(-at[i], at[i] - 1.0);
        if (out <= 0.0) continue;
        const Slopes<2> there = i < 2 ? patches_.a.at(at.a) : patches_.b.at(at.b);
        if (out * glm::length(there.first[i % 2]) > tolerance_) return true;
      }
    }
    return false;
  }

  /// @returns false
  bool lose() {
    is_lost_ = true;
    return false;
  }

  /// Whether a curve along which patches touch has come to where they part by more than the tolerance, or where they cross,
  /// as beyond a crease.
  bool parts(const PatchSpots& at) const {
    constexpr double kMost = 0.5;
    if (contact_.kind == PatchContact::Kind::crossing) return false;
    const PatchMeeting there = meeting_at(patches_, at);
    return there.distance() > kMost * tolerance_ || glm::length(there.along) >= kLeastSine;
  }

  /// @returns whether the curve goes on
  bool step() {
    breathe(2048);
    if (length_ < kLeastStep || is_lost_in_rounding()) return lose();
    if (const auto end = touching_end()) return finish(*end);
    keep_before_touches();
    const InPlane plane{last().point + length_ * last().tangent, last().tangent};
    std::optional<PatchSpots> at = contact_near(patches_, ahead(length_), contact_, last().tangent, plane);
    if (!at) return reach_side();
    if (contact_.kind == PatchContact::Kind::border) settle_on_sides(patches_, *at, tolerance_);
    if (leaves_by_pole(*at)) return leave(*at);
    std::optional<SectionPlace> next = place(*at);
    if (!next || glm::dot(next->tangent, last().tangent) < kTurn) return reach_side();
    const double far = glm::distance(next->point, last().point);
    if (far > 2.0 * length_ || far < 0.5 * length_) return reach_side();
    return enters(next->at) ? take(*next) : leave(next->at);
  }

  /// No place is found ahead: the step ends on the side that it leads to, right beyond which the piece may be folded,
  /// as that of a short span beside a long one is, or it is shorter.
  bool reach_side() {
    PatchSpots out = ahead(length_);
    bool is_out = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const double inside = std::clamp(out[i], 0.0, 1.0);
      if (out[i] == inside) continue;
      const bool is_side = !is_on_face(i, out) && !piece_of(i).is_pole(piece_at(i), side(i, is_at_end(out[i])));
      if (!is_side) out[i] = inside;
      is_out = is_out || is_side;
    }
    return is_out ? leave(out) : shorter(0.5);
  }

  /// Whether the step is so short that rounding, where the patches nearly touch, sends its end anywhere.
  bool is_lost_in_rounding() const {
    constexpr double kShort = 0x1p-20;
    constexpr double kRoundingOfTouches = 0x1p-26;  // places where normals are parallel have half the digits
    if (length_ > kShort) return false;
    if (contact_.kind != PatchContact::Kind::crossing) return length_ < kRoundingOfTouches;
    return length_ * glm::length(meeting_at(patches_, last().at).along) < kRoundingOfStep;
  }

  bool shorter(double share) {
    length_ *= share;
    return length_ >= kLeastStep || turn_corner() || lose();
  }

  /// Beside a side along which a piece is nearly folded the curve may turn within rounding: it goes on from a place
  /// beyond, by the parameter that goes the fastest, to which it is a part of the tolerance.
  bool turn_corner() {
    constexpr int kMostCorners = 4;
    if (contact_.kind != PatchContact::Kind::crossing || corners_ == kMostCorners) return false;
    if (!crosses_plainly(last())) return false;
    const std::size_t i = last().fastest();
    const bool is_rising = last().slopes[i] > 0.0;
    const double room = is_rising ? 1.0 - last().at[i] : last().at[i];
    for (double share = 1.0; share * room > kOnSide; share *= 0.5) {
      const double value = share == 1.0 ? (is_rising ? 1.0 : 0.0) : last().at[i] + (is_rising ? share : -share) * room;
      std::optional<PatchSpots> at = place_near(patches_, last().at, OnFace{i, value});
      if (!at || !enters(*at)) continue;
      const std::optional<SectionPlace> next = place(*at);
      if (!next || !is_beyond_corner(*next, i)) continue;
      ++corners_;
      length_ = std::max(glm::distance(next->point, last().point), 2.0 * kLeastStep);
      trace_.places.push_back(*next);
      if (share == 1.0) return hop(i);
      return true;
    }
    return false;
  }

  bool is_beyond_corner(const SectionPlace& next, std::size_t i) const {
    constexpr double kOfTolerance = 0.25;
    if (!(next.slopes[i] * last().slopes[i] > 0.0) || !crosses_plainly(next)) return false;
    const SectionStep step(last(), next);
    return step.length <= kOfTolerance * tolerance_ && error(step) <= tolerance_ && !bulges_out(step);
  }

  bool crosses_plainly(const SectionPlace& place) const {
    return glm::length(meeting_at(patches_, place.at).along) >= kLeastSine;
  }

  bool take(const SectionPlace& next) {
    const SectionStep step(last(), next);
    const double off = error(step);
    const double share = std::clamp(0.9 * std::sqrt(std::sqrt(0.5 * tolerance_ / std::max(off, 1e-300))), 0.2, 2.0);
    if (off > tolerance_) return shorter(std::min(share, 0.7));
    if (bulges_out(step)) return shorter(0.5);
    if (closes(step)) return false;
    traveled_ += step.length;
    trace_.places.push_back(next);
    length_ *= share;
    hops_ = 0;
    if (step.length > tolerance_) corners_ = 0;
    return true;
  }

  /// Where a step passes the place that the curve was begun at, or one at which it came into a piece before, it ends:
  /// of a loop that lies along a side of a piece no step need come into the piece that it was begun in.
  bool closes(const SectionStep& step) {
    if (!(traveled_ > kSame)) return false;
    if (const auto before = passed_before(step)) {
      end_at_itself(*before);
      return true;
    }
    const SectionPlace& begin = trace_.places.front();
    if (begin.has_pieces_of(step.to) || !step.passes(begin, kSame, kTurn)) return false;
    // It was begun on the side of a piece that the curve does not run in.
    const bool is_at_start = glm::distance(step.from.point, begin.point) <= kSame;
    if (!is_at_start && glm::distance(step.to.point, begin.point) > kSame) return false;
    if (!is_at_start) trace_.places.push_back(step.to);
    return trace_.is_closed = true;
  }

  /// The place that a step passes, of those that the curve was begun at or came into the same pieces at.
  std::optional<std::size_t> passed_before(const SectionStep& step) const {
    const auto is_passed = [&](std::size_t i) {
      constexpr double kBeside = 0.05;
      const SectionPlace& place = trace_.places[i];
      if (i + 1 >= trace_.places.size() || !place.has_pieces_of(step.to) || !step.passes(place, kSame, kTurn)) return false;
      const double along = glm::dot(place.point - step.from.point, step.from.tangent);
      const glm::dvec3 beside = step.point(std::clamp(along / step.length, 0.0, 1.0));
      return glm::distance(beside, place.point) <= kBeside * step.length + kSame &&
             error(SectionStep(step.from, place)) <= tolerance_;
    };
    if (is_passed(0)) return 0;
    const auto visits = visits_.find({step.to.at.a.piece, step.to.at.b.piece});
    if (visits == visits_.end()) return {};
    const auto found = std::ranges::find_if(visits->second, [&](const Visit& visit) {
      return traveled_ - visit.traveled > std::max(kSame, step.length) && is_passed(visit.place);
    });
    return found == visits->second.end() ? std::nullopt : std::optional(found->place);
  }

  /// The next place is beyond a side of a piece: to the first side, and to the piece beyond.
  bool leave(const PatchSpots& out) {
    if (const auto side = side_run_out_of(out)) return cross_at_once(*side, out);
    std::optional<SectionPlace> first;
    std::size_t through = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
      if (out[i] >= -kOnSide && out[i] <= 1.0 + kOnSide) continue;
      // Where it turns inward first it comes back to the side later than it leaves by another, or in a shorter step.
      if (is_on_face(i, out)) continue;
      const std::optional<SectionPlace> on = on_face(i, out);
      if (!on) continue;
      const double far = glm::dot(on->point - last().point, last().tangent);
      if (far < -kOnSide || far >= least) continue;
      first = on;
      through = i;
      least = far;
    }
    if (!first) return shorter(0.5);
    if (least > kOnSide) {
      if (glm::dot(first->tangent, last().tangent) < kTurn) return shorter(0.5);
      const SectionStep step(last(), *first);
      if (error(step) > tolerance_ || bulges_out(step)) return shorter(0.7);
      if (closes(step)) return false;
      traveled_ += step.length;
      trace_.places.push_back(*first);
      hops_ = 0;
      // It was beyond the side by less than the tolerance, and comes back there.
      if (!last().runs_out(through, is_at_end(out[through]))) return true;
    } else {
      trace_.places.back().at[through] = first->at[through];
    }
    return hop(through);
  }

  static bool is_at_end(double out) { return out > 1.0; }

  /// Of the sides that the last place is on, and that the next one is beyond, the one that the curve runs out of the most: beyond
  /// others it may be but as pieces that do not belong together go on, one beyond its side and one that is not.
  std::optional<std::size_t> side_run_out_of(const PatchSpots& out) const {
    std::optional<std::size_t> found;
    double most = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (out[i] >= -kOnSide && out[i] <= 1.0 + kOnSide) continue;
      if (!is_on_face(i, out) || !last().runs_out(i, is_at_end(out[i]))) continue;
      const double speed = is_at_end(out[i]) ? last().slopes[i] : -last().slopes[i];
      if (found && speed <= most) continue;
      found = i;
      most = speed;
    }
    return found;
  }

  /// Beyond a pole a surface is turned over.
  bool leaves_by_pole(const PatchSpots& out) const {
    for (std::size_t i = 0; i < 4; ++i) {
      if (out[i] >= -kOnSide && out[i] <= 1.0 + kOnSide) continue;
      if (piece_of(i).is_pole(piece_at(i), side(i, is_at_end(out[i])))) return true;
    }
    return false;
  }

  /// Whether the last place is on the side that the next one is beyond, which a curve may leave at any angle.
  bool is_on_face(std::size_t i, const PatchSpots& out) const {
    constexpr double kNear = 0x1p-36;
    const double value = is_at_end(out[i]) ? 1.0 : 0.0;
    return std::abs(last().at[i] - value) <= kNear && !piece_of(i).is_pole(piece_at(i), side(i, value == 1.0));
  }

  bool cross_at_once(std::size_t i, const PatchSpots& out) {
    trace_.places.back().at[i] = is_at_end(out[i]) ? 1.0 : 0.0;
    return hop(i);
  }

  std::optional<SectionPlace> on_face(std::size_t i, const PatchSpots& out) const {
    const double value = is_at_end(out[i]) ? 1.0 : 0.0;
    if (piece_of(i).is_pole(piece_at(i), side(i, value == 1.0))) return on_pole(i, value);
    const double before = last().at[i];
    const double share = std::abs(out[i] - before) > 0.0 ? (value - before) / (out[i] - before) : 0.0;
    PatchSpots start = last().at;
    for (std::size_t k = 0; k < 4; ++k) start[k] += share * (out[k] - start[k]);
    std::optional<PatchSpots> at = contact_near(patches_, start, contact_, last().tangent, OnFace{i, value});
    if (!at || !enters(*at)) {
      start[i] = value;
      at = straight_on(start, i);
      if (!at || !enters(*at)) return {};
    }
    (*at)[i] = value;
    return place(*at);
  }

  /// The curve ends at the point that a side of a piece is; there it goes on as on a circle.
  std::optional<SectionPlace> on_pole(std::size_t i, double value) const {
    PatchSpots at = last().at;
    const double slope = last().slopes[i];
    if (!(std::abs(slope) > 0.0)) return {};
    const double far = (value - at[i]) / slope;
    for (std::size_t k = 0; k < 4; ++k) at[k] += far * last().slopes[k];
    at[i] = value;
    const bool is_a = i < 2;
    const glm::dvec3 pole = is_a ? patches_.a.at(at.a).point : patches_.b.at(at.b).point;
    PatchSpot& other = is_a ? at.b : at.a;
    const PatchPieces& pieces = is_a ? patches_.b : patches_.a;
    for (int round = 0; round < 8; ++round) {
      const Slopes<2> s = pieces.at(other, pole);
      const glm::dvec3 normal = glm::cross(s.first[0], s.first[1]);
      const double square = glm::dot(normal, normal);
      if (!(square > 0.0)) return {};
      other.at[0] -= glm::dot(glm::cross(s.offset, s.first[1]), normal) / square;
      other.at[1] -= glm::dot(glm::cross(s.first[0], s.offset), normal) / square;
    }
    if (glm::length(pieces.at(other, pole).offset) > tolerance_) return {};
    return mirrored(at, pole);
  }

  /// A place at which no tangent is known: as on a circle the one before it has.
  std::optional<SectionPlace> mirrored(const PatchSpots& at, const glm::dvec3& point) const {
    const glm::dvec3 chord = point - last().point;
    const double length = glm::length(chord);
    if (!(length > 0.0)) return {};
    const glm::dvec3 way = chord / length;
    SectionPlace end{at, point, 2.0 * glm::dot(way, last().tangent) * way - last().tangent, {}};
    for (std::size_t k = 0; k < 4; ++k) end.slopes[k] = 2.0 * (at[k] - last().at[k]) / length - last().slopes[k];
    return end;
  }

  const PatchPieces& piece_of(std::size_t i) const { return i < 2 ? patches_.a : patches_.b; }
  std::size_t piece_at(std::size_t i) const { return i < 2 ? last().at.a.piece : last().at.b.piece; }
  static PieceSide side(std::size_t i, bool is_end) { return {i % 2 == 0 ? Axis::u : Axis::v, is_end}; }

  bool hop(std::size_t i) {
    constexpr int kMostHops = 8;
    PatchSpots at = last().at;
    const bool is_end = at[i] == 1.0;
    const auto next = piece_of(i).beyond(piece_at(i), side(i, is_end));
    if (!next) return false;
    if (++hops_ > kMostHops) return lose();
    (i < 2 ? at.a : at.b).piece = *next;
    at[i] = is_end ? 0.0 : 1.0;
    const std::optional<SectionPlace> there = place(at);
    if (!there) return parts(at) ? false : lose();
    // Where the surfaces are folded the curve may come back through the same side: there it ends.
    if (!there->runs_out(i, is_end)) return contact_.kind == PatchContact::Kind::crossing ? false : lose();
    if (is_known_ && is_known_(*there)) return false;
    if (const auto before = visit_before(*there)) return end_at_itself(*before);
    visits_[{at.a.piece, at.b.piece}].push_back({trace_.places.size(), traveled_});
    trace_.places.push_back(*there);
    return true;
  }

  /// When the curve came into a piece here before.
  std::optional<std::size_t> visit_before(const SectionPlace& place) const {
    const auto visits = visits_.find({place.at.a.piece, place.at.b.piece});
    if (visits == visits_.end()) return {};
    const auto found = std::ranges::find_if(visits->second, [&](const Visit& visit) {
      const SectionPlace& other = trace_.places[visit.place];
      return glm::distance(other.point, place.point) <= kSame && glm::dot(other.tangent, place.tangent) > kTurn;
    });
    return found == visits->second.end() ? std::nullopt : std::optional(found->place);
  }

  /// The curve came to a loop, which it went round: what leads to it stays, or, if it was begun on it, the loop.
  bool end_at_itself(std::size_t first) {
    std::vector<SectionPlace>& places = trace_.places;
    places.push_back(SectionPlace(places[first]));
    const auto is_on_loop = [&](const SectionPlace& place) {
      for (std::size_t i = first; i + 1 < places.size(); ++i) {
        if (SectionStep(places[i], places[i + 1]).is_near(place.point, tolerance_)) return true;
      }
      return false;
    };
    std::size_t joint = first;
    while (joint > 0 && is_on_loop(places[joint - 1])) --joint;
    if (joint > 0) {
      places.resize(joint + 1);
      return false;
    }
    places.erase(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(first));
    trace_.is_closed = true;
    return false;
  }

  /// The place ahead where the patches touch that the next step comes near, if the curve goes there.
  std::optional<SectionPlace> touching_end() const {
    for (const SectionTouch& touch : touches_) {
      const double ahead = glm::dot(touch.point - last().point, last().tangent);
      if (!(ahead > 0.0) || ahead > 3.0 * length_ || glm::distance(touch.point, last().point) > 1.2 * ahead) continue;
      if (touch.at.a.piece != last().at.a.piece || touch.at.b.piece != last().at.b.piece) continue;
      const auto end = mirrored(touch.at, touch.point);
      if (end && error(SectionStep(last(), *end)) <= tolerance_) return end;
    }
    return {};
  }

  /// No step is longer than half the way to a place where the patches touch.
  void keep_before_touches() {
    for (const SectionTouch& touch : touches_) {
      const double far = glm::distance(touch.point, last().point);
      if (glm::dot(touch.point - last().point, last().tangent) > 0.5 * far) length_ = std::min(length_, 0.5 * far);
    }
  }

  bool finish(const SectionPlace& end) {
    trace_.places.push_back(end);
    return false;
  }

  TwoPatches patches_;
  double way_;
  PatchContact contact_;
  std::span<const SectionTouch> touches_;
  double tolerance_;
  const std::function<bool(const SectionPlace&)>& is_known_;
  std::map<std::array<std::size_t, 2>, std::vector<Visit>> visits_;  ///< of each pair of pieces
  double length_ = kFirstStep;
  double traveled_ = 0.0;
  int hops_ = 0;
  int corners_ = 0;
  bool is_lost_ = false;
  SectionTrace trace_{{}, false};
};

}  // namespace

SectionTrace traced(const TwoPatches& patches, const SectionPlace& seed, const MarchLimits& limits) {
  SectionTrace forward = March(patches, seed, 1.0, limits).done();
  if (forward.is_closed) return forward;
  SectionTrace back = March(patches, seed, -1.0, limits).done();
  std::vector<SectionPlace> places;
  for (auto place = back.places.rbegin(); place != back.places.rend(); ++place) places.push_back(place->backwards());
  if (back.is_closed) return {std::move(places), true};
  places.insert(places.end(), forward.places.begin() + 1, forward.places.end());
  return {std::move(places), false, {back.is_lost[1], forward.is_lost[1]}};
}

}  // namespace splinecore
