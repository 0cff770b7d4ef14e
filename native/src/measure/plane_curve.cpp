#include "splinecore/measure/plane_curve.hpp"

#include <array>
#include <string>

#include "finite_weights.hpp"
#include "kronrod_31.hpp"
#include "quadrature.hpp"
#include "signs.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "unit_direction.hpp"

namespace splinecore {

namespace {

/// A closed curve seen against a direction, near the origin.
struct ClosedCurve {
  NearCurve near;
  View view;
  glm::dvec2 start;
  glm::dvec2 end;
};

ClosedCurve closed_curve(const NurbsCurve& curve, const glm::dvec3& normal) {
  constexpr double kClosed = 1e-9;
  const View view(unit_direction(normal, "normal"));
  require_finite_points(curve, curve.domain());
  const std::size_t count = pieces(curve).size();
  if (count > 1) throw InvalidShape("the curve is not closed: it is in " + std::to_string(count) + " pieces");
  NearCurve near = near_origin(curve);
  std::array<glm::dvec3, 2> ends;
  const Interval domain = near.curve.domain();
  evaluate(near.curve, {&domain.start, 1}, std::span(&ends[0].x, 3), {.side = Side::right});
  evaluate(near.curve, {&domain.end, 1}, std::span(&ends[1].x, 3), {.side = Side::left});
  const double apart = glm::distance(ends[0], ends[1]);
  const double size = extent(near.curve.points());
  if (apart > kClosed * size) {
    throw InvalidShape("the curve is not closed: its ends are apart by " + text_of(apart / size) + " of its size");
  }
  return {std::move(near), view, view.seen(ends[0]), view.seen(ends[1])};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Twice an area, how far it may be off, and how much is swept to and fro.
struct Sweep {
  double value = 0.0;
  double error = 0.0;
  double terms = 0.0;

  void add(const Sweep& more) {
    value += more.value;
    error += more.error;
    terms += more.terms;
  }
};

/// The sum of Bernstein polynomials, whose values are given.
double sum_of(const BernsteinNet<double>& net, std::span<const double> functions) {
  double sum = 0.0;
  for (std::size_t i = 0; i < net.rows; ++i) sum += functions[i] * net.values[i];
  return sum;
}

/// The integral of N / W² over [0, 1].
class Quotient {
 public:
  explicit Quotient(double tolerance) : tolerance_(tolerance) {}

  Sweep integral(BernsteinNet<double> numerator, BernsteinNet<double> weight, int depth = 0) {
    constexpr int kDeepest = 60;
    constexpr double kCaution = 0.125;
    constexpr double kRounding = 0x1p-50;
    const bool is_deep = depth == kDeepest;
    if (is_deep || is_even(weight)) {
      const Sweep found = by_rule(numerator, weight);
      if (is_deep || found.error <= std::max(kCaution * tolerance_, kRounding) * found.terms) return found;
    }
    BernsteinNet<double> numerator_after;
    BernsteinNet<double> weight_after;
    numerator.halve(Axis::u, numerator_after);
    weight.halve(Axis::u, weight_after);
    for (double& c : numerator.values) c *= 0.5;
    for (double& c : numerator_after.values) c *= 0.5;
    Sweep found = integral(std::move(numerator), std::move(weight), depth + 1);
    found.add(integral(std::move(numerator_after), std::move(weight_after), depth + 1));
    return found;
  }

 private:
  static bool is_even(const BernsteinNet<double>& weight) {
    constexpr double kMost = 16.0;
    const auto [low, high] = weight.range();
    return low > 0.0 ? high <= kMost * low : high < 0.0 && low >= kMost * high;
  }

  Sweep by_rule(const BernsteinNet<double>& numerator, const BernsteinNet<double>& weight) {
    breathe(64 * numerator.rows);
    functions_.resize(std::max(numerator.rows, weight.rows));
    Sweep found;
    double change = 0.0;
    const auto add = [&](double t, double s, const KronrodNode& node) {
      bernstein(weight.degree(Axis::u), t, s, functions_);
      const double w = sum_of(weight, functions_);
      bernstein(numerator.degree(Axis::u), t, s, functions_);
      const double value = sum_of(numerator, functions_) / (w * w);
      found.value += node.kronrod * value;
      found.terms += node.kronrod * std::abs(value);
      change += (node.kronrod - node.gauss) * value;
    };
    for (const KronrodNode& node : kKronrod31) {
      add(node.at, 1.0 - node.at, node);
      if (node.at != 0.5) add(1.0 - node.at, node.at, node);
    }
    found.error = std::abs(change);
    return found;
  }

  double tolerance_;
  std::vector<double> functions_;
};

/// Of a polynomial span: the mean of its coefficients is its integral.
Sweep mean_of(const Numerator& numerator) {
  Sweep found;
  const double share = 1.0 / static_cast<double>(numerator.coefficients.size());
  for (const double c : numerator.coefficients) {
    found.value += share * c;
    found.terms += share * std::abs(c);
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
  const ClosedCurve closed = closed_curve(curve, normal);
  Quotient quotient(tolerance);
  Sweep sum;
  for_each_span(closed.near.curve, curve, [&](const Interval&, const std::vector<glm::dvec4>& piece) {
    std::vector<glm::dvec2> seen;
    std::vector<double> weights;
    for (const glm::dvec4& p : piece) {
      seen.push_back(closed.view.seen(glm::dvec3(p)));
      weights.push_back(p.w);
    }
    Numerator sweep = sweep_of(seen);
    if (!closed.near.curve.rational()) return sum.add(mean_of(sweep));
    sum.add(quotient.integral(BernsteinNet<double>::of_curve(std::move(sweep.coefficients)),
                              BernsteinNet<double>::of_curve(std::move(weights))));
  });
  sum.value += cross(closed.end, closed.start);
  if (!std::isfinite(sum.value)) throw InvalidShape("points and weights differ too much in size");
  const Placement& placement = closed.near.placement;
  const double rounding = 0x1p-50 * (curve.degree() + 3) * sum.terms;
  const double allowed = std::max(tolerance * sum.terms, rounding);
  if (sum.error > allowed) {
    throw ToleranceNotReached("the area cannot be found", given_size(0.5 * allowed, 2, placement),
                              given_size(0.5 * sum.error, 2, placement));
  }
  return {finite_size(0.5 * sum.value, 2, placement, "area"), given_size(0.5 * (sum.error + rounding), 2, placement)};
}

int winding_number(const NurbsCurve& curve, const glm::dvec3& point, const glm::dvec3& normal) {
  constexpr double kOnCurve = 1e-12;
  const ClosedCurve closed = closed_curve(curve, normal);
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
