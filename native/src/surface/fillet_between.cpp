#include "fillet_between.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ball_path.hpp"
#include "base/length.hpp"
#include "fit/row_spline.hpp"
#include "fitted_patch.hpp"
#include "greville.hpp"
#include "patch/lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

std::vector<double> inner_knots(const KnotVector& knots) {
  std::vector<double> found;
  const Interval domain = knots.domain();
  for (const double knot : knots.knots()) {
    const bool is_inside = knot > domain.start && knot < domain.end;
    const bool is_seam = knots.periodic() && knot == domain.start;
    if ((is_inside || is_seam) && (found.empty() || found.back() != knot)) found.push_back(knot);
  }
  return found;
}

std::vector<double> softened(const KnotVector& knots) {
  std::vector<double> found = inner_knots(knots);
  std::erase_if(found, [&](double knot) { return multiplicity(knots, knot) >= knots.degree(); });
  return found;
}

std::string share_text(double share) { return text_of(std::round(1e4 * share) / 1e4); }

namespace {

/// Knots that one has and the other has not, as often as they lack, within the domain.
std::vector<double> lacking(const KnotVector& own, const KnotVector& wanted) {
  std::vector<double> found;
  for (const double knot : inner_knots(wanted)) {
    const int more = multiplicity(wanted, knot) - multiplicity(own, knot);
    for (int k = 0; k < more; ++k) found.push_back(knot);
  }
  return found;
}

/// With knots that are those wanted but for rounding as these are.
NurbsPatch on_same_digits(const NurbsPatch& patch, const KnotVector& wanted) {
  constexpr double kSame = 0x1p-44;
  const KnotVector& own = patch.knot_vector(Axis::u);
  std::vector<double> knots(own.knots().begin(), own.knots().end());
  for (double& knot : knots) {
    const auto next = std::ranges::lower_bound(wanted.knots(), knot - kSame);
    if (next != wanted.knots().end() && *next <= knot + kSame) knot = *next;
  }
  if (std::ranges::equal(knots, own.knots())) return patch;
  return NurbsPatch::make(KnotVector::make(own.degree(), std::move(knots), own.periodic()), patch.knot_vector(Axis::v),
                          {patch.points().begin(), patch.points().end()});
}

}  // namespace

NurbsPatch on_knots(const NurbsPatch& given, const KnotVector& wanted) {
  const NurbsPatch patch = on_same_digits(given, wanted);
  const int more = wanted.degree() - patch.knot_vector(Axis::u).degree();
  const NurbsPatch raised = more > 0 ? elevated(patch, Axis::u, more) : patch;
  const std::vector<double> knots = lacking(raised.knot_vector(Axis::u), wanted);
  const NurbsPatch refined = knots.empty() ? raised : refine(raised, Axis::u, knots);
  if (!wanted.periodic()) return refined;
  return along(refined, Axis::u, [](const NurbsCurve& line) { return with_whole_seam(line); });
}

namespace {

std::vector<glm::dvec4> side_points(const NurbsPatch& patch) {
  const auto count_v = static_cast<std::size_t>(patch.knot_vector(Axis::v).count());
  std::vector<glm::dvec4> side;
  for (std::size_t i = 0; i < patch.points().size(); i += count_v) side.push_back(patch.points()[i]);
  return side;
}

/// The weights of a side at samples.
std::vector<double> weights_at(const std::vector<glm::dvec4>& side, const Samples& samples) {
  std::vector<double> found;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    double sum = 0.0;
    auto next = static_cast<std::size_t>(samples.first(k));
    for (const double weight : samples.weights(k)) sum += weight * side[next++ % side.size()].w;
    found.push_back(sum);
  }
  return found;
}

/// The middle of the arc between both contacts of three homogeneous points, of which the outer ones have weight 1.
glm::dvec4 tip_of(const Contact& contact) {
  const glm::dvec3 middle = (contact.first - contact.circle_center) + (contact.second - contact.circle_center);
  const double half = 0.5 * length_of(middle) / contact.circle_radius;  // cosine of half the angle
  const glm::dvec3 tip = contact.circle_center + middle / (2.0 * half * half);
  return {half * tip, half};
}

class FilletFit {
 public:
  FilletFit(const NurbsPatch& first, const NurbsPatch& second, const RollingBall& ball) : first_(first), second_(second), ball_(ball) {
    agree();
  }

  /// On few knots, however far off.
  FilletBetween rough() {
    refine_both({});
    return {first_, between(), second_, 0.0};
  }

  FilletBetween within(double tolerance) {
    constexpr std::size_t kMost = 1 << 14;
    constexpr double kSeen = 0.8;
    for (;;) {
      breathe(1);
      const NurbsPatch made = between();
      double largest = 0.0;
      const std::vector<double> missed = missed_spans(made, kSeen * tolerance, largest);
      if (missed.empty()) return {first_, made, second_, largest / kSeen};
      if (side_points(first_).size() + missed.size() > kMost) {
        throw ToleranceNotReached("no fillet fits", tolerance, largest);
      }
      refine_both(missed);
    }
  }

 private:
  const KnotVector& knots() const { return first_.knot_vector(Axis::u); }

  /// Both on the knots of both.
  void agree() {
    const std::array<NurbsCurve, 2> sides{boundary(first_, Border::v_start), boundary(second_, Border::v_start)};
    const NurbsCurve both = compatible(sides)[0];
    const KnotVector wanted = both.periodic() ? with_whole_seam(both).knot_vector() : both.knot_vector();
    first_ = on_knots(first_, wanted);
    second_ = on_knots(second_, wanted);
  }

  /// First so that the tip, which goes by tangent planes, can be less smooth at knots than the sides are.
  void refine_both(const std::vector<double>& at) {
    const int more = kSmooth - knots().degree();
    for (NurbsPatch* const patch : {&first_, &second_}) {
      if (is_soft_) {
        *patch = refine(*patch, Axis::u, at);
        continue;
      }
      if (more > 0) *patch = elevated(*patch, Axis::u, more);
      *patch = refine(*patch, Axis::u, softened(patch->knot_vector(Axis::u)));
    }
    is_soft_ = true;
  }

  NurbsPatch between() const {
    const std::vector<glm::dvec4> side_a = side_points(first_);
    const std::vector<glm::dvec4> side_b = side_points(second_);
    const std::vector<double> places = greville_places(knots());
    const Samples samples = Samples::make(knots(), places);
    const std::vector<double> weights_a = weights_at(side_a, samples);
    const std::vector<double> weights_b = weights_at(side_b, samples);
    std::vector<glm::dvec4> tips;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double weight = weights_a[i] * weights_b[i];
      if (!(weights_a[i] > 0.0 && weight > 0.0)) throw InvalidShape("the weights of the sides of the fillet are not positive");
      tips.push_back(std::sqrt(weight) * tip_of(ball_.at(places[i], true)));
    }
    solve_rows(knots(), places, std::span(&tips.front().x, 4 * tips.size()));
    std::vector<glm::dvec4> net;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const glm::dvec4& tip = tips[i];
      net.insert(net.end(), {side_a[i], as_given(tip), side_b[i]});
    }
    return NurbsPatch::make(knots(), KnotVector::bezier(2), std::move(net));
  }

  /// Middles of spans in which points are not on the ball, or its sides are not where it touches the patches.
  std::vector<double> missed_spans(const NurbsPatch& made, double tolerance, double& largest) const {
    constexpr std::array kAlong{0.0, 0.15, 0.5, 0.85};
    constexpr std::array kAcross{0.0, 0.25, 0.5, 0.75, 1.0};
    std::vector<double> missed;
    for (int i = 0; i < static_cast<int>(knots().spans().size()); ++i) {
      const Interval span = knots().span_interval(i);
      std::vector<double> u;
      for (const double share : kAlong) u.push_back(span.start + share * span.length());
      std::vector<glm::dvec3> points(u.size() * kAcross.size());
      evaluate_grid(made, u, kAcross, std::span(&points.front().x, 3 * points.size()));
      double off = 0.0;
      for (std::size_t k = 0; k < u.size(); ++k) {
        const auto row = std::span(points).subspan(k * kAcross.size(), kAcross.size());
        off = std::max(off, off_ball(row, ball_.at(u[k], true)));
      }
      largest = std::max(largest, off);
      if (!(off <= tolerance)) missed.push_back(span.start + 0.5 * span.length());
    }
    return missed;
  }

  static double off_ball(std::span<const glm::dvec3> row, const Contact& contact) {
    double off = std::max(distance_of(row.front(), contact.first), distance_of(row.back(), contact.second));
    for (const glm::dvec3& point : row) off = std::max(off, std::abs(distance_of(point, contact.center) - contact.radius));
    return off;
  }

  NurbsPatch first_;
  NurbsPatch second_;
  const RollingBall& ball_;
  bool is_soft_ = false;
};

/// With these rows of control points as its first and its last one along v.
NurbsPatch with_sides(const NurbsPatch& patch, const std::vector<glm::dvec4>& first, const std::vector<glm::dvec4>& last) {
  std::vector<glm::dvec4> net(patch.points().begin(), patch.points().end());
  const std::size_t count_v = net.size() / first.size();
  for (std::size_t i = 0; i < first.size(); ++i) {
    net[i * count_v] = first[i];
    net[(i + 1) * count_v - 1] = last[i];
  }
  return patch.with_points(std::move(net));
}

/// How much farther along the first patch the ball is where it touches the second at u; of closed ones less than once round, without
/// a jump where that is never half the way round more than at the start.
double ahead(const RollingBall& ball, double u, bool is_closed) {
  const double by = ball.at(u, false).on_first.x - u;
  if (!is_closed) return by;
  const double at_start = std::remainder(ball.at(0.0, false).on_first.x, 1.0);
  return at_start + std::remainder(by - at_start, 1.0);
}

/// What a fillet that is hard to have does at a place of the edge, in words.
std::string bend_at(const RollingBall& ball, double u) {
  constexpr double kSteep = 0.25;
  constexpr double kNear = 0x1p-5;
  const std::string place = share_text(u) + " of the edge";
  if (std::abs(ball.growth(u)) > kSteep) return "whose radius changes abruptly at " + place;
  const std::vector<BallJoint> joints = ball.joints();
  const auto nearest = std::ranges::min_element(joints, {}, [&](const BallJoint& joint) { return std::abs(joint.at - u); });
  if (nearest == joints.end() || std::abs(nearest->at - u) > kNear) return "which bends abruptly at " + place;
  return "which bends abruptly at " + place + ", by " + nearest->what;
}

/// Lines across go from one u of the first patch to the same of the second.
Approximation<NurbsPatch> fitted_across(const NurbsPatch& model, const RollingBall& ball, double whole) {
  constexpr double kShare = 0.36;  // the rest is for sides that become those of what is left of the patches
  const double tolerance = kShare * whole;
  constexpr std::size_t kMost = 1 << 16;
  constexpr double kOfTolerance = 0x1p-12;
  const bool is_closed = model.knot_vector(Axis::u).periodic();
  const auto end_of = [&](double u) { return u + ahead(ball, u, is_closed); };
  const Interval range = is_closed ? Interval{0.0, 1.0} : Interval{std::min(0.0, end_of(0.0)), std::max(1.0, end_of(1.0))};
  const BallPath path(ball, range, is_closed, kOfTolerance * tolerance);
  const auto surface = [&](std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> points) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      breathe(v.size());
      const std::vector<double> along = ball.between(u[i], end_of(u[i]), v);
      for (std::size_t j = 0; j < v.size(); ++j) points[i * v.size() + j] = path.at(along[j]).at(v[j]);
    }
  };
  try {
    Approximation<NurbsPatch> made = fitted_patch(model, surface, tolerance, kMost);
    made.error += path.error();
    return made;
  } catch (const SurfaceMissed& missed) {
    const double shares[] = {missed.v};
    const double u = ball.between(missed.u, end_of(missed.u), shares)[0];
    throw ToleranceNotReached("the fillet, " + bend_at(ball, u) + ", and slants across there, does not fit", whole,
                              missed.error() / kShare);
  }
}

}  // namespace

FilletBetween fillet_of_arcs(const NurbsPatch& first, const NurbsPatch& second, const RollingBall& ball, double tolerance) {
  return FilletFit(first, second, ball).within(tolerance);
}

FilletBetween slanted_fillet(const NurbsPatch& first, const NurbsPatch& second, const RollingBall& ball, double tolerance) {
  const FilletBetween rough = FilletFit(first, second, ball).rough();
  const Approximation<NurbsPatch> made = fitted_across(rough.fillet, ball, tolerance);
  const KnotVector& knots = made.value.knot_vector(Axis::u);
  const NurbsPatch left_a = on_knots(rough.first, knots);
  const NurbsPatch left_b = on_knots(rough.second, knots);
  const double moved = std::max(largest_distance(boundary(made.value, Border::v_start), boundary(left_a, Border::v_start)),
                                largest_distance(boundary(made.value, Border::v_end), boundary(left_b, Border::v_start)));
  const double error = made.error + moved;
  if (error > tolerance) {
    throw ToleranceNotReached("no fillet fits between the trimmed patches", tolerance, error);
  }
  return {left_a, with_sides(made.value, side_points(left_a), side_points(left_b)), left_b, error};
}

}  // namespace splinecore
