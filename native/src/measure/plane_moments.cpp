#include "splinecore/measure/plane_moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <vector>

#include "base/rounding.hpp"
#include "closed_curve.hpp"
#include "placed_patches.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "sweep_integral.hpp"
#include "unit_direction.hpp"

namespace splinecore {

namespace {

using PlaneSums = SweepSums<6>;

/// What closed curves enclose, near the origin.
struct PlaneArea {
  Placement placement;
  View view;
  double height;  ///< along the normal
  double radius;  ///< of what is measured
  double area;
  double wrong;  ///< how much the area may be off
  glm::dvec2 middle;
  std::array<double, 3> seconds;  ///< xx, xy and yy about the middle
  PlaneSums sums;                 ///< errors of them all are what they may be off
};

Placement common_placement(std::span<const NurbsCurve> outlines) {
  std::vector<glm::dvec4> points;
  for (const NurbsCurve& outline : outlines) std::ranges::copy(outline.points(), std::back_inserter(points));
  return placement_of(points);
}

/// The largest and the least of heights of control points along a direction.
class HeightRange {
 public:
  explicit HeightRange(const glm::dvec3& direction) : direction_(direction) {}

  void add(const NurbsCurve& curve) {
    for (const glm::dvec4& p : curve.points()) {
      if (p.w == 0.0) continue;
      const double height = glm::dot(glm::dvec3(p), direction_);
      low_ = std::min(low_, height);
      high_ = std::max(high_, height);
      radius_ = std::max(radius_, glm::length(glm::dvec3(p)));
    }
  }

  double radius() const { return radius_; }

  /// @throws InvalidShape unless all are one, but for 1e-9 of the size, or rounding of coordinates, of which the largest are about 1
  double height() const {
    constexpr double kFlat = 1e-9;
    if (high_ - low_ > std::max(kFlat * radius_, kRoundingOfSum)) {
      throw InvalidShape("the curves are not in one plane with this normal: along it they differ by " +
                         text_of((high_ - low_) / radius_) + " of their size");
    }
    return 0.5 * (low_ + high_);
  }

 private:
  glm::dvec3 direction_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -low_;
  double radius_ = 0.0;
};

void require_area(const PlaneSums& sums) {
  if (std::abs(sums.values[0]) > sums.errors[0]) return;
  throw InvalidShape("the curves enclose no area: they have no centroid");
}

PlaneArea measured(std::span<const NurbsCurve> outlines, const glm::dvec3& normal, double tolerance) {
  require_relative(tolerance);
  const glm::dvec3 direction = unit_direction(normal, "normal");
  const Placement placement = common_placement(outlines);
  SweepIntegral<6> integral(tolerance);
  PlaneSums sums;
  HeightRange heights(direction);
  int degree = 1;
  for (const NurbsCurve& outline : outlines) {
    const ClosedCurve closed = closed_curve(outline, direction, placement);
    heights.add(closed.near.curve);
    degree = std::max(degree, outline.degree());
    for_each_span(closed.near.curve, outline, [&](const Interval&, const std::vector<glm::dvec4>& piece) {
      sums.add(integral.over(closed.view.seen(piece)));
    });
    sums.add(integral.over(std::array{glm::dvec3(closed.end, 1.0), glm::dvec3(closed.start, 1.0)}));
  }
  constexpr std::array<double, 6> kShares{0.5, 1.0 / 3.0, 1.0 / 3.0, 0.25, 0.25, 0.25};
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    sums.values[i] *= kShares[i];
    sums.errors[i] = kShares[i] * (sums.errors[i] + 0x1p-50 * (degree + 3) * sums.terms[i]);
  }
  if (!std::isfinite(sums.values[0] + sums.values[3] + sums.values[5])) throw InvalidShape("points and weights differ too much in size");
  require_area(sums);
  const double area = sums.values[0];
  const glm::dvec2 middle = glm::dvec2(sums.values[1], sums.values[2]) / area;
  const std::array<double, 3> seconds{sums.values[3] - area * middle.x * middle.x, sums.values[4] - area * middle.x * middle.y,
                                      sums.values[5] - area * middle.y * middle.y};
  return {placement, View(direction), heights.height(), heights.radius(), area, sums.errors[0], middle, seconds, sums};
}

glm::dvec3 placed_middle(const PlaneArea& found, const glm::dvec3& normal) {
  return found.view.direction(found.middle) + found.height * unit_direction(normal, "normal");
}

double error_of_middle(const PlaneArea& found) {
  const auto wrong = [&](int i) { return (found.sums.errors[1 + i] + std::abs(found.middle[i]) * found.wrong) / std::abs(found.area); };
  return glm::length(glm::dvec2(wrong(0), wrong(1)));
}

}  // namespace

Approximation<double> enclosed_area(std::span<const NurbsCurve> outlines, const glm::dvec3& normal, double tolerance) {
  require_relative(tolerance);
  Approximation<double> sum{0.0, 0.0};
  for (const NurbsCurve& outline : outlines) {
    const Approximation<double> one = signed_area(outline, normal, tolerance);
    sum.value += one.value;
    sum.error += one.error;
  }
  return sum;
}

Approximation<glm::dvec3> plane_centroid(std::span<const NurbsCurve> outlines, const glm::dvec3& normal, double tolerance) {
  const PlaneArea found = measured(outlines, normal, tolerance);
  const glm::dvec3 middle = placed_middle(found, normal);
  return {given_point(middle, found.placement), given_size(error_of_middle(found), 1, found.placement)};
}

Approximation<SecondMoments> plane_second_moments(std::span<const NurbsCurve> outlines, const glm::dvec3& normal,
                                                  std::optional<glm::dvec3> about, double tolerance) {
  if (about && !(std::isfinite(about->x) && std::isfinite(about->y) && std::isfinite(about->z))) throw InvalidShape("about is not finite");
  const PlaneArea found = measured(outlines, normal, tolerance);
  const glm::dvec3 middle = placed_middle(found, normal);
  const glm::dvec3 x = found.view.direction({1.0, 0.0});
  const glm::dvec3 y = found.view.direction({0.0, 1.0});
  glm::dvec3 way(0.0);
  for (int i = 0; about && i < 3; ++i) way[i] = std::ldexp(found.placement.origin[i] - (*about)[i], -found.placement.exponent) + middle[i];
  const auto& [xx, xy, yy] = found.seconds;
  SecondMoments moments;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double own = xx * x[i] * x[j] + xy * (x[i] * y[j] + y[i] * x[j]) + yy * y[i] * y[j];
      moments[i][j] = finite_size(own + found.area * way[i] * way[j], 4, found.placement, "second moment");
    }
  }
  double error = glm::dot(way, way) * found.wrong + 2.0 * found.radius * std::abs(found.area) * error_of_middle(found);
  for (std::size_t i = 3; i < 6; ++i) error += found.sums.errors[i];
  return {moments, given_size(error, 4, found.placement)};
}

}  // namespace splinecore
