#include "distance_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Numbers that are multiplied together.
constexpr std::size_t kLanes = 4;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

/// The least of second differences, and the largest size.
struct Differences {
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

// A curve is a single row here: neighbours in a row are computed together.
DistanceForm::DistanceForm(std::size_t rows, std::size_t columns)
    : rows_(columns == 1 ? 1 : rows), columns_(columns == 1 ? rows : columns),
      stride_((columns_ + kLanes - 1) / kLanes * kLanes), width_(columns_ + stride_), scaled_(4 * rows_ * stride_),
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
  std::ranges::fill(squares_, 0.0);
  std::ranges::fill(weights_, 0.0);
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t k = i; k < rows_; ++k) {
      const double factor = i == k ? 1.0 : 2.0;
      for (std::size_t j = 0; j < columns_; ++j) {
        const double* const own = scaled_.data() + i * stride_ + j;
        const double x = factor * own[0];
        const double y = factor * own[plane];
        const double z = factor * own[2 * plane];
        const double w = factor * own[3 * plane];
        double* const squares = squares_.data() + (i + k) * width_ + j;
        double* const weights = weights_.data() + (i + k) * width_ + j;
        for (std::size_t l = 0; l < stride_; l += kLanes) {
          const double* const other = scaled_.data() + k * stride_ + l;
          Lanes ox, oy, oz, ow, square, weight;
          std::memcpy(&ox, other, sizeof ox);
          std::memcpy(&oy, other + plane, sizeof oy);
          std::memcpy(&oz, other + 2 * plane, sizeof oz);
          std::memcpy(&ow, other + 3 * plane, sizeof ow);
          std::memcpy(&square, squares + l, sizeof square);
          std::memcpy(&weight, weights + l, sizeof weight);
          square += x * ox + y * oy + z * oz;
          weight += w * ow;
          std::memcpy(squares + l, &square, sizeof square);
          std::memcpy(weights + l, &weight, sizeof weight);
        }
      }
    }
  }
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    squares_[i] *= shares_[i];
    weights_[i] *= shares_[i];
  }
}

double DistanceForm::rounding(double s) const noexcept {
  constexpr double kRounding = 0x1p-50;
  return kRounding * (largest_square_ + s * largest_weight_);
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
  Differences along_v;
  for (std::size_t i = 0; i < rows; ++i) {
    const double* const at = sums + i * width_;
    for (std::size_t j = 0; j + 2 < columns; ++j) along_v.add(at[j + 2] - at[j + 1] - (at[j + 1] - at[j]));
  }
  if (!(along_v.least > error)) return false;
  Differences along_u;
  for (std::size_t i = 0; i + 2 < rows; ++i) {
    const double* const at = sums + i * width_;
    const double* const next = at + width_;
    for (std::size_t j = 0; j < columns; ++j) along_u.add(next[j + width_] - next[j] - (next[j] - at[j]));
  }
  if (!(along_u.least > error)) return false;
  Differences mixed;
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
