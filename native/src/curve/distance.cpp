#include "splinecore/curve/distance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <queue>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/curve/degree.hpp"

namespace splinecore {

namespace {

using Points = std::vector<glm::dvec4>;

/// The difference of two curves where both are one piece: a rational Bezier curve of its own.
struct Piece {
  Points points;                   ///< homogeneous
  std::vector<glm::dvec2> weights;  ///< of both curves, the largest on their span 1
  double limit;                    ///< points of which both weights are below it are left out
  double rounding;                 ///< of the homogeneous coordinates
  double bound = 0.0;
  bool operator<(const Piece& other) const { return bound < other.bound; }
};

double length_of(const glm::dvec4& p) { return std::hypot(p.x, p.y, p.z); }

/// Whether no weight is zero or of the other sign, by more than rounding.
template <class Range, class Weight>
bool has_one_sign(const Range& points, Weight weight) {
  constexpr double kNoise = 0x1p-44;
  const auto [low, high] = std::ranges::minmax(points, {}, weight);
  const double noise = kNoise * std::max(std::abs(std::invoke(weight, low)), std::abs(std::invoke(weight, high)));
  return std::invoke(weight, low) > noise || std::invoke(weight, high) < -noise;
}

bool is_left_out(const glm::dvec2& weights, double limit) {
  return std::abs(weights.x) < limit && std::abs(weights.y) < limit;
}

bool is_left_out(const Piece& piece) {
  return std::ranges::all_of(piece.weights, [&](const glm::dvec2& pair) { return is_left_out(pair, piece.limit); });
}

/// Whether one curve runs to infinity in the piece and the other stays in sight.
bool has_lone_pole(const Piece& piece) {
  if (!(piece.points.front().w * piece.points.back().w < 0.0)) return false;
  const auto stays = [&](double glm::dvec2::*weight) {
    return has_one_sign(piece.weights, weight) &&
           std::ranges::all_of(piece.weights, [&](const auto& pair) { return std::abs(pair.*weight) >= piece.limit; });
  };
  return stays(&glm::dvec2::x) || stays(&glm::dvec2::y);
}

/// The length up to which the hull of a piece reaches from the origin.
double hull_bound(const Piece& piece) {
  if (!has_one_sign(piece.points, &glm::dvec4::w)) return HUGE_VAL;
  double bound = 0.0;
  for (const glm::dvec4& p : piece.points) bound = std::max(bound, length_of(p) / std::abs(p.w));
  return bound;
}

/// Whether the hull of a piece tells of nothing but rounding.
bool is_settled(const Piece& piece) {
  double least = HUGE_VAL;
  for (const glm::dvec4& p : piece.points) least = std::min(least, std::abs(p.w));
  return piece.bound * std::max(least, piece.limit * piece.limit) <= piece.rounding;
}

/// A distance that is certainly reached.
double known_distance(const Piece& piece) {
  if (has_lone_pole(piece)) return HUGE_VAL;
  const auto at = [&](const glm::dvec4& p, const glm::dvec2& weights) {
    if (is_left_out(weights, piece.limit)) return 0.0;
    return p.w == 0.0 ? HUGE_VAL : length_of(p) / std::abs(p.w);
  };
  return std::max(at(piece.points.front(), piece.weights.front()), at(piece.points.back(), piece.weights.back()));
}

/// de Casteljau at the middle: the left half stays in `row`, the right one is returned.
template <class Point>
std::vector<Point> halve(std::vector<Point>& row) {
  std::vector<Point> left;
  std::vector<Point> right(row.size());
  left.reserve(row.size());
  for (std::size_t size = row.size(); size > 0; --size) {
    left.push_back(row.front());
    right[size - 1] = row[size - 1];
    for (std::size_t i = 0; i + 1 < size; ++i) row[i] = 0.5 * row[i] + 0.5 * row[i + 1];
  }
  row = std::move(left);
  return right;
}

std::pair<Piece, Piece> halved(Piece left) {
  Piece right{halve(left.points), halve(left.weights), left.limit, left.rounding};
  return {std::move(left), std::move(right)};
}

double largest_weight(const Points& points) {
  double largest = 0.0;
  for (const glm::dvec4& p : points) largest = std::max(largest, std::abs(p.w));
  return largest;
}

/// With the largest weight 1, so that products of weights stay in the range of numbers.
void normalise(Points& points) {
  const double scale = largest_weight(points);
  if (scale == 0.0) return;
  for (glm::dvec4& p : points) p /= scale;
}

bool are_weights_equal(const Points& points) {
  return std::ranges::all_of(points, [&](const glm::dvec4& p) { return p.w == points.front().w; });
}

/// C(p, i) C(p, j) / C(2p, i + j): what point i of one factor and j of the other give to a product.
double product_share(int p, int i, int j) {
  double share = 1.0;
  // i + j of 2p without putting back: i from the first half and j from the second.
  for (int k = 0; k < i; ++k) share *= static_cast<double>(p - k) / (2 * p - k) * (k + 1 + j) / (k + 1);
  for (int k = 0; k < j; ++k) share *= static_cast<double>(p - k) / (2 * p - i - k);
  return share;
}

/// (A W_B - B W_A) / (W_A W_B), as homogeneous points; `sizes` takes what the terms amount to.
Points difference(const Points& a, const Points& b, std::vector<double>& sizes) {
  const int p = static_cast<int>(a.size()) - 1;
  const auto weight = [](const glm::dvec4& point) { return std::abs(point.w); };
  const glm::dvec4& heaviest = *std::ranges::max_element(a, {}, weight);
  const glm::dvec3 centre = heaviest.w == 0.0 ? glm::dvec3(0.0) : project(heaviest);
  const auto seen = [&](const glm::dvec4& point) { return glm::dvec3(point) - point.w * centre; };
  if (are_weights_equal(a) && are_weights_equal(b) && a[0].w * b[0].w != 0.0) {
    Points points;
    for (int i = 0; i <= p; ++i) {
      points.emplace_back(seen(a[i]) / a[i].w - seen(b[i]) / b[i].w, 1.0);
      sizes.push_back(length_of(a[i]) / std::abs(a[i].w) + length_of(b[i]) / std::abs(b[i].w));
    }
    return points;
  }
  Points points(2 * p + 1, glm::dvec4(0.0));
  sizes.assign(2 * p + 1, 0.0);
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= p; ++j) {
      const double share = product_share(p, i, j);
      points[i + j] += share * glm::dvec4(seen(a[i]) * b[j].w - seen(b[j]) * a[i].w, a[i].w * b[j].w);
      sizes[i + j] += share * (length_of(a[i]) * std::abs(b[j].w) + length_of(b[j]) * std::abs(a[i].w));
    }
  }
  return points;
}

/// @param a,b  Bezier points of both curves on one span
Piece piece_of(Points a, Points b) {
  constexpr double kRounding = 0x1p-48;
  constexpr double kFinite = 0x1p-4;
  normalise(a);
  normalise(b);
  std::vector<double> sizes;
  Piece piece{difference(a, b, sizes), {}, 0.0, 0.0};
  if (!has_one_sign(a, &glm::dvec4::w) && !has_one_sign(b, &glm::dvec4::w)) piece.limit = kFinite;
  for (std::size_t i = 0; i < a.size(); ++i) piece.weights.emplace_back(a[i].w, b[i].w);
  piece.rounding = kRounding * *std::ranges::max_element(sizes);
  return piece;
}

/// The distinct knots of both curves in the domain, each as often as a curve of this degree lacks it.
NurbsCurve chopped(const NurbsCurve& curve, const NurbsCurve& other) {
  const auto own = curve.knot_vector().knots();
  const Interval domain = curve.domain();
  std::vector<double> knots;
  std::ranges::merge(own, other.knot_vector().knots(), std::back_inserter(knots));
  knots.erase(std::ranges::unique(knots).begin(), knots.end());
  std::vector<double> missing;
  for (const double u : knots) {
    if (u < domain.start || u > domain.end) continue;
    const auto copies = static_cast<long>(std::ranges::equal_range(own, u).size());
    missing.insert(missing.end(), curve.degree() + 1 - copies, u);
  }
  return missing.empty() ? curve : refine(curve, missing);
}

/// Where the curves differ, span by span.
std::vector<Piece> pieces_of(NurbsCurve a, NurbsCurve b) {
  if (a.degree() < b.degree()) a = elevated(a, b.degree() - a.degree());
  if (b.degree() < a.degree()) b = elevated(b, a.degree() - b.degree());
  const int degree = a.degree();
  const NurbsCurve pieces_a = chopped(a, b);
  const NurbsCurve pieces_b = chopped(b, a);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < pieces_a.knot_vector().spans().size(); ++i) {
    const auto take = [&](const NurbsCurve& curve) {
      const auto begin = curve.homogeneous_points().begin() + (curve.knot_vector().spans()[i] - degree);
      return Points(begin, begin + degree + 1);
    };
    Points on_a = take(pieces_a);
    Points on_b = take(pieces_b);
    if (on_a != on_b) pieces.push_back(piece_of(std::move(on_a), std::move(on_b)));
  }
  return pieces;
}

}  // namespace

double largest_distance(const NurbsCurve& a, const NurbsCurve& b) {
  if (a.domain() != b.domain()) throw InvalidShape("the domains differ");
  constexpr double kSlack = 1.01;
  constexpr double kMaxWork = 2e8;  // multiplications: a second, which no curve of modelling needs
  const auto plain = [](const NurbsCurve& curve) { return curve.periodic() ? unrolled(curve) : curve; };
  double certain = 0.0;
  double settled = 0.0;
  std::priority_queue<Piece> open;
  const auto push = [&](Piece piece) {
    if (is_left_out(piece)) return;
    certain = std::max(certain, known_distance(piece));
    piece.bound = hull_bound(piece);
    if (is_settled(piece)) {
      settled = std::max(settled, piece.bound);
    } else {
      open.push(std::move(piece));
    }
  };
  for (Piece& piece : pieces_of(plain(a), plain(b))) push(std::move(piece));
  for (double work = 0.0; !open.empty() && work < kMaxWork;) {
    if (open.top().bound <= kSlack * std::max(certain, settled)) break;
    auto [left, right] = halved(open.top());
    work += 4.0 * static_cast<double>(left.points.size() * left.points.size()) + 100.0;
    open.pop();
    push(std::move(left));
    push(std::move(right));
  }
  const double rest = open.empty() ? 0.0 : open.top().bound;
  return std::max({certain, settled, rest});
}

}  // namespace splinecore
