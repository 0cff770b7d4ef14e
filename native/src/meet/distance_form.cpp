#include "distance_form.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/rounding.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Rows are filled up to so many numbers, which are computed together.
constexpr std::size_t kLanes = 4;

/// The least of second differences, and the largest size.
struct SecondDifferences {
  double least = std::numeric_limits<double>::infinity();
  double size = 0.0;

  void add(double difference) noexcept {
    least = std::min(least, difference);
    size = std::max(size, std::abs(difference));
  }
};

/// Whether a polynomial first falls and then rises, or does one of both: its derivative changes sign as often as its
/// coefficients at most. A single one may have any sign.
bool turns_once(const double* coefficients, std::size_t count, std::size_t step, double error) noexcept {
  std::size_t i = 0;
  const auto difference = [&](std::size_t k) { return coefficients[(k + 1) * step] - coefficients[k * step]; };
  while (i + 1 < count && difference(i) < -error) ++i;
  if (i + 1 < count && !(difference(i) > error)) ++i;
  while (i + 1 < count && difference(i) > error) ++i;
  return i + 1 >= count;
}

}  // namespace

// A curve is a single row here: neighbors in a row are computed together.
DistanceForm::DistanceForm(std::size_t rows, std::size_t columns)
    : rows_(columns == 1 ? 1 : rows), columns_(columns == 1 ? rows : columns),
      stride_((columns_ + kLanes - 1) / kLanes * kLanes), width_(columns_ + stride_), scaled_(4 * rows_ * stride_), row_(columns_),
      squares_((2 * rows_ - 1) * width_), weights_(squares_.size()), sums_(squares_.size()) {
  const int p = static_cast<int>(rows_) - 1;
  const int q = static_cast<int>(columns_) - 1;
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= q; ++j) choices_.push_back(binomial(p, i) * binomial(q, j));
  }
  shares_.assign(squares_.size(), 0.0);
  for (int i = 0; i <= 2 * p; ++i) {
    for (int j = 0; j <= 2 * q; ++j) shares_[i * width_ + j] = 1.0 / (binomial(2 * p, i) * binomial(2 * q, j));
  }
}

void DistanceForm::set(const glm::dvec4* net, const glm::dvec3& point) noexcept {
  if (rows_ > 1) return set_rows(net, point);
  columns_ == 4 ? set_row<4>(net, point) : set_row<0>(net, point);
}

void DistanceForm::set_rows(const glm::dvec4* net, const glm::dvec3& point) noexcept {
  const std::size_t plane = rows_ * stride_;
  largest_square_ = 0.0;
  largest_weight_ = 0.0;
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t j = 0; j < columns_; ++j) {
      const glm::dvec4& h = net[i * columns_ + j];
      const double choice = choices_[i * columns_ + j];
      const glm::dvec3 offset = glm::dvec3(h) - h.w * point;
      largest_square_ = std::max(largest_square_, offset.x * offset.x + offset.y * offset.y + offset.z * offset.z);
      largest_weight_ = std::max(largest_weight_, h.w * h.w);
      double* const to = scaled_.data() + i * stride_ + j;
      to[0] = choice * offset.x;
      to[plane] = choice * offset.y;
      to[2 * plane] = choice * offset.z;
      to[3 * plane] = choice * h.w;
    }
  }
  multiply_rows();
}

/// kColumns is the number of control points, or 0 for any.
template <std::size_t kColumns>
void DistanceForm::set_row(const glm::dvec4* net, const glm::dvec3& point) noexcept {
  const std::size_t columns = kColumns > 0 ? kColumns : columns_;
  glm::dvec4* const scaled = row_.data();
  double largest_square = 0.0;
  double largest_weight = 0.0;
  for (std::size_t j = 0; j < columns; ++j) {
    const glm::dvec4& h = net[j];
    const glm::dvec3 offset = glm::dvec3(h) - h.w * point;
    largest_square = std::max(largest_square, glm::dot(offset, offset));
    largest_weight = std::max(largest_weight, h.w * h.w);
    scaled[j] = choices_[j] * glm::dvec4(offset, h.w);
  }
  largest_square_ = largest_square;
  largest_weight_ = largest_weight;
  const double* const shares = shares_.data();
  double* const squares = squares_.data();
  double* const weights = weights_.data();
  for (std::size_t k = 0; k < 2 * columns - 1; ++k) {
    glm::dvec4 sum(0.0);
    for (std::size_t j = k < columns ? 0 : k - columns + 1; 2 * j < k; ++j) sum += scaled[j] * scaled[k - j];
    sum += sum;
    if (k % 2 == 0) sum += scaled[k / 2] * scaled[k / 2];
    squares[k] = (sum.x + sum.y + sum.z) * shares[k];
    weights[k] = sum.w * shares[k];
  }
}

void DistanceForm::multiply_rows() noexcept {
  std::ranges::fill(squares_, 0.0);
  std::ranges::fill(weights_, 0.0);
  const SquareForm form{static_cast<int>(rows_), static_cast<int>(columns_), stride_, width_};
  kernels().square_sums(form, scaled_.data(), squares_.data(), weights_.data());
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    squares_[i] *= shares_[i];
    weights_[i] *= shares_[i];
  }
}

double DistanceForm::rounding(double s) const noexcept {
  return kRoundingOfStep * (largest_square_ + s * largest_weight_);
}

bool DistanceForm::is_farther(double s) const noexcept {
  const double least = rounding(s);
  for (std::size_t i = 0; i < 2 * rows_ - 1; ++i) {
    for (std::size_t j = i * width_; j < i * width_ + 2 * columns_ - 1; ++j) {
      if (!(squares_[j] - s * weights_[j] >= least)) return false;
    }
  }
  return true;
}

bool DistanceForm::is_least(double s, double u, double v) noexcept {
  const double error = 2.0 * rounding(s);
  for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] = squares_[k] - s * weights_[k];
  const std::size_t columns = 2 * columns_ - 1;
  if (rows_ == 1) return turns_once(sums_.data(), columns, 1, error);
  const std::size_t rows = 2 * rows_ - 1;
  if (u == 0.0 || u == 1.0) {
    const double sign = u == 0.0 ? 1.0 : -1.0;
    const std::size_t side = u == 0.0 ? 0 : (rows - 1) * width_;
    bool rises = true;
    for (std::size_t i = 0; rises && i + 1 < rows; ++i) {
      const double* const row = sums_.data() + i * width_;
      for (std::size_t j = 0; j < columns; ++j) rises = rises && sign * (row[j + width_] - row[j]) > error;
    }
    if (rises && turns_once(sums_.data() + side, columns, 1, error)) return true;
  }
  if (v == 0.0 || v == 1.0) {
    const double sign = v == 0.0 ? 1.0 : -1.0;
    const std::size_t side = v == 0.0 ? 0 : columns - 1;
    bool rises = true;
    for (std::size_t i = 0; rises && i < rows; ++i) {
      const double* const row = sums_.data() + i * width_;
      for (std::size_t j = 0; j + 1 < columns; ++j) rises = rises && sign * (row[j + 1] - row[j]) > error;
    }
    if (rises && turns_once(sums_.data() + side, rows, width_, error)) return true;
  }
  return is_convex(2.0 * error);
}

bool DistanceForm::is_convex(double error) const noexcept {
  const std::size_t rows = 2 * rows_ - 1;
  const std::size_t columns = 2 * columns_ - 1;
  const double* const sums = sums_.data();
  SecondDifferences along_v;
  for (std::size_t i = 0; i < rows; ++i) {
    const double* const at = sums + i * width_;
    for (std::size_t j = 0; j + 2 < columns; ++j) along_v.add(at[j + 2] - at[j + 1] - (at[j + 1] - at[j]));
  }
  if (!(along_v.least > error)) return false;
  SecondDifferences along_u;
  for (std::size_t i = 0; i + 2 < rows; ++i) {
    const double* const at = sums + i * width_;
    const double* const next = at + width_;
    for (std::size_t j = 0; j < columns; ++j) along_u.add(next[j + width_] - next[j] - (next[j] - at[j]));
  }
  if (!(along_u.least > error)) return false;
  SecondDifferences mixed;
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    const double* const at = sums + i * width_;
    const double* const next = at + width_;
    for (std::size_t j = 0; j + 1 < columns; ++j) mixed.add(next[j + 1] - next[j] - (at[j + 1] - at[j]));
  }
  // Second derivatives are these times n (n - 1), m (m - 1) and n m.
  const double n = static_cast<double>(rows) - 1.0;
  const double m = static_cast<double>(columns) - 1.0;
  const double twist = mixed.size + error;
  return (n - 1.0) * (m - 1.0) * (along_u.least - error) * (along_v.least - error) > n * m * twist * twist;
}

}  // namespace splinecore
