#include "splinecore/surface/extend_patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "build/with_end.hpp"
#include "meet/near_space.hpp"
#include "patch/lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

/// A clamped curve that goes on along its tangent up to a parameter, as a straight homogeneous line.
NurbsCurve with_straight_end(const NurbsCurve& curve, double end) {
  const int degree = curve.degree();
  const auto knots = curve.knot_vector().knots();
  const double last = curve.domain().end;
  const auto old = curve.homogeneous_points();
  const double width = last - knots[knots.size() - static_cast<std::size_t>(degree) - 2];
  const glm::dvec4 step = (end - last) / width * (old.back() - old[old.size() - 2]);
  const int copies = std::max(1, degree - 1);
  std::vector<glm::dvec4> points(old.begin(), old.end() - (degree > 1 ? 1 : 0));
  for (int k = 1; k <= degree; ++k) points.push_back(old.back() + static_cast<double>(k) * step);
  std::vector<double> further(knots.begin(), knots.end() - degree - 1);
  further.insert(further.end(), static_cast<std::size_t>(copies), last);
  further.insert(further.end(), static_cast<std::size_t>(degree) + 1, end);
  return NurbsCurve::from_homogeneous(KnotVector::make(degree, std::move(further)), points);
}

/// A patch clamped in the direction that is made longer, at its end.
class Longer {
 public:
  Longer(const NurbsPatch& patch, Axis axis, Extension how)
      : patch_(patch), axis_(axis), how_(how), domain_(patch.knot_vector(axis).domain()) {
    const KnotVector& along_side = patch.knot_vector(across(axis));
    const int each = std::max(4, 64 / static_cast<int>(along_side.spans().size()));
    for (int i = 0; i < static_cast<int>(along_side.spans().size()); ++i) {
      const Interval span = along_side.span_interval(i);
      for (int k = 0; k < each; ++k) {
        lines_.push_back({span.start + span.length() * (k + 0.5) / each, span.length() / each / along_side.domain().length()});
      }
    }
  }

  NurbsPatch until(double end) const {
    return along(patch_, axis_, [&](const NurbsCurve& line) {
      return how_ == Extension::natural ? with_end(line, end) : with_straight_end(line, end);
    });
  }

  /// How long what was added is, on average; infinite where it runs to infinity.
  double length(double end) const {
    const NurbsPatch added = split(until(end), axis_, domain_.end).second;
    const auto points = added.points();
    const bool is_finite = std::ranges::all_of(points, [&](const glm::dvec4& p) { return p.w * points.front().w > 0.0; });
    if (!is_finite) return std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (const Line& line : lines_) sum += line.share * splinecore::length(isocurve(added, across(axis_), line.at)).value;
    return sum;
  }

  /// The parameter up to which it is so much longer.
  double end_for(double wanted) const {
    constexpr int kDoublings = 48;
    constexpr int kSteps = 180;
    constexpr double kSame = 0x1p-46;
    constexpr double kPast = 1.0 + 0x1p-10;
    const KnotVector& knots = patch_.knot_vector(axis_);
    double low = 0.0;
    double step = 0.25 * knots.span_interval(static_cast<int>(knots.spans().size()) - 1).length();
    double reached = length(domain_.end + step);
    while (reached > wanted) {
      step *= 0.25;
      if (!(domain_.end + step > domain_.end)) throw InvalidShape("the surface runs to infinity at its side: it cannot be continued there");
      reached = length(domain_.end + step);
    }
    for (int i = 0; reached < wanted; ++i) {
      if (i == kDoublings || !(reached > 0.0)) throw InvalidShape("the surface has a zero derivative across its side: it cannot be continued there");
      low = step;
      const double next = std::min(2.0, 1.5 * wanted / reached);
      step *= std::max(next, 1.01);
      reached = length(domain_.end + step);
    }
    double at_low = low > 0.0 ? length(domain_.end + low) : 0.0;
    for (int i = 0; i < kSteps && reached - wanted > kSame * wanted; ++i) {
      // By the chord, or where that is slow, as beside infinity, by halves.
      const double chord = low + (step - low) * (wanted - at_low) / (reached - at_low) * kPast;
      const double middle = i % 3 < 2 && chord > low && chord < step ? chord : low + 0.5 * (step - low);
      if (!(middle > low && middle < step)) break;
      const double there = length(domain_.end + middle);
      (there < wanted ? low : step) = middle;
      (there < wanted ? at_low : reached) = there;
    }
    if (!std::isfinite(length(domain_.end + step))) throw InvalidShape("the surface runs to infinity within that length");
    return domain_.end + step;
  }

 private:
  /// A line across the side, and the part of it that it stands for.
  struct Line {
    double at;
    double share;
  };

  NurbsPatch patch_;
  Axis axis_;
  Extension how_;
  Interval domain_;
  std::vector<Line> lines_;
};

NurbsPatch turned(const NurbsPatch& patch, Axis axis, const Interval& domain) {
  return with_domain(reversed(patch, axis), axis, domain);
}

}  // namespace

NurbsPatch extended(const NurbsPatch& patch, Border side, double length, Extension how) {
  const Axis axis = axis_of(side);
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape("the length is not above 0");
  if (how == Extension::arc) throw InvalidShape("a surface is extended naturally or straight, not by arcs");
  constexpr double kRange = 0x1p40;
  const double size = NearSpace(patch.points()).length(1.0);
  if (length > kRange * size || length < size / kRange) {
    throw InvalidShape("the length " + text_of(length) + " is too " + (length > size ? "long" : "short") + " for a surface about " +
                       text_of(size) + " large");
  }
  if (patch.knot_vector(axis).periodic()) throw InvalidShape("the surface is closed in this direction: it has no side to extend");
  const Interval domain = patch.knot_vector(axis).domain();
  if (!is_at_end(side)) {
    const NurbsPatch back = extended(turned(patch, axis, domain), axis == Axis::u ? Border::u_end : Border::v_end, length, how);
    const double added = back.knot_vector(axis).domain().end - domain.end;
    return turned(back, axis, {domain.start - added, domain.end});
  }
  const NurbsPatch whole = clamped(patch, axis);
  const NearSpace space(whole.points());
  const Longer longer(whole.with_points(space.enter(whole.points())), axis, how);
  const double end = longer.end_for(length / space.length(1.0));
  return Longer(whole, axis, how).until(end);
}

}  // namespace splinecore
