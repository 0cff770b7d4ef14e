#include "difference.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>

#include "lines.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

using Points = Net<glm::dvec4>;

double length_of(const glm::dvec4& p) { return std::hypot(p.x, p.y, p.z); }

/// Whether no weight is zero or of the other sign, by more than rounding.
template <class Value, class Weight>
bool has_one_sign(const std::vector<Value>& values, Weight weight) {
  constexpr double kNoise = 0x1p-44;
  const auto [low, high] = std::ranges::minmax(values, {}, weight);
  const double noise = kNoise * std::max(std::abs(std::invoke(weight, low)), std::abs(std::invoke(weight, high)));
  return std::invoke(weight, low) > noise || std::invoke(weight, high) < -noise;
}

/// de Casteljau at the middle of every line along an axis: the first halves stay, the second ones are returned.
template <class Value>
Net<Value> halve(Net<Value>& net, Axis axis) {
  Net<Value> second = net;
  const bool is_u = axis == Axis::u;
  const Lines lines(axis, is_u ? net.columns : net.rows, is_u ? net.rows : net.columns);
  for (std::size_t line = 0; line < lines.count; ++line) {
    for (std::size_t size = lines.size; size > 1; --size) {
      for (std::size_t i = 0; i + 1 < size; ++i) {
        Value& value = second.values[lines.at(line, i)];
        value = 0.5 * value + 0.5 * second.values[lines.at(line, i + 1)];
      }
      net.values[lines.at(line, lines.size - size + 1)] = second.values[lines.at(line, 0)];
    }
  }
  return second;
}

DifferencePiece halve(DifferencePiece& piece, Axis axis) {
  return {halve(piece.points, axis), halve(piece.weights, axis), piece.limit, piece.rounding};
}

/// With the largest weight 1, so that products of weights stay in the range of numbers.
void normalise(Points& net) {
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
    for (int k = 0; k <= p; ++k) {
      // i of the first half and k of the second, out of i + k of 2p.
      double share = 1.0;
      for (int j = 0; j < i; ++j) share *= static_cast<double>(p - j) / (2 * p - j) * (j + 1 + k) / (j + 1);
      for (int j = 0; j < k; ++j) share *= static_cast<double>(p - j) / (2 * p - i - j);
      shares.push_back(share);
    }
  }
  return shares;
}

bool are_weights_equal(const Points& a, const Points& b) {
  return std::ranges::equal(a.values, b.values, {}, &glm::dvec4::w, &glm::dvec4::w);
}

/// A centre from which coordinates are small.
glm::dvec3 centre_of(const Points& net) {
  const auto weight = [](const glm::dvec4& point) { return std::abs(point.w); };
  const glm::dvec4& heaviest = *std::ranges::max_element(net.values, {}, weight);
  return heaviest.w == 0.0 ? glm::dvec3(0.0) : project(heaviest);
}

/// The homogeneous points of A / W - B / W; `size` takes what the terms amount to.
Points plain_difference(const Points& a, const Points& b, double& size) {
  Points result{a.rows, a.columns, a.values};
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    result.values[i] = glm::dvec4(glm::dvec3(a.values[i]) - glm::dvec3(b.values[i]), a.values[i].w);
    size = std::max(size, length_of(a.values[i]) + length_of(b.values[i]));
  }
  return result;
}

/// The homogeneous points (A W_B - B W_A, W_A W_B).
Points rational_difference(const Points& a, const Points& b, double& size) {
  const glm::dvec3 centre = centre_of(a);
  const auto seen = [&](const glm::dvec4& p) { return glm::dvec4(glm::dvec3(p) - p.w * centre, p.w); };
  const auto shares_u = product_shares(a.rows);
  const auto shares_v = product_shares(a.columns);
  Points result{2 * a.rows - 1, 2 * a.columns - 1, {}};
  result.values.assign(result.rows * result.columns, glm::dvec4(0.0));
  std::vector<double> sizes(result.values.size(), 0.0);
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const glm::dvec4 on_a = seen(a.values[i]);
    const double size_a = length_of(a.values[i]);
    const std::size_t row = i / a.columns;
    const std::size_t column = i % a.columns;
    for (std::size_t k = 0; k < b.values.size(); ++k) {
      const glm::dvec4 on_b = seen(b.values[k]);
      const double share = shares_u[row * a.rows + k / a.columns] * shares_v[column * a.columns + k % a.columns];
      const std::size_t at = (row + k / a.columns) * result.columns + column + k % a.columns;
      result.values[at] += share * glm::dvec4(glm::dvec3(on_a) * on_b.w - glm::dvec3(on_b) * on_a.w, on_a.w * on_b.w);
      sizes[at] += share * (size_a * std::abs(on_b.w) + length_of(b.values[k]) * std::abs(on_a.w));
    }
  }
  size = *std::ranges::max_element(sizes);
  return result;
}

DifferencePiece piece_of(Points a, Points b) {
  constexpr double kRounding = 0x1p-48;
  constexpr double kFinite = 0x1p-4;
  normalise(a);
  normalise(b);
  double size = 0.0;
  DifferencePiece piece;
  piece.points = are_weights_equal(a, b) ? plain_difference(a, b, size) : rational_difference(a, b, size);
  piece.weights = {a.rows, a.columns, {}};
  for (std::size_t i = 0; i < a.values.size(); ++i) piece.weights.values.emplace_back(a.values[i].w, b.values[i].w);
  const bool may_vanish = !has_one_sign(a.values, &glm::dvec4::w) && !has_one_sign(b.values, &glm::dvec4::w);
  piece.limit = may_vanish ? kFinite : 0.0;
  piece.rounding = kRounding * size;
  return piece;
}

/// The patch with every knot of either patch along an axis as often as it falls apart there.
NurbsPatch chopped(const NurbsPatch& patch, const NurbsPatch& other, Axis axis) {
  const KnotVector& own = patch.knot_vector(axis);
  std::vector<double> knots;
  std::ranges::merge(own.knots(), other.knot_vector(axis).knots(), std::back_inserter(knots));
  knots.erase(std::ranges::unique(knots).begin(), knots.end());
  std::vector<double> missing;
  for (const double u : knots) missing.insert(missing.end(), missing_for_cut(own, u), u);
  return missing.empty() ? patch : refine(patch, axis, missing);
}

/// The homogeneous points of one piece of a patch that is chopped in both directions.
Points net_of(const NurbsPatch& patch, int span_u, int span_v) {
  const KnotVector& u = patch.knot_vector(Axis::u);
  const KnotVector& v = patch.knot_vector(Axis::v);
  Points net{static_cast<std::size_t>(u.degree()) + 1, static_cast<std::size_t>(v.degree()) + 1, {}};
  for (int i = u.spans()[span_u] - u.degree(); i <= u.spans()[span_u]; ++i) {
    for (int j = v.spans()[span_v] - v.degree(); j <= v.spans()[span_v]; ++j) {
      net.values.push_back(patch.homogeneous_points()[i * v.count() + j]);
    }
  }
  return net;
}

/// Brings both patches to one degree and one set of spans along an axis.
void make_alike(NurbsPatch& a, NurbsPatch& b, Axis axis) {
  a = clamped(a, axis);
  b = clamped(b, axis);
  const int more = a.knot_vector(axis).degree() - b.knot_vector(axis).degree();
  if (more < 0) a = elevated(a, axis, -more);
  if (more > 0) b = elevated(b, axis, more);
  NurbsPatch pieces = chopped(a, b, axis);
  b = chopped(b, a, axis);
  a = std::move(pieces);
}

bool is_small(const glm::dvec2& weights, double limit) {
  return std::abs(weights.x) < limit && std::abs(weights.y) < limit;
}

/// Whether one patch runs to infinity in the piece and the other stays in sight.
bool has_lone_pole(const DifferencePiece& piece) {
  const auto changes_sign = [&](double glm::dvec2::*weight) {
    const auto corners = piece.weights.corners();
    const auto [low, high] = std::ranges::minmax(corners, {}, weight);
    return low.*weight < 0.0 && high.*weight > 0.0;
  };
  const auto stays = [&](double glm::dvec2::*weight) {
    return has_one_sign(piece.weights.values, weight) &&
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
  return std::ranges::all_of(points.values, [&](const auto& p) { return length_of(p) <= rounding; });
}

double DifferencePiece::bound() const {
  if (has_one_sign(points.values, &glm::dvec4::w)) {
    double longest = 0.0;
    for (const glm::dvec4& p : points.values) longest = std::max(longest, length_of(p) / std::abs(p.w));
    return longest;
  }
  // Points that are not left out have no smaller weight where the patches are the same but for rounding.
  return is_rounding() && limit > 0.0 ? rounding / (limit * limit) : HUGE_VAL;
}

double DifferencePiece::known() const {
  if (has_lone_pole(*this)) return HUGE_VAL;
  const auto ends = points.corners();
  const auto end_weights = weights.corners();
  double longest = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (is_small(end_weights[i], limit)) continue;
    longest = std::max(longest, ends[i].w == 0.0 ? HUGE_VAL : length_of(ends[i]) / std::abs(ends[i].w));
  }
  return longest;
}

std::array<DifferencePiece, 4> DifferencePiece::quarters() const {
  DifferencePiece first = *this;
  DifferencePiece second = halve(first, Axis::u);
  DifferencePiece after_first = halve(first, Axis::v);
  DifferencePiece after_second = halve(second, Axis::v);
  return {std::move(first), std::move(after_first), std::move(second), std::move(after_second)};
}

double DifferencePiece::work() const {
  const auto size = static_cast<double>(points.values.size());
  return 4.0 * size * static_cast<double>(points.rows + points.columns) + 200.0;
}

std::vector<DifferencePiece> difference_pieces(NurbsPatch a, NurbsPatch b) {
  make_alike(a, b, Axis::u);
  make_alike(a, b, Axis::v);
  std::vector<DifferencePiece> pieces;
  for (int i = 0; i < static_cast<int>(a.knot_vector(Axis::u).spans().size()); ++i) {
    for (int j = 0; j < static_cast<int>(a.knot_vector(Axis::v).spans().size()); ++j) {
      Points on_a = net_of(a, i, j);
      Points on_b = net_of(b, i, j);
      if (on_a.values != on_b.values) pieces.push_back(piece_of(std::move(on_a), std::move(on_b)));
    }
  }
  return pieces;
}

}  // namespace splinecore
