#include <algorithm>
#include <cmath>
#include <limits>

#include "base/require.hpp"
#include "near_distance.hpp"
#include "piece_side.hpp"
#include "slopes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/meet/stationary.hpp"
#include "stationary_line.hpp"

namespace splinecore {

namespace {

class CurvePlaces {
 public:
  CurvePlaces(const NurbsCurve& curve, const glm::dvec3& point)
      : space_(curve.points()), line_{curve.knot_vector(), false, {}}, from_(point, space_, "point") {
    const auto homogeneous = curve.homogeneous_points();
    const auto own = space_.homogeneous(curve.points(), homogeneous, curve.points().size(), homogeneous.size());
    for (int i = 0; i < static_cast<int>(line_.knots.spans().size()); ++i) {
      line_.pieces.push_back(bezier_piece(line_.knots, i, own.data()));
    }
    line_.is_closed = are_one(line_.pieces.back().values.back(), line_.pieces.front().values.front(),
                              space_.rounding());
  }

  /// Pieces at one distance that is above the limit are left out.
  std::vector<StationaryOnCurve> found(double limit) const {
    const auto constant = [&](std::size_t i) { refuse_constant(i, limit); };
    std::vector<StationaryOnCurve> found;
    for (const LinePlace& place : stationary_places(line_, from_.near().at, space_.rounding(), constant)) {
      const glm::dvec3 point = point_at(place.piece, place.t);
      found.push_back({span(place.piece).at(place.t), from_.leave(point), from_.distance_to(point),
                       kind_of(place.before, place.after)});
    }
    if (found.empty() && is_at_infinity()) throw PointAtInfinity("no point of the shape is finite");
    return found;
  }

 private:
  Interval span(std::size_t i) const { return line_.knots.span_interval(static_cast<int>(i)); }

  glm::dvec3 point_at(std::size_t i, double t) const {
    const BernsteinNet<glm::dvec4>& piece = line_.pieces[i];
    return slopes_of<1>(kernels(), piece.values.data(), piece.rows, 1, {t}, from_.near().at).point;
  }

  void refuse_constant(std::size_t i, double limit) const {
    if (from_.distance_to(point_at(i, 0.5)) > limit) return;
    const Interval at = span(i);
    throw InvalidShape("the distance from the point is constant from u = " + text_of(at.start) + " to " +
                       text_of(at.end) + ": it is stationary everywhere there");
  }

  bool is_at_infinity() const {
    return std::ranges::none_of(line_.pieces, [](const BernsteinNet<glm::dvec4>& piece) {
      return std::ranges::any_of(piece.values, [](const glm::dvec4& h) { return h.w != 0.0; });
    });
  }

  NearSpace space_;
  PieceLine line_;
  NearOrigin from_;
};

}  // namespace

std::vector<StationaryOnCurve> stationary_points(const NurbsCurve& curve, const glm::dvec3& point) {
  return CurvePlaces(curve, point).found(std::numeric_limits<double>::infinity());
}

std::vector<NearestOnCurve> nearest_all(const NurbsCurve& curve, const glm::dvec3& point,
                                        std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  require_finite({&point.x, 3}, "point");
  NearestOnCurve least;
  nearest(curve, {&point, 1}, {&least, 1}, 1);
  const double limit = limit_of(least.distance, tolerance, curve.points());
  std::vector<NearestOnCurve> found;
  for (const StationaryOnCurve& place : CurvePlaces(curve, point).found(limit)) {
    if (place.kind != Stationary::minimum || place.distance > limit) continue;
    found.push_back({place.parameter, place.point, place.distance});
  }
  return found.empty() ? std::vector{least} : found;
}

}  // namespace splinecore
