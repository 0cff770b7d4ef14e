#include "splinecore/curve/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "curve_tables.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kFastOrder = 2;

std::size_t run_of(const CurveForm& form, const CurveHalf& half, double low, double high, std::span<const double> u,
                   double* out, int* found) {
  return kernels().curve_run(form, half, low, high, u.data(), u.size(), out, found);
}

std::size_t run_of(const CurveForm& form, const CurveHalf& half, double low, double high, std::span<const double> u,
                   float* out, int* found) {
  return kernels().curve_run_single(form, half, low, high, u.data(), u.size(), out, found);
}

int scattered_of(const CurveForm& form, const ScatteredHalves& halves, std::size_t count, double* out) {
  return kernels().curve_scattered(form, halves, count, out);
}

int scattered_of(const CurveForm& form, const ScatteredHalves& halves, std::size_t count, float* out) {
  return kernels().curve_scattered_single(form, halves, count, out);
}

/// Finds the half of a span for one parameter after the other.
class Locator {
 public:
  Locator(const NurbsCurve& curve, int order, Side side) : curve_(curve), order_(order), side_(side) {}

  /// The half of an admitted parameter.
  const CurveHalf& locate(double u) {
    if (!is_inside(u)) {
      const int span = curve_.knot_vector().span_of(u, side_);
      const Interval range = curve_.knot_vector().span_interval(span);
      const bool is_second = is_in_second_half(range, u);
      half_ = curve_.tables().half(curve_, span, is_second, order_);
      low_ = is_second ? range.middle() : range.start;
      high_ = is_second ? range.end : range.middle();
    }
    return half_;
  }

  /// Whether it lies strictly inside the half that was found last.
  bool is_inside(double u) const { return u > low_ && u < high_; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  const NurbsCurve& curve_;
  int order_;
  Side side_;
  CurveHalf half_{};
  double low_ = 1.0;
  double high_ = 0.0;
};

/// The homogeneous point at an admitted parameter.
glm::dvec4 homogeneous_at(const NurbsCurve& curve, double u, Side side) {
  ScatteredHalves one;
  Locator locator(curve, 0, side);
  const CurveHalf& half = locator.locate(u);
  one.u[0] = u;
  one.near[0] = half.near;
  one.far[0] = half.far;
  one.rows[0] = half.rows;
  one.step[0] = half.step;
  glm::dvec4 point;
  kernels().curve_homogeneous({curve.degree(), 0, curve.rational()}, one, 1, &point.x);
  return point;
}

/// Puts in order what is no number among the values at one parameter.
template <class Real>
void settle(const NurbsCurve& curve, double u, EvaluateOptions options, std::span<Real> values) {
  const auto is_number = [&](std::size_t k) {
    return std::isfinite(values[3 * k]) && std::isfinite(values[3 * k + 1]) && std::isfinite(values[3 * k + 2]);
  };
  for (std::size_t k = 0; 3 * k < values.size(); ++k) {
    if (is_number(k)) continue;
    const glm::dvec4 h = homogeneous_at(curve, u, options.side);
    const glm::dvec3 point = curve.rational() ? project(h) : glm::dvec3(h);
    const bool is_far = !is_finite(point);
    if (options.at_infinity == AtInfinity::raise && is_far) throw PointAtInfinity(u);
    if (options.at_infinity == AtInfinity::raise && k > 0) {
      throw InvalidShape("derivative " + std::to_string(k) + " at u = " + text_of(u) + " is too large for a number");
    }
    for (int axis = 0; axis < 3; ++axis) {
      values[3 * k + axis] = static_cast<Real>(k > 0 || is_far ? kNan : point[axis]);
    }
  }
}

/// Writes point and derivatives, up to the second, at each parameter.
template <class Real>
class Batch {
 public:
  Batch(const NurbsCurve& curve, int order, EvaluateOptions options, std::span<const double> u, std::span<Real> out)
      : curve_(curve), form_{curve.degree(), order, curve.rational()}, options_(options),
        locator_(curve, order, options.side), u_(u), out_(out), columns_(3 * (static_cast<std::size_t>(order) + 1)) {}

  void run() {
    constexpr std::size_t kMost = std::size_t{1} << 12;
    for (std::size_t i = 0; i < u_.size();) {
      const double at = curve_.knot_vector().admit(u_[i], options_.side, i);
      const CurveHalf& half = locator_.locate(at);
      const bool is_run = i + 3 < u_.size() && locator_.is_inside(u_[i]) && locator_.is_inside(u_[i + 1]) &&
                          locator_.is_inside(u_[i + 2]) && locator_.is_inside(u_[i + 3]);
      if (!is_run) {
        add(i++, at, half);
        continue;
      }
      flush();
      int found = 0;
      const auto part = u_.subspan(i, std::min(kMost, u_.size() - i));
      const std::size_t done =
          run_of(form_, half, locator_.low(), locator_.high(), part, out_.data() + columns_ * i, &found);
      breathe(done * columns_ * static_cast<std::size_t>(form_.degree + 2));
      if (found != 0) settle_all(i, i + done);
      i += done;
    }
    flush();
  }

 private:
  void add(std::size_t i, double at, const CurveHalf& half) {
    if (count_ == 0) first_ = i;
    halves_.u[count_] = at;
    halves_.near[count_] = half.near;
    halves_.far[count_] = half.far;
    halves_.rows[count_] = half.rows;
    halves_.step[count_] = half.step;
    if (++count_ == kScattered) flush();
  }

  void flush() {
    if (count_ == 0) return;
    breathe(count_ * columns_ * static_cast<std::size_t>(form_.degree + 2));
    const int found = scattered_of(form_, halves_, count_, out_.data() + columns_ * first_);
    if (found != 0) settle_all(first_, first_ + count_);
    count_ = 0;
  }

  void settle_all(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double at = curve_.knot_vector().admit(u_[i], options_.side, i);
      settle(curve_, at, options_, out_.subspan(columns_ * i, columns_));
    }
  }

  const NurbsCurve& curve_;
  CurveForm form_;
  EvaluateOptions options_;
  Locator locator_;
  std::span<const double> u_;
  std::span<Real> out_;
  std::size_t columns_;
  ScatteredHalves halves_;
  std::size_t count_ = 0;
  std::size_t first_ = 0;
};

/// Homogeneous derivatives 0 … order at an admitted parameter, and the quotient rule.
void derivatives_at(const NurbsCurve& curve, Stencil& at, std::span<glm::dvec4> homogeneous,
                    std::span<glm::dvec3> values) {
  const glm::dvec4* points = curve.homogeneous_points().data() + at.first();
  for (std::size_t k = 0; k < values.size(); ++k) {
    homogeneous[k] = weighted_sum(at.weights(static_cast<int>(k)), points);
    values[k] = glm::dvec3(homogeneous[k]);
  }
  if (curve.rational()) quotient_derivatives(homogeneous, values);
}

}  // namespace

void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out,
              EvaluateOptions options) {
  Batch<double>(curve, 0, options, parameters, out).run();
}

void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<float> out,
              EvaluateOptions options) {
  Batch<float>(curve, 0, options, parameters, out).run();
}

void derivatives(const NurbsCurve& curve, std::span<const double> parameters, int order,
                 std::span<double> out, EvaluateOptions options) {
  require_order(order);
  if (order <= kFastOrder) return Batch<double>(curve, order, options, parameters, out).run();
  const std::size_t columns = 3 * (static_cast<std::size_t>(order) + 1);
  const std::size_t fast = 3 * (kFastOrder + 1);
  std::vector<glm::dvec4> homogeneous(order + 1);
  std::vector<glm::dvec3> values(order + 1);
  Stencil at(curve.knot_vector(), order);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double u = curve.knot_vector().admit(parameters[i], options.side, i);
    at.move_to(u, options.side);
    derivatives_at(curve, at, homogeneous, values);
    const auto row = out.subspan(columns * i, columns);
    for (std::size_t k = 0; k < columns; ++k) row[k] = values[k / 3][static_cast<int>(k % 3)];
    // The lower ones are the same, bit for bit, whatever the order.
    Batch<double>(curve, kFastOrder, {options.side, AtInfinity::nan}, {&u, 1}, row.first(fast)).run();
    settle(curve, u, options, row);
  }
}

void evaluate_homogeneous(const NurbsCurve& curve, std::span<const double> parameters,
                          std::span<glm::dvec4> out, Side side) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    out[i] = homogeneous_at(curve, curve.knot_vector().admit(parameters[i], side, i), side);
  }
}

}  // namespace splinecore
