#include "splinecore/build/curve_on_patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cubics_along.hpp"
#include "base/length.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/plane.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

/// A direction of a patch in which an image moves.
class ImageAxis {
 public:
  ImageAxis(const NurbsPatch& patch, Axis axis)
      : domain_(patch.knot_vector(axis).domain()), is_closed_(patch.knot_vector(axis).periodic() || closes(patch, axis)), name_(axis == Axis::u ? 'u' : 'v') {
    const auto knots = patch.knot_vector(axis).knots();
    for (const double knot : knots) {
      if (knot >= domain_.start && knot <= domain_.end && (knots_.empty() || knot > knots_.back())) knots_.push_back(knot);
    }
  }

  /// In the domain, on the side that goes on towards another place.
  double inside(double x, double towards) const {
    if (is_closed_) {
      const double turn = domain_.length();
      const double turns = std::floor((x - domain_.start) / turn);
      const double found = std::clamp(x - turns * turn, domain_.start, domain_.end);
      return found == domain_.start && towards < x ? domain_.end : found;
    }
    // What rounding of the image's own evaluation leaves outside is at the border.
    const double rest = 0x1p-40 * domain_.length();
    if (x < domain_.start - rest || x > domain_.end + rest || std::isnan(x)) {
      throw InvalidShape(std::string("the image leaves the patch at ") + name_ + " = " + text_of(x) + ", the domain is " +
                         text_of(domain_.start) + " to " + text_of(domain_.end));
    }
    return std::clamp(x, domain_.start, domain_.end);
  }

  /// The lines that may be creases, over all the turns from one value to another.
  std::vector<double> lines(double from, double to) const {
    if (!is_closed_) return knots_;
    std::vector<double> found;
    const double turn = domain_.length();
    constexpr double kMost = 1 << 16;
    if (!((to - from) / turn * static_cast<double>(knots_.size()) < kMost)) {
      throw InvalidShape(std::string("the image goes around the patch along ") + name_ + " " + text_of((to - from) / turn) +
                         " times, too often to be followed");
    }
    for (double k = std::floor((from - domain_.start) / turn); domain_.start + k * turn <= to; ++k) {
      for (std::size_t i = 0; i + 1 < knots_.size(); ++i) found.push_back(knots_[i] + k * turn);
    }
    return found;
  }

 private:
  static bool closes(const NurbsPatch& patch, Axis axis) {
    const Axis other = axis == Axis::u ? Axis::v : Axis::u;
    const Interval along = patch.knot_vector(axis).domain();
    const KnotVector& across = patch.knot_vector(other);
    const NearSpace space(patch.points());
    // Quotients of polynomials that are the same at so many places of a span are the same.
    const int looks = 2 * across.degree() + 1;
    const std::array<double, 2> along_both{along.start, along.end};
    for (int span = 0; span < static_cast<int>(across.spans().size()); ++span) {
      const Interval part = across.span_interval(span);
      for (int i = 0; i < looks; ++i) {
        const double w = i + 1 == looks ? part.end : part.start + part.length() * i / (looks - 1);
        std::array<glm::dvec3, 2> ends;
        const std::array<double, 2> across_both{w, w};
        evaluate(patch, axis == Axis::u ? along_both : across_both, axis == Axis::u ? across_both : along_both,
                 std::span(&ends[0].x, 6), {.at_infinity = AtInfinity::nan});
        constexpr double kSame = 0x1p-40;
        if (!(distance_of(ends[0], ends[1]) <= space.length(kSame))) return false;
      }
    }
    return true;
  }

  Interval domain_;
  bool is_closed_;
  char name_;
  std::vector<double> knots_;
};

class ImageOnPatch {
 public:
  ImageOnPatch(const NurbsPatch& patch, const NurbsCurve& image, double distance)
      : patch_(patch), image_(image), distance_(distance), u_(patch, Axis::u), v_(patch, Axis::v) {}

  /// Knots of the image, and where it crosses those of the patch.
  std::vector<double> breaks() const {
    const Interval domain = image_.domain();
    std::vector<double> found;
    for (const double knot : image_.knot_vector().knots()) {
      if (knot > domain.start && knot < domain.end) found.push_back(knot);
    }
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const glm::dvec4& p : image_.points()) {
      if (p.w == 0.0) continue;
      low = glm::min(low, glm::dvec3(p));
      high = glm::max(high, glm::dvec3(p));
    }
    for (const bool is_u : {true, false}) {
      const int k = is_u ? 0 : 1;
      for (const double line : (is_u ? u_ : v_).lines(low[k], high[k])) {
        if (line < low[k] || line > high[k] || low[k] == high[k]) continue;
        const Plane across = is_u ? plane_along({line, 0, 0}, {0, 1, 0}, {0, 0, 1}) : plane_along({0, line, 0}, {1, 0, 0}, {0, 0, 1});
        for (const PatchIntersection& place : intersections(image_, across).places) found.push_back(place.t);
      }
    }
    return distinct_breaks(std::move(found), domain);
  }

  std::vector<PathPlace> places(const std::vector<PathParameter>& asked) const {
    std::vector<PathPlace> found;
    found.reserve(asked.size());
    for (const PathParameter& one : asked) found.push_back(place(one));
    return found;
  }

 private:
  PathPlace place(const PathParameter& t) const {
    std::array<glm::dvec3, 2> there;
    glm::dvec3 next;
    const Side side = t.towards < t.at ? Side::left : Side::right;
    derivatives(image_, std::span(&t.at, 1), 1, std::span(&there[0].x, 6), {.side = side});
    evaluate(image_, std::span(&t.towards, 1), std::span(&next.x, 3));
    const double u = u_.inside(there[0].x, next.x);
    const double v = v_.inside(there[0].y, next.y);
    const PatchOptions options{next.x < there[0].x ? Side::left : Side::right,
                               next.y < there[0].y ? Side::left : Side::right};
    std::array<glm::dvec3, 9> d;
    derivatives(patch_, std::span(&u, 1), std::span(&v, 1), 2, std::span(&d[0].x, 27), options);
    const double by_u = there[1].x;
    const double by_v = there[1].y;
    const glm::dvec3& along_u = d[3];
    const glm::dvec3& along_v = d[1];
    const PathPlace on_patch{d[0], by_u * along_u + by_v * along_v};
    if (distance_ == 0.0) return on_patch;
    const glm::dvec3 across = glm::cross(along_u, along_v);
    const double area = glm::length(across);
    constexpr double kFlat = 0x1p-40;
    if (!(area > kFlat * glm::length(along_u) * glm::length(along_v))) {
      throw InvalidShape("the patch has no normal at u = " + text_of(u) + ", v = " + text_of(v));
    }
    const glm::dvec3 normal = across / area;
    const glm::dvec3 turn = glm::cross(by_u * d[6] + by_v * d[4], along_v) + glm::cross(along_u, by_u * d[4] + by_v * d[2]);
    const glm::dvec3 slope = (turn - glm::dot(turn, normal) * normal) / area;
    return {on_patch.point + distance_ * normal, on_patch.slope + distance_ * slope};
  }

  const NurbsPatch& patch_;
  const NurbsCurve& image_;
  double distance_;
  ImageAxis u_;
  ImageAxis v_;
};

}  // namespace

NurbsCurve curve_on_patch(const NurbsPatch& patch, const NurbsCurve& image, double distance,
                          std::optional<double> tolerance) {
  if (!std::isfinite(distance)) throw InvalidShape("the distance is not a finite number");
  if (tolerance && !(*tolerance > 0.0)) throw InvalidShape("the tolerance is not above 0");
  const NearSpace space(patch.points());
  const double unit = space.length(1.0);
  const NurbsPatch near = patch.with_points(space.enter(patch.points()));
  const ImageOnPatch on_patch(near, image, distance / unit);
  const double within = cubics_tolerance(space, tolerance);
  const Path path = [&](const std::vector<PathParameter>& asked) { return on_patch.places(asked); };
  const NurbsCurve found = cubics_along(path, on_patch.breaks(), within);
  return found.with_points(space.leave(found.points()));
}

}  // namespace splinecore
