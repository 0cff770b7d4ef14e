#include "splinecore/basis/samples.hpp"

#include <algorithm>
#include <array>

#include "axis_places.hpp"
#include "blossom.hpp"
#include "span_tables.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

constexpr int kTables = 2;

/// The weights of derivatives that no table has. *start is the knot at which the span begins.
void write_high_orders(const double* start, int degree, int order, double u, std::size_t width, double* weights) {
  if (order <= kTables) return;
  std::array<double, kMaxDegree> arguments;
  std::fill_n(arguments.begin(), degree, u);
  for (int k = kTables + 1; k <= order; ++k) {
    double* const row = weights + k * width;
    std::fill_n(row, width, 0.0);
    if (k > degree) continue;
    const std::span<const double> some = std::span(arguments).first(degree - k);
    blossom_weights(start - (degree - k), degree - k, some, row);
    differentiate(start, degree - k, {row, static_cast<std::size_t>(degree) + 1});
  }
}

/// Those from number i on.
ScatteredSpans from(ScatteredSpans places, std::size_t i) {
  places.u += i;
  places.span += i;
  places.rows += i;
  return places;
}

}  // namespace

Samples Samples::make(const KnotVector& knots, std::span<const double> parameters, int order,
                      std::span<const Side> sides, const char* name, std::pmr::memory_resource* memory) {
  Samples samples(memory);
  samples.size_of_weights_ = knots.degree() + 1;
  samples.width_ = table_width(knots.degree());
  samples.order_ = order;
  samples.places_.reserve(parameters.size());
  const std::size_t row = samples.width_ * (static_cast<std::size_t>(order) + 1);
  samples.weights_.resize(parameters.size() * row);
  AxisPlaces places(knots, std::min(order, kTables), name);
  const auto side_at = [&](std::size_t i) { return sides[sides.size() == 1 ? 0 : i]; };
  for (std::size_t begin = 0, end = 0; begin < parameters.size(); begin = end) {
    const Side side = side_at(begin);
    for (end = begin + 1; end < std::min(begin + AxisPlaces::kMost, parameters.size()) && side_at(end) == side;) ++end;
    const ScatteredSpans& found = places.locate(parameters.subspan(begin, end - begin), begin, side);
    breathe((end - begin) * (4 * static_cast<std::size_t>(order) + 1) * samples.width_ * samples.width_);
    for (std::size_t i = 0; i < end - begin; ++i) {
      samples.places_.push_back({places.parameter(i), side, places.first(i)});
    }
    double* const weights = samples.weights_.data() + begin * row;
    if (order <= kTables) {
      kernels().functions(knots.degree(), order, found, end - begin, weights);
      continue;
    }
    for (std::size_t i = 0; i < end - begin; ++i) {
      const double* start = knots.unrolled().data() + places.first(i) + knots.degree();
      kernels().functions(knots.degree(), kTables, from(found, i), 1, weights + i * row);
      write_high_orders(start, knots.degree(), order, places.parameter(i), samples.width_, weights + i * row);
    }
  }
  return samples;
}

Stencil::Stencil(const KnotVector& knots, int order, std::pmr::memory_resource* memory)
    : knots_(knots), order_(order), size_(knots.degree() + 1), width_(table_width(knots.degree())),
      weights_(width_ * (order + 1), memory) {}

void Stencil::move_to(double u, Side side) {
  breathe((4 * static_cast<std::size_t>(order_) + 1) * size_ * size_);
  AxisPlaces places(knots_, std::min(order_, kTables), "u");
  const ScatteredSpans& found = places.locate({&u, 1}, 0, side);
  first_ = places.first(0);
  const int degree = knots_.degree();
  kernels().functions(degree, std::min(order_, kTables), found, 1, weights_.data());
  write_high_orders(knots_.unrolled().data() + first_ + degree, degree, order_, u, width_, weights_.data());
}

}  // namespace splinecore
