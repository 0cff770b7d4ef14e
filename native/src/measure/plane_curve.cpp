#include "splinecore/measure/plane_curve.hpp"

#include <cmath>

#include "closed_curve.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "sweep_integral.hpp"

namespace splinecore {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Of a polynomial span: the mean of its coefficients is its integral.
SweepSums<1> mean_of(const Numerator& numerator) {
  SweepSums<1> found;
  const double share = 1.0 / static_cast<double>(numerator.coefficients.size());
  for (const double c : numerator.coefficients) {
    found.values[0] += share * c;
    found.terms[0] += share * std::abs(c);
  }
  return found;
}

/// Crossings of the ray from the origin along x, counted where the curve passes from one side to the other.
class Crossings {
 public:
  explicit Crossings(double near) : near_(near) {}

  void add(std::span<const glm::dvec3> points) {
    const double turn = points.front().z < 0.0 ? -1.0 : 1.0;
    Numerator height;
    for (const glm::dvec3& p : points) {
      height.coefficients.push_back(turn * p.y);
      height.noise = std::max(height.noise, 0x1p-50 * static_cast<double>(points.size()) * std::abs(p.y));
    }
    const Signs signs(height);
    if (signs.is_zero()) return lie_along(points);
    for (const Interval& zero : signs.zeros) require_away(x_at(points, zero.start));
    for (const Run& run : signs.runs) {
      if (last_ == 0.0) {
        first_ = run.sign;
        first_x_ = x_at(points, run.part.start);
      } else {
        cross(run.sign, x_at(points, run.part.start));
      }
      last_ = run.sign;
    }
  }

  int found() && {
    if (last_ != 0.0) cross(first_, first_x_);
    return count_;
  }

 private:
  static double x_at(std::span<const glm::dvec3> points, double t) {
    std::vector<double> x;
    std::vector<double> w;
    for (const glm::dvec3& p : points) {
      x.push_back(p.x);
      w.push_back(p.z);
    }
    return bernstein_value(x, t) / bernstein_value(w, t);
  }

  void require_away(double x) const {
    if (std::abs(x) <= near_) throw InvalidShape("point lies on the curve");
  }

  /// A span on the line of the ray: the point may lie between its lowest and highest places.
  void lie_along(std::span<const glm::dvec3> points) const {
    std::vector<glm::dvec2> line;
    for (const glm::dvec3& p : points) line.emplace_back(p.x, p.z);
    const Numerator slope = slope_of(line);
    std::vector<double> places{0.0, 1.0};
    for (const Interval& zero : bernstein_zeros(slope.coefficients, slope.noise)) places.push_back(zero.start);
    bool is_left = false;
    bool is_right = false;
    for (const double t : places) {
      const double x = x_at(points, t);
      require_away(x);
      (x < 0.0 ? is_left : is_right) = true;
    }
    if (is_left && is_right) require_away(0.0);
  }

  void cross(double sign, double x) {
    if (sign == last_ || x < 0.0) return;
    count_ += sign > 0.0 ? 1 : -1;
  }

  double near_;
  double first_ = 0.0;
  double first_x_ = 0.0;
  double last_ = 0.0;
  int count_ = 0;
};

}  // namespace

Approximation<double> signed_area(const NurbsCurve& curve, const glm::dvec3& normal, double tolerance) {
  require_relative(tolerance);
  const ClosedCurve closed = closed_curve(curve, normal, placement_of(curve.points()));
  SweepIntegral<1> integral(tolerance);
  SweepSums<1> sums;
  for_each_span(closed.near.curve, curve, [&](const Interval&, const std::vector<glm::dvec4>& piece) {
    const std::vector<glm::dvec3> seen = closed.view.seen(piece);
    if (closed.near.curve.rational()) return sums.add(integral.over(seen));
    sums.add(mean_of(sweep_of(std::vector<glm::dvec2>(seen.begin(), seen.end()))));
  });
  const double sum = sums.values[0] + cross(closed.end, closed.start);
  if (!std::isfinite(sum)) throw InvalidShape("points and weights differ too much in size");
  const Placement& placement = closed.near.placement;
  const double rounding = 0x1p-50 * (curve.degree() + 3) * sums.terms[0];
  const double allowed = std::max(tolerance * sums.terms[0], rounding);
  if (sums.errors[0] > allowed) {
    throw ToleranceNotReached("the area cannot be found", given_size(0.5 * allowed, 2, placement),
                              given_size(0.5 * sums.errors[0], 2, placement));
  }
  return {finite_size(0.5 * sum, 2, placement, "area"), given_size(0.5 * (sums.errors[0] + rounding), 2, placement)};
}

int winding_number(const NurbsCurve& curve, const glm::dvec3& point, const glm::dvec3& normal) {
  constexpr double kOnCurve = 1e-12;
  const ClosedCurve closed = closed_curve(curve, normal, placement_of(curve.points()));
  const Placement& placement = closed.near.placement;
  glm::dvec3 placed(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    placed[axis] = std::scalbn(point[axis] - placement.origin[axis], -placement.exponent);
    if (!std::isfinite(placed[axis])) return 0;
  }
  const glm::dvec2 origin = closed.view.seen(placed);
  Crossings crossings(kOnCurve * extent(closed.near.curve.points()));
  for_each_span(closed.near.curve, curve, [&](const Interval&, const std::vector<glm::dvec4>& piece) {
    std::vector<glm::dvec3> points = closed.view.seen(piece);
    for (glm::dvec3& p : points) {
      p.x -= p.z * origin.x;
      p.y -= p.z * origin.y;
    }
    crossings.add(points);
  });
  return std::move(crossings).found();
}

}  // namespace splinecore
