#include "least_squares_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "gram.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

/// All Bernstein polynomials of the degree row.size() - 1 at t (The NURBS Book, A1.3).
void write_bernstein(double t, std::span<double> row) {
  const double rest = 1.0 - t;
  row[0] = 1.0;
  for (std::size_t k = 1; k < row.size(); ++k) {
    double carried = 0.0;
    for (std::size_t j = 0; j < k; ++j) {
      const double value = row[j];
      row[j] = carried + rest * value;
      carried = t * value;
    }
    row[k] = carried;
  }
}

double largest_of(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// A power of two that brings the largest of them near 1.
double scale_of(std::span<const double> values) {
  const double largest = largest_of(values);
  return largest > 0.0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000)) : 1.0;
}

}  // namespace

LeastSquaresFit::LeastSquaresFit(KnotVector knots, std::span<const double> parameters, std::span<const double> weights,
                                 const Energy& energy, const Held& held)
    : knots_(std::move(knots)), parameters_(parameters), weights_(weights), weight_scale_(scale_of(weights)),
      energy_(energy), held_(held) {
  if (energy_.factor > 0.0) bending_ = bending_matrix(knots_.degree(), energy_.order);
  place();
  require_points();
  add_products();
}

void LeastSquaresFit::place() {
  const std::size_t spans = knots_.spans().size();
  ends_.reserve(spans);
  locals_.reserve(parameters_.size());
  std::size_t i = 0;
  for (std::size_t s = 0; s < spans; ++s) {
    const Interval at = knots_.span_interval(static_cast<int>(s));
    const bool is_last = s + 1 == spans;
    for (; i < parameters_.size() && (is_last || parameters_[i] < at.end); ++i) {
      locals_.push_back(std::clamp((parameters_[i] - at.start) / (at.end - at.start), 0.0, 1.0));
    }
    ends_.push_back(i);
  }
}

/// Each control point that is not held needs a parameter of its own (Schoenberg and Whitney 1953). Of periodic
/// functions it is the solution that tells.
void LeastSquaresFit::require_points() const {
  if (knots_.periodic() || energy_.factor > 0.0) return;
  const auto chain = knots_.knots();
  const auto degree = static_cast<std::size_t>(knots_.degree());
  const std::size_t end = static_cast<std::size_t>(knots_.count()) - held_.end;
  std::size_t i = 0;
  for (std::size_t j = held_.start; j < end; ++j) {
    const bool is_first = chain[j] == chain[j + degree];
    const bool is_last = chain[j + 1] == chain[j + degree + 1];
    while (i < parameters_.size() && (parameters_[i] < chain[j] || (parameters_[i] == chain[j] && !is_first))) ++i;
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

/// Of the integral over a span, beside that over [0, 1].
double LeastSquaresFit::energy_of(std::size_t span) const {
  const Interval at = knots_.span_interval(static_cast<int>(span));
  const double share = energy_.factor * weight_scale_ / std::pow(at.end - at.start, 2 * energy_.order - 1);
  if (std::isfinite(share)) return share;
  throw InvalidShape("the weight of the energy, " + text_of(energy_.factor) + ", is too large for knots so near");
}

void LeastSquaresFit::add_products() {
  const std::size_t width = this->width();
  const auto count = static_cast<std::size_t>(knots_.count());
  products_.assign(count * width, 0.0);
  std::vector<double> row(width);
  std::vector<double> sums(width * width);
  std::size_t i = 0;
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    if (i == ends_[s] && bending_.empty()) continue;
    breathe(2 * width * width * (width + ends_[s] - i));
    std::ranges::fill(sums, 0.0);
    for (; i < ends_[s]; ++i) {
      write_bernstein(locals_[i], row);
      for (std::size_t a = 0; a < width; ++a) {
        const double factor = weight(i) * row[a];
        for (std::size_t b = a; b < width; ++b) sums[a * width + b] += factor * row[b];
      }
    }
    const double energy = bending_.empty() ? 0.0 : energy_of(s);
    for (std::size_t a = 0; a < width; ++a) {
      for (std::size_t b = a; b < width; ++b) {
        if (!bending_.empty()) sums[a * width + b] += energy * bending_[a * width + b];
        sums[b * width + a] = sums[a * width + b];
      }
    }
    add_piece_products(knots_, s, sums, products_);
  }
}

/// Of the control points that are not held.
BandedRows LeastSquaresFit::free_rows() const {
  const std::size_t width = this->width();
  const auto degree = static_cast<long>(width) - 1;
  const auto count = static_cast<long>(knots_.count());
  const auto begin = static_cast<long>(held_.start);
  const long end = count - static_cast<long>(held_.end);
  BandedRows rows{2 * width - 1, {}, std::vector<double>(static_cast<std::size_t>(end - begin) * (2 * width - 1), 0.0)};
  for (long i = begin; i < end; ++i) {
    const long reach = i - degree;
    const long first = knots_.periodic() ? (reach % count + count) % count : std::max(reach, begin);
    rows.first.push_back(first - begin);
    const std::span<double> row = rows.row(static_cast<std::size_t>(i - begin));
    const long skipped = knots_.periodic() ? 0 : first - reach;
    for (long k = skipped; k < static_cast<long>(row.size()); ++k) {
      const long from = std::min(i, reach + k);
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
  const auto first = static_cast<std::size_t>(knots_.spans()[span]) - (width - 1);
  std::ranges::fill(out, 0.0);
  for (std::size_t a = 0; a < width; ++a) {
    const double* const from = controls.data() + (first + a) % count * columns;
    for (std::size_t j = 0; j < width; ++j) {
      const double factor = matrix[j][a];
      for (std::size_t c = 0; c < columns; ++c) out[j * columns + c] += factor * from[c];
    }
  }
}

/// Half the gradient, downhill: each control point's sum of its function times what is left of the values.
void LeastSquaresFit::residual_sums(std::span<const double> values, std::size_t columns,
                                    std::span<const double> controls, std::span<double> right) const {
  const std::size_t width = this->width();
  const auto count = static_cast<std::size_t>(knots_.count());
  std::vector<double> row(width);
  std::vector<double> piece(width * columns);
  std::vector<double> sums(width * columns);
  std::vector<double> left(columns);
  std::ranges::fill(right, 0.0);
  std::size_t i = 0;
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    if (i == ends_[s] && bending_.empty()) continue;
    breathe(2 * width * (width + columns) * (width + ends_[s] - i));
    bezier_points(s, controls, columns, piece);
    std::ranges::fill(sums, 0.0);
    for (; i < ends_[s]; ++i) {
      write_bernstein(locals_[i], row);
      const double* const value = values.data() + i * columns;
      for (std::size_t c = 0; c < columns; ++c) left[c] = value[c];
      for (std::size_t j = 0; j < width; ++j) {
        for (std::size_t c = 0; c < columns; ++c) left[c] -= row[j] * piece[j * columns + c];
      }
      for (std::size_t j = 0; j < width; ++j) {
        const double factor = weight(i) * row[j];
        for (std::size_t c = 0; c < columns; ++c) sums[j * columns + c] += factor * left[c];
      }
    }
    // What all points of a piece have in common has no energy.
    const double energy = bending_.empty() ? 0.0 : energy_of(s);
    for (std::size_t j = 0; j < width && !bending_.empty(); ++j) {
      for (std::size_t l = 0; l < width; ++l) {
        const double factor = energy * bending_[j * width + l];
        for (std::size_t c = 0; c < columns; ++c) sums[j * columns + c] -= factor * (piece[l * columns + c] - piece[c]);
      }
    }
    const SquareRows matrix = knots_.bezier_matrix(static_cast<int>(s));
    const auto first = static_cast<std::size_t>(knots_.spans()[s]) - (width - 1);
    for (std::size_t a = 0; a < width; ++a) {
      double* const to = right.data() + (first + a) % count * columns;
      for (std::size_t j = 0; j < width; ++j) {
        for (std::size_t c = 0; c < columns; ++c) to[c] += matrix[j][a] * sums[j * columns + c];
      }
    }
  }
}

void LeastSquaresFit::solve(std::span<const double> values, std::size_t columns, std::span<double> controls) const {
  constexpr int kMostRounds = 6;
  constexpr double kDone = 1e-10;
  constexpr double kDetermined = 1e-6;
  const auto count = static_cast<std::size_t>(knots_.count());
  const std::size_t begin = held_.start * columns;
  const std::size_t free = (count - held_.start - held_.end) * columns;
  if (free == 0) return;
  const BandedRows rows = free_rows();
  const double size = largest_of(values);
  std::vector<double> right(count * columns);
  double share = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    residual_sums(values, columns, controls, right);
    const std::span<double> correction = std::span(right).subspan(begin, free);
    splinecore::solve(knots_, rows, correction, columns);
    for (std::size_t k = 0; k < free; ++k) controls[begin + k] += correction[k];
    share = largest_of(correction) / std::max({largest_of(controls), size, std::numeric_limits<double>::min()});
    if (round > 0 && share <= kDone) return;
  }
  if (share <= kDetermined) return;
  throw InvalidShape("the points do not determine the shape as far as numbers can tell: fewer control points, a lower degree or "
                     "smoothing are needed");
}

std::vector<double> LeastSquaresFit::largest_distances(std::span<const double> values, std::span<const double> controls,
                                                       std::span<double> distances) const {
  constexpr std::size_t kColumns = 3;
  const std::size_t width = this->width();
  const double scale = scale_of(values);
  std::vector<double> row(width);
  std::vector<double> piece(width * kColumns);
  std::vector<double> largest(ends_.size(), 0.0);
  std::size_t i = 0;
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    if (i == ends_[s]) continue;
    breathe(2 * width * (width + kColumns) * (width + ends_[s] - i));
    bezier_points(s, controls, kColumns, piece);
    for (; i < ends_[s]; ++i) {
      write_bernstein(locals_[i], row);
      double square = 0.0;
      for (std::size_t c = 0; c < kColumns; ++c) {
        double left = values[i * kColumns + c];
        for (std::size_t j = 0; j < width; ++j) left -= row[j] * piece[j * kColumns + c];
        square += (left * scale) * (left * scale);
      }
      const double distance = std::sqrt(square) / scale;
      if (!distances.empty()) distances[i] = distance;
      largest[s] = std::max(largest[s], distance);
    }
  }
  return largest;
}

}  // namespace splinecore
