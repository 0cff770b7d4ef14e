#include "splinecore/basis/samples.hpp"

#include <algorithm>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/blossom.hpp"

namespace splinecore {

namespace {

/// From the functions of a lower degree at u up to weights.size() of them, differentiated at each
/// step. *start is the knot at which the span of u begins. Only steps between knots that a function
/// covers divide, so a short span costs no digits (The NURBS Book, A2.3).
void derivative_weights(const double* start, double u, int lower, std::span<double> weights) {
  const std::vector<double> arguments(lower, u);
  blossom_weights(start - lower, lower, arguments, weights.data());
  const int degree = static_cast<int>(weights.size()) - 1;
  for (int p = lower + 1; p <= degree; ++p) {
    double carried = 0.0;
    for (int j = 0; j < p; ++j) {
      const double slope = p * weights[j] / (start[j + 1] - start[j + 1 - p]);
      weights[j] = carried - slope;
      carried = slope;
    }
    weights[p] = carried;
  }
}

}  // namespace

Stencil::Stencil(const KnotVector& knots, int order)
    : knots_(knots), order_(order), size_(knots.degree() + 1), bernstein_(size_),
      weights_(size_ * (order + 1)) {}

void Stencil::move_to(double u, Side side) {
  breathe((4 * static_cast<std::size_t>(order_) + 1) * size_ * size_);
  const int degree = static_cast<int>(size_) - 1;
  const int span = knots_.span_of(u, side);
  first_ = knots_.spans()[span] - degree;
  const Interval range = knots_.span_interval(span);
  bernstein(degree, (u - range.start) / range.length(), (range.end - u) / range.length(), bernstein_);
  const double* matrix = knots_.bezier_matrix(span).data();
  std::ranges::fill(weights_, 0.0);
  for (std::size_t j = 0; j < size_; ++j) {
    if (bernstein_[j] == 0.0) continue;
    for (std::size_t i = 0; i < size_; ++i) weights_[i] += bernstein_[j] * matrix[j * size_ + i];
  }
  const double* start = knots_.unrolled().data() + knots_.spans()[span];
  for (int k = 1; k <= std::min(order_, degree); ++k) {
    derivative_weights(start, u, degree - k, {weights_.data() + k * size_, size_});
  }
}

Samples Samples::make(const KnotVector& knots, std::span<const double> parameters, int order,
                      std::span<const Side> sides, const char* name) {
  Samples samples;
  samples.width_ = knots.degree() + 1;
  samples.order_ = order;
  samples.places_.reserve(parameters.size());
  samples.weights_.reserve(parameters.size() * (order + 1) * samples.width_);
  Stencil stencil(knots, order);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Side side = sides[sides.size() == 1 ? 0 : i];
    const double u = knots.admit(parameters[i], side, i, name);
    stencil.move_to(u, side);
    samples.places_.push_back({u, side, stencil.first()});
    for (int k = 0; k <= order; ++k) {
      const auto weights = stencil.weights(k);
      samples.weights_.insert(samples.weights_.end(), weights.begin(), weights.end());
    }
  }
  return samples;
}

}  // namespace splinecore
