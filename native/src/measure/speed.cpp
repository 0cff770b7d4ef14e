#include "speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/rounding.hpp"
#include "kronrod_31.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

constexpr const auto& kNodes = kKronrod31;
/// Both halves: the middle is there twice, but counts once.
constexpr std::size_t kCount = 2 * kNodes.size();

struct NodeShares {
  std::array<double, kCount> kronrod{};
  std::array<double, kCount> differences{};
};

constexpr NodeShares kShares = [] {
  NodeShares shares;
  for (std::size_t i = 0; i < kCount; ++i) {
    const KronrodNode& node = kNodes[i < kNodes.size() ? i : kCount - 1 - i];
    if (i == kNodes.size()) continue;
    shares.kronrod[i] = node.kronrod;
    shares.differences[i] = node.kronrod - node.gauss;
  }
  return shares;
}();

/// Writes the Bernstein polynomials of a degree at all nodes, one after the other.
void write_functions(int degree, double* out) {
  std::array<double, 2 * kMaxDegree + 1> values;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const double t = kNodes[i].at;
    bernstein(degree, t, 1.0 - t, values);
    for (int k = 0; k <= degree; ++k) {
      out[k * kCount + i] = values[k];
      out[k * kCount + kCount - 1 - i] = values[degree - k];
    }
  }
}

double size_of(const glm::dvec4& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }
double dot(const glm::dvec4& a, const glm::dvec4& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

void SpeedPiece::cut(double t, SpeedPiece& after) {
  slopes.cut(Axis::u, t, after.slopes);
  for (glm::dvec4& slope : slopes.values) slope *= t;
  for (glm::dvec4& slope : after.slopes.values) slope *= 1.0 - t;
  if (weights.rows > 1) {
    weights.cut(Axis::u, t, after.weights);
  } else {
    after.weights = weights;
  }
}

bool SpeedPiece::is_regular() const {
  glm::dvec4 direction(0.0);
  double largest = 0.0;
  double terms = 0.0;
  for (const glm::dvec4& slope : slopes.values) {
    direction += slope;
    largest = std::max(largest, size_of(slope));
    terms = std::max(terms, slope.w);
  }
  const double rounding = kRoundingOfSum * terms;
  if (largest <= rounding) return true;
  if (size_of(direction) <= rounding) return false;
  return std::ranges::all_of(slopes.values, [&](const glm::dvec4& slope) { return dot(slope, direction) >= 0.0; });
}

bool SpeedPiece::is_even() const {
  constexpr double kMost = 16.0;
  const auto [low, high] = weights.range();
  return low > 0.0 ? high <= kMost * low : high < 0.0 && low >= kMost * high;
}

void SpeedPiece::normalize() {
  constexpr int kNear = 100;
  const auto [low, high] = weights.range();
  const double largest = std::max(-low, high);
  const int exponent = largest > 0.0 ? std::ilogb(largest) : 0;
  if (exponent > -kNear && !(exponent > kNear && is_even())) return;
  for (double& w : weights.values) w = std::scalbn(w, -exponent);
  for (glm::dvec4& slope : slopes.values) {
    for (int i = 0; i < 4; ++i) slope[i] = std::scalbn(slope[i], -2 * exponent);
  }
}

Speed::Speed(int degree, bool is_rational)
    : rule_{is_rational ? 2 * degree - 2 : degree - 1,
            is_rational ? degree : 0,
            kCount,
            nullptr,
            nullptr,
            kShares.kronrod.data(),
            kShares.differences.data()},
      sizes_(degree + 1) {
  const std::size_t slopes = kCount * (rule_.slopes_degree + 1);
  functions_.resize(slopes + (is_rational ? kCount * sizes_.size() : 0));
  write_functions(rule_.slopes_degree, functions_.data());
  rule_.slope_functions = functions_.data();
  if (!is_rational) return;
  write_functions(degree, functions_.data() + slopes);
  rule_.weight_functions = functions_.data() + slopes;
  products_.reserve(sizes_.size() * degree / 2);
  for (int i = 0; i < degree; ++i) {
    for (int j = i + 1; j <= degree; ++j) {
      products_.push_back((j - i) * (binomial(degree, i) * binomial(degree, j) / binomial(2 * degree - 2, i + j - 1)));
    }
  }
}

void Speed::write(std::span<const glm::dvec4> points, SpeedPiece& out) {
  for (std::size_t i = 0; i < points.size(); ++i) sizes_[i] = size_of(points[i]);
  out.slopes.rows = rule_.slopes_degree + 1;
  out.weights.rows = rule_.weight_degree + 1;
  out.slopes.columns = out.weights.columns = 1;
  out.slopes.values.resize(out.slopes.rows);
  out.weights.values.resize(out.weights.rows);
  if (rule_.weight_degree > 0) {
    write_rational(points, out);
  } else {
    write_plain(points, out);
  }
}

/// N is the sum of (w_i A_j - w_j A_i) (B_i B_j' - B_i' B_j) over i < j, and what multiplies there is a multiple of the
/// Bernstein polynomial i + j - 1.
void Speed::write_rational(std::span<const glm::dvec4> points, SpeedPiece& out) const {
  std::ranges::fill(out.slopes.values, glm::dvec4(0.0));
  std::ranges::transform(points, out.weights.values.begin(), &glm::dvec4::w);
  const double* product = products_.data();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j, ++product) {
      const double before = *product * points[i].w;
      const double behind = *product * points[j].w;
      glm::dvec4& slope = out.slopes.values[i + j - 1];
      slope.x += before * points[j].x - behind * points[i].x;
      slope.y += before * points[j].y - behind * points[i].y;
      slope.z += before * points[j].z - behind * points[i].z;
      slope.w += std::abs(before) * sizes_[j] + std::abs(behind) * sizes_[i];
    }
  }
}

void Speed::write_plain(std::span<const glm::dvec4> points, SpeedPiece& out) const {
  out.weights.values[0] = 1.0;
  const auto degree = static_cast<double>(points.size() - 1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    out.slopes.values[i] = degree * (points[i + 1] - points[i]);
    out.slopes.values[i].w = degree * (sizes_[i + 1] + sizes_[i]);
  }
}

PieceLength Speed::length(const SpeedPiece& piece) const {
  constexpr double kSmall = 0x1p-400;
  const PieceLength found = length(piece.slopes, piece.weights);
  if (!(found.terms < kSmall) || found.terms == 0.0) return found;
  // Squares of what is so short leave the numbers.
  const int exponent = std::ilogb(found.terms);
  BernsteinNet<glm::dvec4> slopes = piece.slopes;
  for (glm::dvec4& slope : slopes.values) {
    for (int i = 0; i < 4; ++i) slope[i] = std::scalbn(slope[i], -exponent);
  }
  const PieceLength large = length(slopes, piece.weights);
  return {std::scalbn(large.value, exponent), std::scalbn(large.error, exponent), std::scalbn(large.terms, exponent)};
}

PieceLength Speed::length(const BernsteinNet<glm::dvec4>& slopes, const BernsteinNet<double>& weights) const {
  std::array<double, 3> sums;
  kernels().speed_sums(rule_, &slopes.values.front().x, weights.values.data(), sums.data());
  return {sums[0], std::abs(sums[1]), sums[2]};
}

}  // namespace splinecore
