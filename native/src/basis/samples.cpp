#include "splinecore/basis/samples.hpp"

#include <algorithm>
#include <cmath>

#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

Stencil::Stencil(const KnotVector& knots, int order)
    : knots_(knots), order_(order), size_(knots.degree() + 1), bernstein_(size_),
      weights_(size_ * (order + 1)) {}

void Stencil::move_to(double u, Side side) {
  const int degree = static_cast<int>(size_) - 1;
  const int span = knots_.span_of(u, side);
  const Interval range = knots_.span_interval(span);
  const double t = (u - range.start) / range.length();
  const double s = (range.end - u) / range.length();
  const double* matrix = knots_.bezier_matrix(span).data();
  first_ = knots_.spans()[span] - degree;
  std::ranges::fill(weights_, 0.0);
  double scale = 1.0;
  for (int k = 0; k <= std::min(order_, degree); ++k, scale /= range.length()) {
    bernstein_derivatives(degree, k, t, s, bernstein_);
    double* out = weights_.data() + k * size_;
    for (std::size_t j = 0; j < size_; ++j) {
      const double value = bernstein_[j] * scale;
      if (value == 0.0) continue;
      for (std::size_t i = 0; i < size_; ++i) out[i] += value * matrix[j * size_ + i];
    }
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
