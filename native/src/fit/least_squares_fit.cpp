#include "least_squares_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "curve/rescale.hpp"
#include "gram.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "straight.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// The order of the derivative that smoothing keeps small.
constexpr int kBent = 2;

double largest_of(std::span<const double> values) { return kernels().largest_size(values.data(), values.size()); }

/// A power of two that brings the largest of them near 1.
double scale_of(double largest) {
  return largest > 0.0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000)) : 1.0;
}

/// The first index from `begin` on whose parameter is not before the end: by steps that double, for it is near.
std::size_t first_from(std::span<const double> parameters, std::size_t begin, double end) {
  std::size_t step = 1;
  while (begin + step <= parameters.size() && parameters[begin + step - 1] < end) {
    begin += step;
    step *= 2;
  }
  const auto last = parameters.begin() + static_cast<std::ptrdiff_t>(std::min(begin + step, parameters.size()));
  return static_cast<std::size_t>(std::lower_bound(parameters.begin() + static_cast<std::ptrdiff_t>(begin), last, end) -
                                  parameters.begin());
}

}  // namespace

LeastSquaresFit::LeastSquaresFit(KnotVector knots, std::span<const double> parameters, std::span<const double> weights,
                                 double smoothing, const Held& held, double shortest)
    : knots_(std::move(knots)), parameters_(parameters), weights_(weights), weight_scale_(scale_of(largest_of(weights))),
      smoothing_(smoothing), held_(held) {
  if (smoothing_ > 0.0) {
    const auto [exponent, near] = near_one(knots_);
    slope_.emplace(near, std::ldexp(shortest, -exponent));
    if (!slope_->has_products()) bending_ = bending_matrix(knots_.degree(), kBent);
    slope_factor_ = energy_of(std::ldexp(1.0, exponent));
  }
  place();
  require_points();
  add_products();
  if (slope_) require_energy_leaves_points();
}

void LeastSquaresFit::place() {
  const std::size_t spans = knots_.spans().size();
  ends_.reserve(spans);
  for (std::size_t s = 0; s + 1 < spans; ++s) {
    const std::size_t begin = s == 0 ? 0 : ends_[s - 1];
    ends_.push_back(first_from(parameters_, begin, knots_.span_interval(static_cast<int>(s)).end));
  }
  ends_.push_back(parameters_.size());
}

SpanParameters LeastSquaresFit::parameters_of(std::size_t span) const {
  const std::size_t begin = span == 0 ? 0 : ends_[span - 1];
  const std::size_t count = ends_[span] - begin;
  return {knots_.degree(), knots_.span_interval(static_cast<int>(span)), parameters_.subspan(begin, count),
          weights_.empty() ? weights_ : weights_.subspan(begin, count), weight_scale_};
}

/// Each control point that is not held needs a parameter of its own (Schoenberg and Whitney 1953). Of periodic
/// functions it is the solution that tells.
void LeastSquaresFit::require_points() const {
  if (knots_.periodic() || smoothing_ > 0.0) return;
  const auto chain = knots_.knots();
  const auto degree = static_cast<std::size_t>(knots_.degree());
  const std::size_t end = static_cast<std::size_t>(knots_.count()) - held_.end;
  std::size_t i = 0;
  for (std::size_t j = held_.start; j < end; ++j) {
    const bool is_first = chain[j] == chain[j + degree];
    const bool is_last = chain[j + 1] == chain[j + degree + 1];
    i = first_from(parameters_, i, chain[j]);
    if (i < parameters_.size() && parameters_[i] == chain[j] && !is_first) ++i;
    const bool is_there = i < parameters_.size() && (parameters_[i] < chain[j + degree + 1] ||
                                                     (is_last && parameters_[i] == chain[j + degree + 1]));
    if (!is_there) {
      throw InvalidShape("too few points have parameters between " + text_of(chain[j]) + " and " +
                         text_of(chain[j + degree + 1]) + " to decide about control point " + std::to_string(j) +
                         ": fewer control points or smoothing are needed");
    }
    ++i;
  }
}

/// Of the integral over a length of parameters, beside that over 1.
double LeastSquaresFit::energy_of(double length) const {
  const double share = smoothing_ * weight_scale_ / std::pow(length, 2 * kBent - 1);
  if (std::isfinite(share)) return share;
  throw InvalidShape("the weight of the energy, " + text_of(smoothing_) + ", is too large for knots so near");
}

void LeastSquaresFit::add_products() {
  const std::size_t width = this->width();
  products_.assign(static_cast<std::size_t>(knots_.count()) * width, 0.0);
  std::vector<double> sums(width * width);
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    const SpanParameters at = parameters_of(s);
    if (at.parameters.empty() && bending_.empty()) continue;
    breathe(2 * width * width * (width + at.parameters.size()));
    write_products(at, sums);
    const double energy = bending_.empty() ? 0.0 : energy_of(knots_.span_interval(static_cast<int>(s)).length());
    for (std::size_t a = 0; a < width; ++a) {
      for (std::size_t b = a; b < width; ++b) {
        if (!bending_.empty()) sums[a * width + b] += energy * bending_[a * width + b];
        sums[b * width + a] = sums[a * width + b];
      }
    }
    add_piece_products(knots_, s, sums, products_);
  }
  if (!slope_ || !bending_.empty()) return;
  const std::vector<double> energy = slope_->products();
  for (std::size_t k = 0; k < products_.size(); ++k) products_[k] += slope_factor_ * energy[k];
}

/// Of the control points that are not held.
BandedRows LeastSquaresFit::free_rows() const {
  const std::size_t width = this->width();
  const auto degree = static_cast<std::ptrdiff_t>(width) - 1;
  const auto count = static_cast<std::ptrdiff_t>(knots_.count());
  const auto begin = static_cast<std::ptrdiff_t>(held_.start);
  const std::ptrdiff_t end = count - static_cast<std::ptrdiff_t>(held_.end);
  BandedRows rows{2 * width - 1, {}, std::vector<double>(static_cast<std::size_t>(end - begin) * (2 * width - 1), 0.0)};
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    const std::ptrdiff_t reach = i - degree;
    const std::ptrdiff_t first = knots_.periodic() ? (reach % count + count) % count : std::max(reach, begin);
    rows.first.push_back(first - begin);
    const std::span<double> row = rows.row(static_cast<std::size_t>(i - begin));
    const std::ptrdiff_t skipped = knots_.periodic() ? 0 : first - reach;
    for (std::ptrdiff_t k = skipped; k < static_cast<std::ptrdiff_t>(row.size()); ++k) {
      const std::ptrdiff_t from = std::min(i, reach + k);
      if (!knots_.periodic() && reach + k >= end) break;
      const auto at = static_cast<std::size_t>((from % count + count) % count);
      row[static_cast<std::size_t>(k - skipped)] = products_[at * width + static_cast<std::size_t>(std::abs(degree - k))];
    }
  }
  return rows;
}

void LeastSquaresFit::bezier_points(std::size_t span, std::span<const double> controls, std::size_t columns,
                                    std::span<double> out) const {
  const std::size_t width = this->width();
  const auto count = static_cast<std::size_t>(knots_.count());
  const SquareRows matrix = knots_.bezier_matrix(static_cast<int>(span));
  const std::size_t first = first_of(span);
  std::ranges::fill(out, 0.0);
  for (std::size_t a = 0; a < width; ++a) {
    const double* const from = controls.data() + (first + a) % count * columns;
    for (std::size_t j = 0; j < width; ++j) {
      const double factor = matrix[j][a];
      for (std::size_t c = 0; c < columns; ++c) out[j * columns + c] += factor * from[c];
    }
  }
}

void LeastSquaresFit::add_bending(std::size_t columns, std::span<const double> controls, std::span<double> right) const {
  if (!slope_) return;
  const std::vector<double> slope = slope_->slope(controls, columns);
  for (std::size_t k = 0; k < right.size(); ++k) right[k] -= slope_factor_ * slope[k];
}

/// Half the gradient, downhill: each control point's sum of its function times what is left of the values.
/// @param write_sums  writes those of a span by its piece
template <class Sums>
void LeastSquaresFit::residual_sums(std::size_t columns, std::span<const double> controls, std::span<double> right,
                                    const Sums& write_sums) const {
  const std::size_t width = this->width();
  const auto count = static_cast<std::size_t>(knots_.count());
  std::vector<double> piece(width * columns);
  std::vector<double> sums(width * columns);
  std::ranges::fill(right, 0.0);
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    const SpanParameters at = parameters_of(s);
    if (at.parameters.empty()) continue;
    breathe(2 * width * (width + columns) * (width + at.parameters.size()));
    bezier_points(s, controls, columns, piece);
    write_sums(s, at, std::span<const double>(piece), std::span(sums));
    const SquareRows matrix = knots_.bezier_matrix(static_cast<int>(s));
    for (std::size_t a = 0; a < width; ++a) {
      double* const to = right.data() + (first_of(s) + a) % count * columns;
      for (std::size_t j = 0; j < width; ++j) {
        for (std::size_t c = 0; c < columns; ++c) to[c] += matrix[j][a] * sums[j * columns + c];
      }
    }
  }
  add_bending(columns, controls, right);
}

InvalidShape LeastSquaresFit::undetermined() const {
  if (!slope_) {
    return InvalidShape("the points do not determine the shape as far as numbers can tell: fewer control points, a lower "
                        "degree or smoothing are needed");
  }
  return InvalidShape("beside the energy of the shortest spans, smoothing = " + text_of(smoothing_) +
                      " leaves nothing of the points: knots farther from each other or less smoothing are needed");
}

/// Rows and columns by powers of two that bring the diagonal near 1, as pieces of very different lengths need.
std::vector<int> LeastSquaresFit::balance(BandedRows& rows) const {
  std::vector<int> exponents;
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const double own = products_[(i + held_.start) * width()];
    exponents.push_back(own > 0.0 ? -std::ilogb(own) / 2 : 0);
  }
  const auto count = static_cast<std::ptrdiff_t>(rows.count());
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const std::span<double> row = rows.row(i);
    for (std::ptrdiff_t k = 0; k < std::ssize(row); ++k) {
      const std::ptrdiff_t column = rows.first[i] + k;
      if (!knots_.periodic() && column >= count) break;
      double& value = row[static_cast<std::size_t>(k)];
      value = std::ldexp(value, exponents[i] + exponents[static_cast<std::size_t>(column % count)]);
    }
  }
  return exponents;
}

void LeastSquaresFit::solve_free(const BandedRows& rows, std::span<double> right, std::size_t columns) const {
  try {
    if (!slope_) return splinecore::solve(knots_, rows, right, columns);
    BandedRows balanced = rows;
    const std::vector<int> exponents = balance(balanced);
    const auto scale = [&] {
      for (std::size_t k = 0; k < right.size(); ++k) right[k] = std::ldexp(right[k], exponents[k / columns]);
    };
    scale();
    splinecore::solve(knots_, balanced, right, columns);
    scale();
  } catch (const InvalidShape&) {
    throw undetermined();
  }
}

/// What writes the sums of a span for values of `columns` numbers each.
auto LeastSquaresFit::rows_of(std::span<const double> values, std::size_t columns) const {
  return [this, values, columns](std::size_t s, const SpanParameters& at, std::span<const double> piece,
                                 std::span<double> sums) {
    const std::size_t begin = ends_[s] - at.parameters.size();
    write_residuals(at, values.subspan(begin * columns, at.parameters.size() * columns), columns, piece, sums);
  };
}

/// What bends nowhere is to come out of the system as it went in.
/// @throws InvalidShape if it does not.
void LeastSquaresFit::require_energy_leaves_points() const {
  const std::size_t columns = knots_.periodic() ? 1 : 2;  // 1 and the parameter
  const auto count = static_cast<std::size_t>(knots_.count());
  const std::vector<double> along = knots_.periodic() ? std::vector<double>() : straight_controls(knots_);
  std::vector<double> straight(count * columns, 0.0);
  for (std::size_t i = held_.start; i + held_.end < count; ++i) {
    straight[i * columns] = 1.0;
    if (columns > 1) straight[i * columns + 1] = along[i];
  }
  const std::size_t begin = held_.start * columns;
  const std::size_t free = (count - held_.start - held_.end) * columns;
  const std::vector<double> nothing(parameters_.size() * columns, 0.0);
  std::vector<double> left(straight.size());
  residual_sums(columns, straight, left, rows_of(nothing, columns));
  const std::span<double> found = std::span(left).subspan(begin, free);
  if (free > 0) solve_free(free_rows(), found, columns);
  for (std::size_t k = 0; k < free; ++k) {
    if (!(std::abs(found[k] + straight[begin + k]) <= kMostLost)) throw undetermined();
  }
}

/// @returns the largest change of a control point in the last round
template <class Sums>
double LeastSquaresFit::improve(std::size_t columns, double size, std::span<double> controls,
                                const Sums& write_sums) const {
  constexpr int kMostRounds = 6;
  constexpr double kDone = 1e-10;
  constexpr double kDetermined = 1e-6;
  const auto count = static_cast<std::size_t>(knots_.count());
  const std::size_t begin = held_.start * columns;
  const std::size_t free = (count - held_.start - held_.end) * columns;
  if (free == 0) return std::numeric_limits<double>::infinity();
  const BandedRows rows = free_rows();
  std::vector<double> right(count * columns);
  double change = 0.0;
  double share = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    residual_sums(columns, controls, right, write_sums);
    const std::span<double> correction = std::span(right).subspan(begin, free);
    solve_free(rows, correction, columns);
    for (std::size_t k = 0; k < free; ++k) controls[begin + k] += correction[k];
    change = largest_of(correction);
    share = change / std::max({largest_of(controls), size, std::numeric_limits<double>::min()});
    if (round > 0 && share <= kDone) return change;
  }
  if (share <= kDetermined) return change;
  throw undetermined();
}

void LeastSquaresFit::solve(std::span<const double> values, std::size_t columns, std::span<double> controls) const {
  improve(columns, largest_of(values), controls, rows_of(values, columns));
}

std::vector<double> LeastSquaresFit::solve_points(std::span<const double> points, std::span<double> controls) const {
  constexpr double kNothing = 0x1p-40;   // beside the largest distance
  constexpr double kRounding = 0x1p-47;  // beside the largest coordinate: that much is in distances anyway
  const double size = largest_of(points);
  const double scale = scale_of(size);
  std::vector<double> largest(ends_.size(), 0.0);
  const auto write_sums = [&](std::size_t s, const SpanParameters& at, std::span<const double> piece,
                              std::span<double> sums) {
    const std::size_t begin = ends_[s] - at.parameters.size();
    largest[s] = write_residuals(at, points.subspan(3 * begin, 3 * at.parameters.size()), piece, scale, sums);
  };
  // Distances are those before the last change, unless it is of no matter beside the largest.
  const double change = improve(3, size, controls, write_sums) * scale;
  const bool is_nothing = change * change <= kNothing * kNothing * *std::ranges::max_element(largest);
  if (!is_nothing && !(change <= kRounding * scale * size)) {
    std::vector<double> right(controls.size());
    residual_sums(3, controls, right, write_sums);
  }
  for (double& square : largest) square = std::sqrt(square) / scale;
  return largest;
}

}  // namespace splinecore
