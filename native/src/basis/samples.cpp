#include "splinecore/basis/samples.hpp"

#include <algorithm>

#include "basis_place.hpp"
#include "span_tables.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/blossom.hpp"

namespace splinecore {

Stencil::Stencil(const KnotVector& knots, int order)
    : knots_(knots), order_(order), size_(knots.degree() + 1), width_(table_width(knots.degree())),
      weights_(width_ * (order + 1)) {}

void Stencil::move_to(double u, Side side) {
  constexpr int kTables = 2;
  breathe((4 * static_cast<std::size_t>(order_) + 1) * size_ * size_);
  const int degree = knots_.degree();
  const int span = knots_.span_of(u, side);
  first_ = knots_.spans()[span] - degree;
  const BasisPlace place = place_in(knots_, span, u, std::min(order_, kTables));
  kernels().functions(degree, std::min(order_, kTables), &place, 1, weights_.data());
  const double* start = knots_.unrolled().data() + knots_.spans()[span];
  for (int k = kTables + 1; k <= std::min(order_, degree); ++k) {
    const std::vector<double> arguments(degree - k, u);
    double* const weights = weights_.data() + k * width_;
    std::fill_n(weights, width_, 0.0);
    blossom_weights(start - (degree - k), degree - k, arguments, weights);
    differentiate(start, degree - k, {weights, size_});
  }
}

Samples Samples::make(const KnotVector& knots, std::span<const double> parameters, int order,
                      std::span<const Side> sides, const char* name) {
  Samples samples;
  samples.size_of_weights_ = knots.degree() + 1;
  samples.width_ = table_width(knots.degree());
  samples.order_ = order;
  samples.places_.reserve(parameters.size());
  samples.weights_.reserve(parameters.size() * (order + 1) * samples.width_);
  Stencil stencil(knots, order);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Side side = sides[sides.size() == 1 ? 0 : i];
    const double u = knots.admit(parameters[i], side, i, name);
    stencil.move_to(u, side);
    samples.places_.push_back({u, side, stencil.first()});
    const auto weights = stencil.all_weights();
    samples.weights_.insert(samples.weights_.end(), weights.begin(), weights.end());
  }
  return samples;
}

}  // namespace splinecore
