#include "difference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <queue>
#include <ranges>

#include "base/length.hpp"
#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "base/rounding.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

using Piece = BernsteinNet<glm::dvec4>;

double place_length(const glm::dvec4& p) { return length_of(glm::dvec3(p)); }

/// Whether no weight is zero or of the other sign, by more than rounding.
template <class Value, class Weight>
bool is_of_one_sign(const BernsteinNet<Value>& net, Weight weight) {
  constexpr double kNoise = 0x1p-44;
  const auto [low, high] = net.range(weight);
  return has_one_sign(net.values, weight, kNoise * std::max(std::abs(low), std::abs(high)));
}

/// With the largest weight 1, so that products of weights stay in the range of numbers.
void normalize(Piece& net) {
  double largest = 0.0;
  for (const glm::dvec4& p : net.values) largest = std::max(largest, std::abs(p.w));
  if (largest == 0.0) return;
  for (glm::dvec4& p : net.values) p /= largest;
}

/// C(p, i) C(p, k) / C(2p, i + k), row after row: what coefficients i and k of two factors give to their product.
std::vector<double> product_shares(std::size_t count) {
  const int p = static_cast<int>(count) - 1;
  std::vector<double> shares;
  for (int i = 0; i <= p; ++i) {
    for (int k = 0; k <= p; ++k) shares.push_back(binomial(p, i) * binomial(p, k) / binomial(2 * p, i + k));
  }
  return shares;
}

bool are_weights_equal(const Piece& a, const Piece& b) {
  return std::ranges::equal(a.values, b.values, {}, &glm::dvec4::w, &glm::dvec4::w);
}

/// A center from which coordinates are small.
glm::dvec3 center_of(const Piece& net) {
  const auto weight = [](const glm::dvec4& point) { return std::abs(point.w); };
  const glm::dvec4& heaviest = *std::ranges::max_element(net.values, {}, weight);
  return heaviest.w == 0.0 ? glm::dvec3(0.0) : project(heaviest);
}

/// The homogeneous points of A / W - B / W; `size` takes what the terms amount to.
Piece plain_difference(const Piece& a, const Piece& b, double& size) {
  Piece result{a.rows, a.columns, a.values};
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    result.values[i] = glm::dvec4(glm::dvec3(a.values[i]) - glm::dvec3(b.values[i]), a.values[i].w);
    size = std::max(size, place_length(a.values[i]) + place_length(b.values[i]));
  }
  return result;
}

/// The homogeneous points (A W_B - B W_A, W_A W_B).
Piece rational_difference(const Piece& a, const Piece& b, double& size) {
  const glm::dvec3 center = center_of(a);
  const auto seen = [&](const glm::dvec4& p) { return glm::dvec4(glm::dvec3(p) - p.w * center, p.w); };
  const auto shares_u = product_shares(a.rows);
  const auto shares_v = product_shares(a.columns);
  Piece result{2 * a.rows - 1, 2 * a.columns - 1, {}};
  result.values.assign(result.rows * result.columns, glm::dvec4(0.0));
  std::vector<double> sizes(result.values.size(), 0.0);
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const glm::dvec4 on_a = seen(a.values[i]);
    breathe(32 * b.values.size());
    const double size_a = place_length(a.values[i]);
    const std::size_t row = i / a.columns;
    const std::size_t column = i % a.columns;
    for (std::size_t k = 0; k < b.values.size(); ++k) {
      const glm::dvec4 on_b = seen(b.values[k]);
      const double share = shares_u[row * a.rows + k / a.columns] * shares_v[column * a.columns + k % a.columns];
      const std::size_t at = (row + k / a.columns) * result.columns + column + k % a.columns;
      result.values[at] += share * glm::dvec4(glm::dvec3(on_a) * on_b.w - glm::dvec3(on_b) * on_a.w, on_a.w * on_b.w);
      sizes[at] += share * (size_a * std::abs(on_b.w) + place_length(b.values[k]) * std::abs(on_a.w));
    }
  }
  size = *std::ranges::max_element(sizes);
  return result;
}

bool is_small(const glm::dvec2& weights, double limit) {
  return std::abs(weights.x) < limit && std::abs(weights.y) < limit;
}

/// Whether one of the two runs to infinity in the piece and the other stays in sight.
bool has_lone_pole(const DifferencePiece& piece) {
  const auto changes_sign = [&](double glm::dvec2::*weight) {
    const auto corners = piece.weights.corners();
    const auto [low, high] = std::ranges::minmax(corners, {}, weight);
    return low.*weight < 0.0 && high.*weight > 0.0;
  };
  const auto stays = [&](double glm::dvec2::*weight) {
    return is_of_one_sign(piece.weights, weight) &&
           std::ranges::all_of(piece.weights.values, [&](const auto& w) { return std::abs(w.*weight) >= piece.limit; });
  };
  return (changes_sign(&glm::dvec2::x) && stays(&glm::dvec2::y)) ||
         (changes_sign(&glm::dvec2::y) && stays(&glm::dvec2::x));
}

}  // namespace

bool DifferencePiece::is_left_out() const {
  return std::ranges::all_of(weights.values, [&](const auto& pair) { return is_small(pair, limit); });
}

bool DifferencePiece::is_rounding() const {
  return std::ranges::all_of(points.values, [&](const auto& p) { return place_length(p) <= rounding; });
}

double DifferencePiece::bound() const {
  if (is_of_one_sign(points, &glm::dvec4::w)) {
    double longest = 0.0;
    for (const glm::dvec4& p : points.values) longest = std::max(longest, place_length(p) / std::abs(p.w));
    return longest;
  }
  if (!is_rounding() || !(limit > 0.0)) return HUGE_VAL;
  // Points that are not left out have no smaller weight where both are the same but for rounding.
  const auto lengths = points.values | std::views::transform(place_length);
  return std::ranges::max(lengths) / (limit * limit);
}

double DifferencePiece::known() const {
  if (has_lone_pole(*this)) return HUGE_VAL;
  const auto ends = points.corners();
  const auto end_weights = weights.corners();
  double longest = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (is_small(end_weights[i], limit)) continue;
    longest = std::max(longest, ends[i].w == 0.0 ? HUGE_VAL : place_length(ends[i]) / std::abs(ends[i].w));
  }
  return longest;
}

std::vector<DifferencePiece> DifferencePiece::parts() const {
  std::vector<DifferencePiece> found{*this};
  const auto halve_all = [&](Axis axis) {
    const std::size_t count = found.size();
    for (std::size_t i = 0; i < count; ++i) {
      DifferencePiece& piece = found[i];
      DifferencePiece second{{}, {}, limit, rounding};
      piece.points.halve(axis, second.points);
      piece.weights.halve(axis, second.weights);
      found.push_back(std::move(second));
    }
  };
  if (points.rows > 1) halve_all(Axis::u);
  if (points.columns > 1) halve_all(Axis::v);
  return found;
}

double DifferencePiece::work() const {
  const auto size = static_cast<double>(points.values.size());
  return 4.0 * size * static_cast<double>(points.rows + points.columns) + 200.0;
}

DifferencePiece difference(BernsteinNet<glm::dvec4> a, BernsteinNet<glm::dvec4> b) {
  constexpr double kFinite = 0x1p-4;
  normalize(a);
  normalize(b);
  double size = 0.0;
  DifferencePiece piece;
  piece.points = are_weights_equal(a, b) ? plain_difference(a, b, size) : rational_difference(a, b, size);
  piece.weights = {a.rows, a.columns, {}};
  for (std::size_t i = 0; i < a.values.size(); ++i) piece.weights.values.emplace_back(a.values[i].w, b.values[i].w);
  const bool may_vanish = !is_of_one_sign(a, &glm::dvec4::w) && !is_of_one_sign(b, &glm::dvec4::w);
  piece.limit = may_vanish ? kFinite : 0.0;
  piece.rounding = kRoundingOfSum * size;
  return piece;
}

namespace {

/// The search for the largest length, in the piece first that may have it.
class LengthSearch {
 public:
  explicit LengthSearch(double slack) : slack_(slack) {}

  void add(DifferencePiece piece) {
    if (piece.is_left_out()) return;
    known_ = std::max(known_, piece.known());
    const double bound = piece.bound();
    const bool tells_nothing_new = bound <= slack_ * known_ || piece.is_rounding();
    if (tells_nothing_new && std::isfinite(bound)) {
      settled_ = std::max(settled_, bound);
    } else {
      open_.push({bound, std::move(piece)});
    }
  }

  void run() {
    constexpr double kMaxWork = 1e8;  // multiplications: less than a second, which no shape of modeling needs
    for (double work = 0.0; !is_done() && work < kMaxWork;) {
      const DifferencePiece worst = open_.top().piece;
      open_.pop();
      work += worst.work();
      for (DifferencePiece& part : worst.parts()) add(std::move(part));
    }
  }

  double result() const { return std::max({known_, settled_, open_.empty() ? 0.0 : open_.top().bound}); }

 private:
  struct Open {
    double bound;
    DifferencePiece piece;
    bool operator<(const Open& other) const { return bound < other.bound; }
  };

  bool is_done() const { return open_.empty() || open_.top().bound <= std::max(slack_ * known_, settled_); }

  double slack_;
  double known_ = 0.0;
  double settled_ = 0.0;
  std::priority_queue<Open> open_;
};

}  // namespace

double largest_length(std::vector<DifferencePiece> pieces, double slack) {
  LengthSearch search(slack);
  for (DifferencePiece& piece : pieces) search.add(std::move(piece));
  search.run();
  return search.result();
}

}  // namespace splinecore
