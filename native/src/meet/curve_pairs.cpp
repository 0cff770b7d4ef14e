#include "curve_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

#include "crowded_parts.hpp"
#include "curve_bundles.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// So narrow parts of a piece, by its parameter, are not halved.
constexpr double kNarrow = 0x1p-50;
/// Radians by which tangents of parts may differ that are looked at as one line.
constexpr double kGentle = 0.25;
/// Parts of this part of the tolerance are points.
constexpr double kSmall = 0.5;
/// So much of the rounding of a part is nothing but rounding, and where that is more than kLost there are no places.
constexpr double kOfRounding = 4.0;
constexpr double kLost = 0x1p-20;
/// Parts so many times as long as points that cannot be halved are looked at as points.
constexpr double kJump = 256.0;
constexpr std::size_t kMostPairs = std::size_t{1} << 22;
/// Of curves of many pieces so many a piece.
constexpr std::size_t kMostOfPiece = 512;
constexpr std::size_t kMostStretches = std::size_t{1} << 19;

std::size_t most_pairs_of(std::size_t pieces) { return std::max(kMostPairs, kMostOfPiece * pieces); }

class PairSearch {
 public:
  PairSearch(const CurvePieces& a, const CurvePieces& b, double tolerance)
      : curves_{a, b}, tolerance_(tolerance), most_pairs_(most_pairs_of(a.size() + (&a == &b ? 0 : b.size()))),
        is_one_(&a == &b), parts_a_(a) {
    if (is_one_) {
      halve_crowded(parts_a_, tolerance_);
    } else {
      parts_b_.emplace(b);
      halve_crowded(parts_a_, *parts_b_, tolerance_);
    }
  }

  PairFindings found() {
    const auto work = [&](std::size_t i, std::size_t j) { pieces(i, j); };
    BundlePairs(parts_a_.bundles(), parts_b().bundles(), tolerance_, work).visit();
    return std::move(found_);
  }

 private:
  const BundledParts& parts_b() const { return parts_b_ ? *parts_b_ : parts_a_; }

  void pieces(std::size_t i, std::size_t j) {
    const CurvePart& a = parts_a_.parts()[i];
    const CurvePart& b = parts_b().parts()[j];
    if (is_one_ && i == j) return own(a);
    is_one_ ? own_pair(a, b) : pair(a, b);
  }

  /// Counts a pair of parts. @returns whether they are near enough to meet
  bool are_near(const CurvePart& a, const CurvePart& b) {
    breathe(16 * (a.net.rows + b.net.rows));
    if (++pairs_ > most_pairs_) refuse(most_pairs_);
    return !are_apart(a, b, within(a, b));
  }

  /// The tolerance, and what hulls that far out are rounded by.
  double within(const CurvePart& a, const CurvePart& b) const { return tolerance_ + a.rounding + b.rounding; }

  [[noreturn]] static void refuse(std::size_t count) {
    throw InvalidShape("more than " + std::to_string(count) +
                       " pairs of parts are within the tolerance: "
                       "they are one along too much of them, or it is too small");
  }

  /// Whether a part is farther out than it is looked for, or has no points but where weights are zero.
  static bool is_lost(const CurvePart& part) {
    if (!part.is_boxed) return is_narrow(part) || is_far_out(part);
    return is_far_out(part) || (part.rounding > kLost && part.size <= kOfRounding * part.rounding);
  }
  static bool is_narrow(const CurvePart& part) { return part.range.length() <= kNarrow; }

  void pair(const CurvePart& a, const CurvePart& b) {
    if (is_lost(a) || is_lost(b) || !are_near(a, b)) return;
    if (do_tangents_differ(a, b, tolerance_) && cross(a, b)) return;
    const bool are_boxed = a.is_boxed && b.is_boxed;
    if (are_boxed && std::max(a.spread, b.spread) <= kGentle && are_together(a, b)) return;
    const double small = kSmall * within(a, b);
    if ((is_small(a, small) && is_jump(b, small)) || (is_jump(a, small) && is_small(b, small))) refuse_jump();
    if (is_point(a, small) && is_point(b, small)) return add(a, a.range, b, b.range, 0, false);
    if (halves_first(a, b, small)) {
      const auto [first, second] = a.halves();
      pair(first, b);
      pair(second, b);
    } else {
      const auto [first, second] = b.halves();
      pair(a, first);
      pair(a, second);
    }
  }

  static bool is_small(const CurvePart& part, double small) { return part.is_boxed && part.size <= small; }

  /// Whether a part is not halved any more.
  static bool is_point(const CurvePart& part, double small) { return is_narrow(part) || is_small(part, small); }

  /// Whether a part is no point but for the rounding of its parameter.
  static bool is_jump(const CurvePart& part, double small) {
    return is_narrow(part) && part.is_boxed && part.size > kJump * small;
  }

  [[noreturn]] static void refuse_jump() {
    throw InvalidShape("a curve goes farther than the tolerance within the rounding of its parameter where the other "
                       "one is near: its weights are too unlike");
  }

  static bool halves_first(const CurvePart& a, const CurvePart& b, double small) {
    if (is_point(b, small)) return true;
    if (is_point(a, small)) return false;
    if (a.is_boxed != b.is_boxed) return !a.is_boxed;
    return a.is_boxed ? a.size >= b.size : a.range.length() >= b.range.length();
  }

  /// A part with itself.
  void own(const CurvePart& part) {
    if (is_monotone(part) || is_narrow(part) || is_lost(part)) return;
    if (part.is_boxed && part.size <= kSmall * within(part, part)) return;
    const auto [first, second] = part.halves();
    own(first);
    own(second);
    own_pair(first, second);
  }

  /// Parts of one curve, the first before the second.
  void own_pair(const CurvePart& a, const CurvePart& b) {
    const bool b_follows = follows(a, b);
    const bool a_follows = follows(b, a);
    if (!b_follows && !a_follows) return pair(a, b);
    if (is_lost(a) || is_lost(b) || !are_near(a, b)) return;
    if (b_follows != a_follows && are_monotone(a, b)) return;
    const bool are_boxed = a.is_boxed && b.is_boxed;
    const bool is_small = are_boxed && std::max(a.size, b.size) <= kSmall * within(a, b);
    if (is_small || is_narrow(a) || is_narrow(b)) return add(a, a.range, b, b.range, 0, true);
    const auto of_a = a.halves();
    const auto of_b = b.halves();
    for (const CurvePart* in_a : {&of_a.first, &of_a.second}) {
      for (const CurvePart* in_b : {&of_b.first, &of_b.second}) own_pair(*in_a, *in_b);
    }
  }

  bool follows(const CurvePart& a, const CurvePart& b) const {
    if (a.piece == b.piece) return a.range.end == b.range.start;
    return a.range.end == 1.0 && b.range.start == 0.0 && curves_.a.after(a.piece) == b.piece;
  }

  /// Finds where parts cross whose tangents differ. @returns false if neither a place nor a gap is found
  bool cross(const CurvePart& a, const CurvePart& b) {
    const SpotPair middle{{a.piece, a.range.middle()}, {b.piece, b.range.middle()}};
    const std::optional<SpotPair> near = nearest_pair(curves_, middle, a.range, b.range);
    if (!near) return false;
    const glm::dvec3 gap = curves_.b.at(near->b, curves_.a.at(near->a).point).offset;
    if (!(curves_.distance(*near) <= tolerance_)) return are_apart_along(a, b, glm::normalize(gap), within(a, b));
    found_.crossings.push_back(lowest(*near));
    return true;
  }

  /// A place that curves have in common where it is nearest, beyond the ends of parts, too.
  SpotPair lowest(const SpotPair& near) const {
    const SpotPair at = settled(curves_, near);
    const double far = 2.0 * tolerance_;
    const bool is_one = curves_.a.are_one(at.a, near.a, far) && curves_.b.are_one(at.b, near.b, far);
    return is_one || are_joined(curves_, curves_.places(near), curves_.places(at), tolerance_) ? at : near;
  }

  /// Whether nearly straight parts, where they lie side by side, are within the tolerance; they are one then if so many
  /// places are (Bézout: curves of degrees p and q that meet more than p q times are one).
  bool are_together(const CurvePart& a, const CurvePart& b) {
    // What they have side by side begins and ends at ends of theirs.
    const auto are_off = [&](const CurvePart& one, const CurvePart& other) {
      const double far = within(one, other);
      return is_off(one.points.front(), other, far) && is_off(one.points.back(), other, far);
    };
    if (are_off(a, b) && are_off(b, a)) return false;
    const auto ends_in = [](const CurvePieces& of, const CurvePart& part, const CurvePart& other) {
      Interval in{foot_of(of, part.piece, part.range, other.points.front()),
                  foot_of(of, part.piece, part.range, other.points.back())};
      if (in.start > in.end) std::swap(in.start, in.end);
      return in;
    };
    const auto is_near = [&](double t) {
      const CurveSpot on_a{a.piece, t};
      const double foot = foot_of(curves_.b, b.piece, b.range, curves_.a.at(on_a).point);
      return curves_.distance({on_a, {b.piece, foot}}) <= tolerance_;
    };
    const Interval in_a = ends_in(curves_.a, a, b);
    if (in_a.length() > 0.0 && !is_near(in_a.start)) return false;
    const Interval in_b = ends_in(curves_.b, b, a);
    const auto is_near_of_b = [&](double t) {
      const CurveSpot on_b{b.piece, t};
      const double foot = foot_of(curves_.a, a.piece, a.range, curves_.b.at(on_b).point);
      return curves_.distance({{a.piece, foot}, on_b}) <= tolerance_;
    };
    if (in_b.length() > 0.0 && !(is_near_of_b(in_b.start) && is_near_of_b(in_b.end))) return false;
    if (in_a.length() == 0.0 && in_b.length() == 0.0) return are_end_to_end(a, in_a.start, b, in_b.start);
    if (in_a.length() == 0.0 || in_b.length() == 0.0) return false;
    constexpr std::size_t kMost = 65;
    const std::size_t count = std::min((a.net.rows - 1) * (b.net.rows - 1) + 2, kMost);
    for (std::size_t i = 1; i < count; ++i) {
      if (!is_near(in_a.start + in_a.length() * static_cast<double>(i) / static_cast<double>(count - 1))) return false;
    }
    add(a, in_a, b, in_b, glm::dot(a.along, b.along) < 0.0 ? -1 : 1, false);
    return true;
  }

  /// Nearly straight parts one behind the other are nearest at their ends.
  bool are_end_to_end(const CurvePart& a, double end_a, const CurvePart& b, double end_b) {
    const SpotPair ends{{a.piece, end_a}, {b.piece, end_b}};
    const std::optional<SpotPair> near = nearest_pair(curves_, ends, a.range, b.range);
    if (!near || near->a.t != end_a || near->b.t != end_b) return false;
    if (curves_.distance(ends) <= tolerance_) add(a, {end_a, end_a}, b, {end_b, end_b}, 0, false);
    return true;
  }

  void add(const CurvePart& a, const Interval& in_a, const CurvePart& b, const Interval& in_b, int way,
           bool is_trivial) {
    if (found_.stretches.size() == kMostStretches) refuse(kMostStretches);
    found_.stretches.push_back({a.piece, in_a, b.piece, in_b, way, is_trivial});
  }

  TwoCurves curves_;
  double tolerance_;
  std::size_t most_pairs_;
  bool is_one_;
  BundledParts parts_a_;
  std::optional<BundledParts> parts_b_;
  std::size_t pairs_ = 0;
  PairFindings found_;
};

}  // namespace

PairFindings find_pairs(const CurvePieces& a, const CurvePieces& b, double tolerance) {
  return PairSearch(a, b, tolerance).found();
}

PairFindings find_own_pairs(const CurvePieces& curve, double tolerance) {
  return PairSearch(curve, curve, tolerance).found();
}

}  // namespace splinecore
