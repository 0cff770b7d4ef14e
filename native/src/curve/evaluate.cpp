#include "splinecore/curve/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <string>

#include "base/call_memory.hpp"
#include "base/parallel.hpp"
#include "base/quotient.hpp"
#include "base/stored_point.hpp"
#include "basis/knot_tables.hpp"
#include "curve_tables.hpp"
#include "rescale.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

constexpr int kFastOrder = 2;

std::size_t run_of(const CurveForm& form, const CurveHalf& half, double low, double high, std::span<const double> u,
                   double* out, int* found) {
  return kernels().curve_run(form, half, low, high, u.data(), u.size(), out, found);
}

std::size_t run_of(const CurveForm& form, const CurveHalf& half, double low, double high, std::span<const double> u,
                   float* out, int* found) {
  return kernels().curve_run_single(form, half, low, high, u.data(), u.size(), out, found);
}

int scattered_of(const CurveForm& form, const ScatteredHalves& halves, std::size_t begin, std::size_t end, double* out) {
  return kernels().curve_scattered(form, halves, begin, end, out);
}

int scattered_of(const CurveForm& form, const ScatteredHalves& halves, std::size_t begin, std::size_t end, float* out) {
  return kernels().curve_scattered_single(form, halves, begin, end, out);
}

/// How many parameters are located together.
constexpr std::size_t kSome = 64;

/// Parameters that were located.
struct Located {
  ScatteredHalves halves;
  std::array<double, kSome> moved;
  std::array<std::int32_t, kSome> half;
  std::array<const double*, kSome> rows;
};

/// Finds the halves of spans that parameters lie in.
class Locator {
 public:
  Locator(const NurbsCurve& curve, int order, Side side)
      : curve_(curve), knots_(curve.knot_vector()), tables_(curve.tables()), domain_(knots_.domain()), order_(order),
        side_(side), halves_(knots_.tables().finder.halves(side)), all_rows_(tables_.all_rows(curve, order)),
        size_(tables_.size(order)) {}

  double admitted(double u, std::size_t i) const {
    return u > domain_.start && u < domain_.end ? u : knots_.admit(u, side_, i);
  }

  /// @param first  the number of the first parameter
  void locate(std::span<const double> u, std::size_t first, Located& found) const {
    found.halves = {u.data(), found.half.data(), halves_.ends(), all_rows_, size_, found.rows.data()};
    if (!kernels().are_between(domain_.start, domain_.end, u.data(), u.size())) {
      for (std::size_t i = 0; i < u.size(); ++i) found.moved[i] = admitted(u[i], first + i);
      found.halves.u = found.moved.data();
    }
    halves_.find_all(found.halves.u, u.size(), found.half.data());
    for (std::size_t i = 0; all_rows_ == nullptr && i < u.size(); ++i) found.rows[i] = rows(found.half[i]);
  }

  CurveHalf half_of(int half) const {
    const double* const ends = halves_.ends() + 2 * half;
    return {ends[0], ends[1], rows(half)};
  }

  /// The parameters of a half.
  Interval range(int half) const { return halves_.range(half); }

 private:
  const double* rows(int half) const {
    return all_rows_ != nullptr ? all_rows_ + static_cast<std::size_t>(half) * size_ : tables_.rows(curve_, half, order_);
  }

  const NurbsCurve& curve_;
  const KnotVector& knots_;
  CurveTables& tables_;
  Interval domain_;
  int order_;
  Side side_;
  const SpanHalves& halves_;
  const double* all_rows_;  ///< of all halves, size_ numbers each; or nullptr
  std::size_t size_;
};

/// Derivatives of any order at one parameter after the other. The domain is divided by a power of two about its length, so
/// that neither its powers nor the products of the quotient rule leave the numbers where derivatives do not.
class AnyOrder {
 public:
  AnyOrder(const NurbsCurve& curve, int order)
      : curve_(curve), near_(near_one(curve.knot_vector())), at_(near_.knots, order, memory_.resource()),
        homogeneous_(static_cast<std::size_t>(order) + 1, memory_.resource()),
        values_(homogeneous_.size(), memory_.resource()) {}

  /// Point and derivatives at a parameter that was admitted.
  std::span<const glm::dvec3> find(double u, Side side) {
    at_.move_to(std::ldexp(u, -near_.exponent), side);
    const glm::dvec4* points = curve_.homogeneous_points().data() + at_.first();
    for (std::size_t k = 0; k < values_.size(); ++k) {
      homogeneous_[k] = weighted_sum(at_.weights(static_cast<int>(k)), points);
      values_[k] = glm::dvec3(homogeneous_[k]);
    }
    if (curve_.rational()) quotient_derivatives(homogeneous_, values_);
    for (std::size_t k = 1; near_.exponent != 0 && k < values_.size(); ++k) {
      const int exponent = -near_.exponent * static_cast<int>(k);
      for (int axis = 0; axis < 3; ++axis) values_[k][axis] = std::ldexp(values_[k][axis], exponent);
    }
    return values_;
  }

 private:
  const NurbsCurve& curve_;
  ScaledKnots near_;
  CallMemory memory_;
  Stencil at_;
  std::pmr::vector<glm::dvec4> homogeneous_;
  std::pmr::vector<glm::dvec3> values_;
};

/// Puts in order what is no number among the values at one parameter. The kernels' sums are larger than the points by up
/// to 2^degree; those of a stencil are not.
template <class Real>
void settle(const NurbsCurve& curve, double u, EvaluateOptions options, std::span<Real> values) {
  const std::size_t count = values.size() / 3;
  const auto is_written = [&](std::size_t k) { return is_number(&values[3 * k]); };
  if (std::ranges::all_of(std::views::iota(std::size_t{0}, count), is_written)) return;
  AnyOrder derivatives_of(curve, static_cast<int>(count) - 1);
  const auto found = derivatives_of.find(u, options.side);
  const bool is_far = !is_finite(found[0]);
  if (is_far && options.at_infinity == AtInfinity::raise) throw PointAtInfinity(u);
  for (std::size_t k = 0; k < count; ++k) {
    if (is_written(k)) continue;
    if (!is_finite(found[k]) && options.at_infinity == AtInfinity::raise) {
      throw InvalidShape("derivative " + std::to_string(k) + " at u = " + text_of(u) + " is too large for a number");
    }
    store(is_finite(found[k]) ? found[k] : glm::dvec3(kNan), &values[3 * k]);
  }
}

/// Writes point and derivatives, up to the second, at each parameter.
template <class Real>
class Batch {
 public:
  Batch(const NurbsCurve& curve, int order, EvaluateOptions options, std::span<const double> u, std::span<Real> out)
      : curve_(curve), form_{curve.degree(), order, curve.rational()}, options_(options),
        locator_(curve, order, options.side), u_(u), out_(out), columns_(3 * (static_cast<std::size_t>(order) + 1)) {}

  /// Those from begin to end.
  void run(std::size_t begin, std::size_t end) {
    end_ = end;
    for (std::size_t i = begin; i < end;) {
      const std::size_t count = std::min(kSome, end - i);
      i += in_order_of_errors(i, count, [&](std::size_t first, std::size_t some) {
        locator_.locate(u_.subspan(first, some), first, found_);
        return advance(first, some);
      });
    }
  }

 private:
  /// Writes the values of the parameters that were located, from i on, and perhaps more; returns how many.
  std::size_t advance(std::size_t i, std::size_t count) {
    constexpr std::size_t kStep = 4;  // a run that begins between is found a little later
    std::size_t scattered = 0;
    for (std::size_t done = 0; done < count;) {
      const std::size_t run = begins_run(done, count) ? run_from(i + done, found_.half[done]) : 0;
      if (run > 0) {
        write_scattered(i, scattered, done);
        scattered = done + run;
      }
      done += run > 0 ? run : kStep;
    }
    write_scattered(i, scattered, count);
    return std::max(scattered, count);
  }

  /// Whether as many parameters as a kernel takes at once lie in one half.
  bool begins_run(std::size_t at, std::size_t count) const {
    const std::int32_t* const half = found_.half.data() + at;
    return at + lanes_ <= count && half[1] == half[0] &&
           std::ranges::all_of(half + 2, half + lanes_, [&](auto other) { return other == *half; });
  }

  /// As many parameters from i on as lie strictly inside a half, so many at once.
  std::size_t run_from(std::size_t i, int half) {
    constexpr std::size_t kMost = std::size_t{1} << 15;
    const auto part = u_.subspan(i, std::min(kMost, end_ - i));
    const Interval range = locator_.range(half);
    int found = 0;
    const std::size_t done =
        run_of(form_, locator_.half_of(half), range.start, range.end, part, out_.data() + columns_ * i, &found);
    breathe(done * columns_ * static_cast<std::size_t>(form_.degree + 2));
    if (found != 0) settle_all(i, i + done);
    return done;
  }

  /// Those from begin to end of the parameters that were located, of which the first is number i.
  void write_scattered(std::size_t i, std::size_t begin, std::size_t end) {
    if (begin >= end) return;
    breathe((end - begin) * columns_ * static_cast<std::size_t>(form_.degree + 2));
    const int found = scattered_of(form_, found_.halves, begin, end, out_.data() + columns_ * (i + begin));
    if (found != 0) settle_all(i + begin, i + end);
  }

  void settle_all(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      settle(curve_, locator_.admitted(u_[i], i), options_, out_.subspan(columns_ * i, columns_));
    }
  }

  const NurbsCurve& curve_;
  CurveForm form_;
  EvaluateOptions options_;
  Locator locator_;
  Located found_;
  std::span<const double> u_;
  std::span<Real> out_;
  std::size_t columns_;
  std::size_t lanes_ = kernels().lanes;
  std::size_t end_ = 0;
};

template <class Real>
void run_batch(const NurbsCurve& curve, int order, EvaluateOptions options, std::span<const double> u,
               std::span<Real> out) {
  const std::size_t steps = 3 * static_cast<std::size_t>((order + 1) * (curve.degree() + 2)) / kStepsAtOnce + 1;
  in_ranges(u.size(), steps, options.threads, [&](std::size_t begin, std::size_t end) {
    Batch<Real>(curve, order, options, u, out).run(begin, end);
  });
}

/// Derivatives of orders above those of the kernels, at the parameters from begin to end.
void high_derivatives(const NurbsCurve& curve, std::span<const double> parameters, std::size_t begin, std::size_t end,
                      int order, std::span<double> out, EvaluateOptions options) {
  const std::size_t columns = 3 * (static_cast<std::size_t>(order) + 1);
  constexpr std::size_t kFast = 3 * (kFastOrder + 1);
  AnyOrder derivatives_of(curve, order);
  for (std::size_t i = begin; i < end; ++i) {
    const double u = curve.knot_vector().admit(parameters[i], options.side, i);
    const auto values = derivatives_of.find(u, options.side);
    const auto row = out.subspan(columns * i, columns);
    for (std::size_t k = 0; k < columns; ++k) row[k] = values[k / 3][static_cast<int>(k % 3)];
    // The lower ones are the same, bit for bit, whatever the order.
    Batch<double>(curve, kFastOrder, {options.side, AtInfinity::nan}, {&u, 1}, row.first(kFast)).run(0, 1);
    settle(curve, u, options, row);
  }
}

}  // namespace

void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out,
              EvaluateOptions options) {
  run_batch(curve, 0, options, parameters, out);
}

void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<float> out,
              EvaluateOptions options) {
  run_batch(curve, 0, options, parameters, out);
}

void derivatives(const NurbsCurve& curve, std::span<const double> parameters, int order,
                 std::span<double> out, EvaluateOptions options) {
  require_order(order);
  if (order <= kFastOrder) return run_batch(curve, order, options, parameters, out);
  const std::size_t steps = 4 * static_cast<std::size_t>((order + 1) * (curve.degree() + order + 1));
  in_ranges(parameters.size(), steps, options.threads, [&](std::size_t begin, std::size_t end) {
    high_derivatives(curve, parameters, begin, end, order, out, options);
  });
}

void evaluate_homogeneous(const NurbsCurve& curve, std::span<const double> parameters,
                          std::span<glm::dvec4> out, Side side) {
  Stencil at(curve.knot_vector(), 0);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    at.move_to(curve.knot_vector().admit(parameters[i], side, i), side);
    out[i] = weighted_sum(at.weights(0), curve.homogeneous_points().data() + at.first());
  }
}

}  // namespace splinecore
