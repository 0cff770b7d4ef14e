#include "length_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "finite_weights.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Where u lies in an interval, as a part of it; halves, because its length may overflow.
double part_of(double u, const Interval& interval) {
  return (0.5 * u - 0.5 * interval.start) / (0.5 * interval.end - 0.5 * interval.start);
}

/// Adds up the lengths of spans. Each is a Bezier piece about an origin of its own, so that no digit is lost far away,
/// and sizes are brought near 1, so that no square leaves the numbers.
class Measure {
 public:
  Measure(const NurbsCurve& curve, const Interval& range, double tolerance, const VisitPart& visit)
      : curve_(curve), range_(range), tolerance_(tolerance), visit_(visit), speed_(curve.degree(), curve.rational()),
        near_(curve.degree() + 1), points_(near_.size()), stack_(2) {}

  Approximation<double> measured() {
    const KnotVector& knots = curve_.knot_vector();
    const int first = knots.span_of(range_.start, Side::right);
    const int last = std::max(first, knots.span_of(range_.end, Side::left));
    set_exponent(first, last);
    most_ = kMostPieces + kMostPiecesOfSpan * (last - first + 1);
    for (int span = first; span <= last; ++span) add_span(span);
    const double rounding = rounding_of(sum_.terms);
    const double allowed = std::max(tolerance_ * sum_.value, kNoise * rounding);
    if (sum_.error > allowed) {
      throw ToleranceNotReached(kWhat, std::ldexp(allowed, exponent_), std::ldexp(sum_.error, exponent_));
    }
    const double length = std::ldexp(sum_.value, exponent_);
    if (std::isinf(length)) throw InvalidShape("the length is too large for a number");
    return {length, std::ldexp(sum_.error + rounding, exponent_)};
  }

 private:
  static constexpr const char* kWhat = "the length cannot be found";
  static constexpr std::size_t kMostPieces = 20'000;
  static constexpr std::size_t kMostPiecesOfSpan = 64;
  /// The changes are no bound where a function has a corner between nodes.
  static constexpr double kCaution = 0.125;
  /// What rounding may leave of a change, in units of rounding_of().
  static constexpr double kNoise = 64.0;

  /// A piece to be measured.
  struct Piece {
    SpeedPiece speed;
    Interval part;  ///< of its span, which is [0, 1]
    int depth = 0;
    int cusps = 0;  ///< how often it was halved for a cusp
    double before = HUGE_VAL;  ///< the error of what it is a half of
  };

  double rounding_of(double terms) const {
    return 0x1p-53 * (curve_.degree() + 3) * terms + std::numeric_limits<double>::min();
  }

  /// Of the points that the spans depend on. Sizes whose products stay in range are left as they are.
  void set_exponent(int first, int last) {
    constexpr int kNear = 100;
    const KnotVector& knots = curve_.knot_vector();
    double largest = 0.0;
    for (int i = knots.spans()[first] - knots.degree(); i <= knots.spans()[last]; ++i) {
      const glm::dvec4& p = given(i);
      for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis]));
    }
    if (largest > 0.0) exponent_ = std::ilogb(largest);
    if (std::abs(exponent_) < kNear) exponent_ = 0;
  }

  const glm::dvec4& given(int i) const {
    const auto points = curve_.points();
    const auto count = static_cast<int>(points.size());
    return points[i < count ? i : i % count];
  }

  double scaled(double x) const { return exponent_ == 0 ? x : std::scalbn(x, -exponent_); }

  /// What weights, of which the largest of a curve is about 1, are multiplied by so that products of wild ones stay.
  static double lift_of(std::span<const glm::dvec4> homogeneous) {
    constexpr double kWild = 0x1p-150;
    const auto is_wild = [](const glm::dvec4& p) { return std::abs(p.w) < kWild && p.w != 0.0; };
    return std::ranges::any_of(homogeneous, is_wild) ? 0x1p440 : 1.0;
  }

  /// The homogeneous points of a span, about the first one of them that is no direction.
  void take_points(int span) {
    const KnotVector& knots = curve_.knot_vector();
    const int first = knots.spans()[span] - knots.degree();
    const glm::dvec4* const homogeneous = curve_.homogeneous_points().data() + first;
    int origin = 0;
    while (origin < knots.degree() && homogeneous[origin].w == 0.0) ++origin;
    const glm::dvec4& o = given(first + origin);
    const double lift = lift_of({homogeneous, near_.size()});
    for (int i = 0; i <= knots.degree(); ++i) {
      const double w = lift * homogeneous[i].w;
      near_[i].w = w;
      for (int axis = 0; axis < 3; ++axis) {
        near_[i][axis] = w == 0.0 ? lift * scaled(homogeneous[i][axis])
                                  : w * (scaled(given(first + i)[axis]) - scaled(o[axis]));
      }
    }
  }

  void add_span(int span) {
    const KnotVector& knots = curve_.knot_vector();
    const std::size_t order = near_.size();
    breathe(order * (12 * order + 256));
    take_points(span);
    write_bezier_piece(knots.bezier_matrix(span), near_.data(), points_.data());
    SpeedPiece& piece = stack_[0].speed;
    SpeedPiece& other = stack_[1].speed;
    speed_.write(points_, piece);
    const Interval whole = knots.span_interval(span);
    const double end = std::min(range_.end, whole.end);
    Interval& part = stack_.front().part = {};
    if (end < whole.end) {
      part.end = part_of(end, whole);
      piece.cut(part.end, other);
    }
    if (range_.start > whole.start) {
      part.start = part_of(range_.start, whole);
      piece.cut(part_of(range_.start, {whole.start, end}), other);
      std::swap(piece, other);
    }
    span_ = whole;
    stack_.front().depth = 0;
    stack_.front().cusps = 0;
    stack_.front().before = HUGE_VAL;
    add_pieces();
  }

  /// Adds the piece on the stack, from its start on, halved as often as it needs.
  void add_pieces() {
    for (std::size_t count = 1; count > 0;) {
      Piece& piece = stack_[count - 1];
      const PieceLength found = needs_halves(piece) ? PieceLength{0.0, HUGE_VAL, 0.0} : speed_.length(piece.speed);
      if (is_enough(piece, found)) {
        add(piece, found);
        --count;
        continue;
      }
      if (pieces_ == most_) {
        add(piece, given_up(piece, found));
        --count;
        continue;
      }
      ++pieces_;
      halve(count++, found.error);
    }
  }

  /// A piece that is halved no more: what the rules see of an uneven one tells nothing of its error.
  PieceLength given_up(const Piece& piece, const PieceLength& found) const {
    if (std::isfinite(found.error)) return found;
    PieceLength seen = speed_.length(piece.speed);
    require_numbers(seen);
    seen.error = seen.value;
    return seen;
  }

  static void require_numbers(const PieceLength& found) {
    if (std::isfinite(found.value) && std::isfinite(found.terms)) return;
    throw InvalidShape(std::string(kWhat) + ": points and weights differ too much in size for it");
  }

  void add(const Piece& piece, const PieceLength& found) {
    if (visit_) visit_({piece.speed, speed_, found.value, sum_.value, exponent_, span_, piece.part});
    // Of many pieces; what a sum loses goes into the next one (Kahan 1965).
    const double more = found.value - lost_;
    const double sum = sum_.value + more;
    lost_ = (sum - sum_.value) - more;
    sum_.value = sum;
    sum_.error += found.error;
    sum_.terms += found.terms;
  }

  /// A cusp's arms grow with the square of the parameter: after so many halvings what is left is as short as rounding.
  /// Beside a wild weight a part of the domain may be as short as the weight is small.
  bool needs_halves(Piece& piece) const {
    constexpr int kCusp = 28;
    constexpr int kWeight = 2200;
    if (curve_.rational()) {
      piece.speed.normalize();
      if (!piece.speed.is_even()) return piece.depth < kWeight;
    }
    return piece.cusps < kCusp && !piece.speed.is_regular() && ++piece.cusps > 0;
  }

  bool is_enough(const Piece& piece, const PieceLength& found) const {
    if (std::isinf(found.error)) return false;
    require_numbers(found);
    const double rounding = rounding_of(found.terms);
    if (found.error <= std::max(kCaution * tolerance_ * found.value, rounding)) return true;
    // Where halving no longer helps only rounding is left.
    return found.error > 0.25 * piece.before && found.error <= kNoise * rounding;
  }

  /// The piece becomes its second half, and its first lies upon it.
  void halve(std::size_t count, double error) {
    if (stack_.size() == count) stack_.emplace_back();
    Piece& first = stack_[count];
    Piece& second = stack_[count - 1];
    std::swap(first.speed, second.speed);
    second.depth += 1;
    second.before = error;
    first.part = {second.part.start, second.part.middle()};
    second.part.start = first.part.end;
    first.depth = second.depth;
    first.cusps = second.cusps;
    first.before = error;
    first.speed.cut(0.5, second.speed);
  }

  const NurbsCurve& curve_;
  Interval range_;
  double tolerance_;
  const VisitPart& visit_;
  Speed speed_;
  std::vector<glm::dvec4> near_;    ///< control points of a span
  std::vector<glm::dvec4> points_;  ///< and of its Bezier piece
  std::vector<Piece> stack_;
  Interval span_;                   ///< where the pieces lie
  int exponent_ = 0;
  PieceLength sum_;
  double lost_ = 0.0;
  std::size_t pieces_ = 0;
  std::size_t most_ = 0;
};

}  // namespace

Approximation<double> length_by_parts(const NurbsCurve& curve, const Interval& range, double tolerance,
                                      const VisitPart& visit) {
  require_finite_points(curve, range);
  if (range.start == range.end) return {0.0, 0.0};
  return Measure(curve, range, tolerance, visit).measured();
}

}  // namespace splinecore
